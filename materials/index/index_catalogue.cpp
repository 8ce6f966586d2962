#include "materials/index/index_catalogue.h"

#include <algorithm>
#include <filesystem>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "materials/index/index_folder.h"
#include "materials/index/index_names.h"
#include "materials/index/index_path.h"
#include "materials/index/index_table_file.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

namespace fs = std::filesystem;

// The folders as the environment names them now, and what was loaded from them.
class Library {
 public:
  Library() {
    for (const IndexPathEntry& entry : index_path()) {
      if (!entry.exists()) continue;
      folders_.emplace_back(entry.folder);
      own_ += entry.kind != IndexPathEntry::Kind::kVariable;
    }
  }

  IndexTablePtr find(const std::string& name) {
    const std::scoped_lock lock(mutex_);
    IndexTablePtr& table = tables_[name];
    if (!table) table = load_index_table_file(file_of(name), name);
    return table;
  }

  std::vector<IndexTableEntry> list(bool everywhere) const {
    std::map<std::string, std::string> all;
    std::size_t count = everywhere ? folders_.size() : own_;
    for (const IndexFolder& folder : folders_) {
      if (count-- == 0) break;
      all.merge(folder.list());
    }
    std::vector<IndexTableEntry> entries;
    for (auto& [name, file] : all) entries.push_back({name, file});
    return entries;
  }

  std::string full_name(const std::string& typed) const {
    if (known_file(typed)) return typed;
    const MatchingNames found = matching_names(typed, titled_names());
    if (found.match == NameMatch::kNone) throw InputError(unknown(typed));
    if (found.match == NameMatch::kParts && found.names.size() == 1) return found.names.front();
    throw InputError(several(typed, found.names));
  }

  std::vector<std::string> matching(const std::string& typed) const {
    if (known_file(typed)) return {typed};
    MatchingNames found = matching_names(typed, titled_names());
    if (found.names.empty()) throw InputError(unknown(typed));
    return std::move(found.names);
  }

 private:
  std::optional<std::string> known_file(const std::string& name) const {
    for (const IndexFolder& folder : folders_) {
      if (auto file = folder.find(name)) return file;
    }
    std::error_code ignored;
    if (fs::is_regular_file(name, ignored)) return name;
    return std::nullopt;
  }

  std::string file_of(const std::string& name) const {
    if (auto file = known_file(name)) return *file;
    throw InputError(unknown(name));
  }

  // Listed tables; with `ids` the catalogues' further names of them too.
  std::vector<TitledName> titled_names(bool ids = false) const {
    std::map<std::string, std::string> title_of_book;
    std::set<std::string> all;
    for (const IndexTableEntry& entry : list(true)) all.insert(entry.name);
    for (const IndexFolder& folder : folders_) {
      const auto& books = folder.catalogue_file().books;
      title_of_book.insert(books.begin(), books.end());
      for (const std::string& id : folder.catalogue_ids()) {
        if (ids) all.insert(id);
      }
    }
    std::vector<TitledName> names;
    for (const std::string& name : all) {
      const auto title = title_of_book.find(name.substr(0, name.rfind('/')));
      names.push_back({name, title == title_of_book.end() ? "" : title->second});
    }
    return names;
  }

  static std::string several(const std::string& typed, const std::vector<std::string>& names) {
    constexpr std::size_t kMostListed = 40;
    std::string text = names.size() == 1
                           ? "\"" + typed + "\" is not a table's name; did you mean this one?"
                           : "\"" + typed + "\" may be any of " + std::to_string(names.size()) +
                                 " index tables; give one by its name:";
    for (std::size_t i = 0; i < std::min(names.size(), kMostListed); ++i) text += "\n  " + names[i];
    if (names.size() > kMostListed)
      text += "\n  and " + std::to_string(names.size() - kMostListed) + " more";
    return text + "\n\"karat nk search " + typed + "\" tells their ranges, \"karat nk compare " +
           typed + "\" their colours.";
  }

  // A slip in KARAT_NK_PATH is why a table is not found.
  static std::string missing_folders() {
    std::string text;
    for (const IndexPathEntry& entry : index_path()) {
      if (entry.kind != IndexPathEntry::Kind::kVariable || entry.exists()) continue;
      text += (text.empty() ? " In KARAT_NK_PATH, but not there: " : ", ") + entry.folder.string();
    }
    return text.empty() ? text : text + ".";
  }

  std::string unknown(const std::string& name) const {
    std::string looked;
    for (const IndexFolder& folder : folders_)
      looked += (looked.empty() ? "" : ", ") + folder.path().string();
    const std::string hint = name_hint(name, titled_names(true));
    return "unknown index table \"" + name + "\"" + (hint.empty() ? "." : "; " + hint) +
           " Looked in " + looked +
           "; \"karat nk list\" shows what there is, KARAT_NK_PATH adds folders." +
           missing_folders();
  }

  std::list<IndexFolder> folders_;
  std::size_t own_ = 0;
  std::mutex mutex_;
  std::map<std::string, IndexTablePtr> tables_;
};

// One library per state of the environment: a program that changes KARAT_NK_PATH (the tests do)
// sees the change, everybody else shares one.
Library& library() {
  static std::mutex mutex;
  static std::map<std::string, std::unique_ptr<Library>> libraries;
  const std::scoped_lock lock(mutex);
  std::string key;
  for (const IndexPathEntry& entry : index_path()) key += entry.folder.string() + '\n';
  auto& entry = libraries[key];
  if (!entry) entry = std::make_unique<Library>();
  return *entry;
}

}  // namespace

IndexTablePtr find_index_table(const std::string& name) { return library().find(name); }

std::vector<IndexTableEntry> list_index_tables(bool everywhere) {
  return library().list(everywhere);
}

std::string full_index_name(const std::string& typed) { return library().full_name(typed); }

std::vector<std::string> matching_index_names(const std::string& typed) {
  return library().matching(typed);
}

}  // namespace karat
