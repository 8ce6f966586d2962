// karat nk list: which index tables there are.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <vector>

#include "apps/karat/command.h"
#include "apps/karat/json_output.h"
#include "materials/index/index_catalogue.h"
#include "materials/index/index_colour.h"
#include "materials/index/index_coverage.h"
#include "materials/index/index_table_file.h"
#include "render/alloy_presets.h"
#include "render/scene_json.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using nlohmann::json;

constexpr std::size_t kMostPresetBytes = std::size_t{1} << 20;

struct Options {
  std::string filter;  // a part of the names wanted
  bool everywhere = false;
  bool alloys = false;
  bool as_json = false;
};

json list_row(const IndexTableEntry& entry, const IndexTable& table) {
  return {{"name", entry.name},
          {"file", entry.file},
          {"range_nm", {table.range().min_nm, table.range().max_nm}},
          {"has_k", table.has_k()},
          {"covers_visible", is_covered(table.range(), kVisible)}};
}

// Whether a file that is no table is a good one of the other kind: the database has some of k
// alone.
bool has_k_alone(const std::string& file) {
  std::vector<IndexBlock> blocks;
  try {
    load_index_table_file(file, file, blocks);
  } catch (const InputError&) {
    return !blocks.empty() && std::all_of(blocks.begin(), blocks.end(), [](const IndexBlock& one) {
      return one.type == "tabulated k";
    });
  }
  return false;
}

// A bad table is named on stderr and does not hide the others; the exit code tells.
int run_list(const Options& options) {
  json rows = json::array();
  int exit_code = 0, of_k_alone = 0;
  for (const IndexTableEntry& entry : list_index_tables(options.everywhere)) {
    if (entry.name.find(options.filter) == std::string::npos) continue;
    try {
      rows.push_back(list_row(entry, *find_index_table(entry.name)));
    } catch (const InputError& error) {
      if (has_k_alone(entry.file)) {
        ++of_k_alone;
        continue;
      }
      fmt::print(stderr, "karat: {}\n", error.what());
      exit_code = 3;
    }
  }
  if (of_k_alone > 0) {
    fmt::print(stderr, "karat: {} of k alone, no materials: karat nk search --kind k\n",
               of_k_alone);
  }
  if (options.as_json) {
    print_json(rows);
    return exit_code;
  }
  if (rows.empty()) {
    fmt::print(stderr,
               "karat: no index table has \"{}\" in its name; for names of materials and authors: "
               "karat nk search {}\n",
               options.filter, options.filter);
    return exit_code;
  }
  std::size_t width = 4;
  for (const json& row : rows) width = std::max(width, row["name"].get<std::string>().size());
  fmt::print("{:<{}}  {:>11}  {:>11}  {:<4}  {}\n", "name", width, "from nm", "to nm", "",
             "visible");
  for (const json& row : rows) {
    fmt::print("{:<{}}  {:>11.6g}  {:>11.6g}  {:<4}  {}\n", row["name"].get<std::string>(), width,
               row["range_nm"][0].get<double>(), row["range_nm"][1].get<double>(),
               row["has_k"].get<bool>() ? "n, k" : "n",
               row["covers_visible"].get<bool>() ? "yes" : "no");
  }
  return exit_code;
}

// The presets that scenes and other commands take by name. A bad one does not hide the others.
int run_alloys(const Options& options) {
  json rows = json::array();
  int exit_code = 0;
  for (const AlloyPreset& preset : alloy_presets()) {
    if (preset.name.find(options.filter) == std::string::npos) continue;
    try {
      const json file = parse_json(read_text_file(preset.file, kMostPresetBytes), preset.file);
      rows.push_back(
          {{"name", preset.name},
           {"file", preset.file},
           {"origin", preset.own ? "Karat's own" : "yours"},
           {"description", JsonValue(file, preset.file).member("description").string()}});
    } catch (const InputError& error) {
      fmt::print(stderr, "karat: {}\n", error.what());
      exit_code = 3;
    }
  }
  if (options.as_json) {
    print_json(rows);
    return exit_code;
  }
  if (rows.empty()) {
    fmt::print(stderr, "karat: no alloy has \"{}\" in its name; yours lie in {}\n", options.filter,
               user_alloy_folder().string());
  }
  std::size_t width = 0;
  for (const json& row : rows) width = std::max(width, row["name"].get<std::string>().size());
  for (const json& row : rows) {
    fmt::print("alloy:{:<{}}  {:<11}  {}\n", row["name"].get<std::string>(), width,
               row["origin"].get<std::string>(), row["description"].get<std::string>());
  }
  return exit_code;
}

class NkList final : public Command {
 public:
  void add_to(CLI::App& nk, std::function<int()>& action) const override {
    const auto options = std::make_shared<Options>();
    CLI::App* list = nk.add_subcommand("list", "The tables that can be named, with their ranges");
    list->add_option("filter", options->filter, "Only names that contain this text");
    list->add_flag("--all", options->everywhere, "The folders in KARAT_NK_PATH too");
    list->add_flag("--alloys", options->alloys, "The presets of alloys instead, with your own");
    list->add_flag("--json", options->as_json, "Machine-readable output");
    list->footer("Example: karat nk list Au");
    list->callback([&action, options] {
      action = [options] { return options->alloys ? run_alloys(*options) : run_list(*options); };
    });
  }
};

KARAT_REGISTER(Command, "nk list", NkList);

}  // namespace
}  // namespace karat
