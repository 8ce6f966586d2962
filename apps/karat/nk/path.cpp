// karat nk path: where tables are looked for, and which file a name means.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "apps/karat/command.h"
#include "apps/karat/json_output.h"
#include "materials/index/index_catalogue.h"
#include "materials/index/index_path.h"

namespace karat {
namespace {

using nlohmann::json;

struct Options {
  std::string name;
  bool as_json = false;
};

const char* origin_of(IndexPathEntry::Kind kind) {
  switch (kind) {
    case IndexPathEntry::Kind::kProject:
      return "Karat's own";
    case IndexPathEntry::Kind::kUser:
      return "yours";
    case IndexPathEntry::Kind::kVariable:
      return "KARAT_NK_PATH";
  }
  return "";
}

int run_file(const Options& options) {
  const std::string file = find_index_table(full_index_name(options.name))->provenance().file;
  if (options.as_json) {
    print_json(json{{"name", options.name}, {"file", file}});
  } else {
    fmt::print("{}\n", file);
  }
  return 0;
}

int run_folders(const Options& options) {
  json folders = json::array();
  for (const IndexPathEntry& entry : index_path()) {
    folders.push_back({{"folder", entry.folder.string()},
                       {"origin", origin_of(entry.kind)},
                       {"exists", entry.exists()}});
  }
  if (options.as_json) {
    print_json(folders);
    return 0;
  }
  for (const json& folder : folders) {
    fmt::print("{:<14} {}{}\n", folder["origin"].get<std::string>(),
               folder["folder"].get<std::string>(),
               folder["exists"].get<bool>() ? "" : "  (does not exist)");
  }
  return 0;
}

class NkPath final : public Command {
 public:
  void add_to(CLI::App& nk, std::function<int()>& action) const override {
    const auto options = std::make_shared<Options>();
    CLI::App* path =
        nk.add_subcommand("path", "The folders of tables, in order; or the file a name means");
    path->add_option("name", options->name,
                     "A table, main/Au/Johnson or short Au/Johnson: its file is printed");
    path->add_flag("--json", options->as_json, "Machine-readable output");
    path->footer("Example: karat nk path main/Au/Johnson");
    path->callback([&action, options] {
      action = [options] {
        return options->name.empty() ? run_folders(*options) : run_file(*options);
      };
    });
  }
};

KARAT_REGISTER(Command, "nk path", NkPath);

}  // namespace
}  // namespace karat
