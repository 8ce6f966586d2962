// Where index tables are looked for, and where the user's own are kept.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace karat {

struct IndexPathEntry {
  enum class Kind { kProject, kUser, kVariable };  // Karat's own, the user's, KARAT_NK_PATH
  std::filesystem::path folder;                    // may not exist
  Kind kind = Kind::kProject;

  bool exists() const;
};

// The folders in the order in which they are asked, as the environment names them now: Karat's own
// data/nk, the user's folder, those in KARAT_NK_PATH (separated by colons).
std::vector<IndexPathEntry> index_path();

// $XDG_DATA_HOME/karat/nk, or ~/.local/share/karat/nk; empty where neither variable is set.
std::filesystem::path user_index_folder();

// The file in the user's folder that a table "shelf/book/page" is kept in, existing or not. Throws
// InputError for names that cannot be kept (not three parts, characters that files cannot have),
// RuntimeError where there is no user's folder.
std::filesystem::path user_index_file(const std::string& name);

// The file that `name` means in the folders of one kind; nothing where they do not know it.
std::optional<std::string> find_index_file(const std::string& name, IndexPathEntry::Kind kind);

}  // namespace karat
