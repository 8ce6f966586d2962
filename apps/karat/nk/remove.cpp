// karat nk remove: deletes a table of the user's own.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "apps/karat/command.h"
#include "materials/index/index_folder.h"
#include "materials/index/index_path.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

namespace fs = std::filesystem;
using Kind = IndexPathEntry::Kind;

[[noreturn]] void not_yours(const std::string& name, const fs::path& folder) {
  const std::string place = "; only tables in " + folder.string() + " can be removed";
  if (find_index_file(name, Kind::kProject)) {
    throw InputError(fmt::format("\"{}\" is one of Karat's own tables{}", name, place));
  }
  if (const auto file = find_index_file(name, Kind::kVariable)) {
    throw InputError(fmt::format("\"{}\" is in KARAT_NK_PATH ({}){}", name, *file, place));
  }
  std::vector<std::string> names;
  for (const auto& [known, file] : IndexFolder(folder).list()) names.push_back(known);
  throw InputError(names.empty()
                       ? fmt::format("there are no tables of your own in {}", folder.string())
                       : unknown_name_message("table of your own", name, names));
}

// Folders that the table leaves empty go with it, up to the user's own.
void remove_empty_parents(fs::path folder, const fs::path& root) {
  std::error_code error;
  while (folder != root && folder.has_relative_path() && fs::is_empty(folder, error) && !error) {
    fs::remove(folder, error);
    if (error) return;
    folder = folder.parent_path();
  }
}

int run_remove(const std::string& name) {
  const fs::path folder = user_index_folder();
  const auto file = find_index_file(name, Kind::kUser);
  if (!file) not_yours(name, folder);
  std::error_code error;
  if (!fs::remove(*file, error) || error) {
    throw RuntimeError(fmt::format("cannot remove {}: {}", *file, error.message()));
  }
  remove_empty_parents(fs::path(*file).parent_path(), IndexFolder(folder).root());
  fmt::print("removed {}\n", *file);
  return 0;
}

class NkRemove final : public Command {
 public:
  void add_to(CLI::App& nk, std::function<int()>& action) const override {
    const auto name = std::make_shared<std::string>();
    CLI::App* remove = nk.add_subcommand("remove", "Delete a table of your own");
    remove->add_option("name", *name, "Id (my/gold/film), or path below your folder")->required();
    remove->footer("Example: karat nk remove my/gold/film");
    remove->callback([&action, name] { action = [name] { return run_remove(*name); }; });
  }
};

KARAT_REGISTER(Command, "nk remove", NkRemove);

}  // namespace
}  // namespace karat
