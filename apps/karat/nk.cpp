// karat nk: which index tables there are, and what one of them says.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "apps/karat/command.h"
#include "apps/karat/number_check.h"
#include "materials/index_catalogue.h"
#include "materials/index_colour.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using nlohmann::json;

struct Options {
  std::string name;  // of the table; for the listing a part of the names wanted
  std::vector<double> wavelengths_nm;
  bool everywhere = false;
  bool as_json = false;
};

void print_json(const json& value) {
  fmt::print("{}\n", value.dump(2, ' ', false, json::error_handler_t::replace));
}

json range_json(WavelengthRange range) { return {range.min_nm, range.max_nm}; }

// --- karat nk list

json list_row(const IndexTableEntry& entry, const IndexTable& table) {
  return {{"name", entry.name},
          {"file", entry.file},
          {"range_nm", range_json(table.range())},
          {"has_k", table.has_k()},
          {"covers_visible", table.range().covers(kVisible)}};
}

// A bad table is named on stderr and does not hide the others; the exit code tells.
int run_list(const Options& options) {
  json rows = json::array();
  int exit_code = 0;
  for (const IndexTableEntry& entry : list_index_tables(options.everywhere)) {
    if (entry.name.find(options.name) == std::string::npos) continue;
    try {
      rows.push_back(list_row(entry, *find_index_table(entry.name)));
    } catch (const InputError& error) {
      fmt::print(stderr, "karat: {}\n", error.what());
      exit_code = 3;
    }
  }
  if (options.as_json) {
    print_json(rows);
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

// --- karat nk show

// Where nothing is asked for: the visible in steps of 50 nm, or nine wavelengths of the range.
std::vector<double> usual_wavelengths(WavelengthRange range) {
  std::vector<double> chosen;
  for (double nm = 400.0; nm <= 750.0; nm += 50.0) {
    if (range.covers({nm, nm})) chosen.push_back(nm);
  }
  if (!chosen.empty()) return chosen;
  const int steps = range.width_nm() > 0.0 ? 8 : 0;
  for (int i = 0; i < steps; ++i) chosen.push_back(range.min_nm + range.width_nm() * i / steps);
  chosen.push_back(range.max_nm);
  return chosen;
}

// n, k and F0 at a wavelength; null outside the range and where the table has no index.
json value_json(const IndexTable& table, double nm) {
  json value = {{"nm", nm}, {"n", nullptr}, {"k", nullptr}, {"f0", nullptr}};
  if (!table.range().covers({nm, nm})) return value;
  try {
    const ComplexIndex index = table.at(nm);
    value["n"] = index.n;
    if (table.has_k()) value["k"] = index.k;
    value["f0"] = normal_reflectance(index);
  } catch (const InputError&) {
  }
  return value;
}

// A display's nearest colour: gold's red lies above 1, where no display can follow.
std::array<int, 3> display_bytes(const Rgb& linear) {
  std::array<int, 3> bytes{};
  for (std::size_t i = 0; i < 3; ++i) {
    bytes[i] = static_cast<int>(std::lround(255.0 * srgb_encode(std::clamp(linear[i], 0.0, 1.0))));
  }
  return bytes;
}

json table_json(const IndexTable& table, const std::vector<double>& wavelengths_nm) {
  const Provenance& source = table.provenance();
  json result = {{"name", source.name},
                 {"file", source.file},
                 {"reference", source.reference},
                 {"comments", source.comments},
                 {"conditions", source.conditions},
                 {"range_nm", range_json(table.range())},
                 {"has_k", table.has_k()},
                 {"covers_visible", table.range().covers(kVisible)},
                 {"values", json::array()},
                 {"f0_xyz", nullptr},
                 {"f0_linear_srgb", nullptr},
                 {"f0_srgb_hex", nullptr},
                 {"warnings", table.warnings()}};
  for (const double nm : wavelengths_nm) result["values"].push_back(value_json(table, nm));
  if (const auto xyz = normal_colour(table)) {
    const Rgb rgb = linear_srgb_of_xyz(*xyz);
    const auto [r, g, b] = display_bytes(rgb);
    result["f0_xyz"] = *xyz;
    result["f0_linear_srgb"] = rgb;
    result["f0_srgb_hex"] = fmt::format("#{:02x}{:02x}{:02x}", r, g, b);
  }
  return result;
}

bool shows_true_colour() {
  const char* colours = std::getenv("COLORTERM");
  const std::string name = colours ? colours : "";
  return isatty(STDOUT_FILENO) != 0 && (name == "truecolor" || name == "24bit") &&
         std::getenv("NO_COLOR") == nullptr;
}

std::string swatch(const Rgb& linear) {
  if (!shows_true_colour()) return "";
  const auto [r, g, b] = display_bytes(linear);
  return fmt::format("  \x1b[48;2;{};{};{}m        \x1b[0m", r, g, b);
}

std::string number_text(const json& value) {
  return value.is_null() ? "-" : fmt::format("{:.6g}", value.get<double>());
}

void print_table(const json& table) {
  for (const char* key : {"name", "file", "reference", "comments", "conditions"}) {
    const std::string text = table[key];
    if (!text.empty()) fmt::print("{:<11} {}\n", key, text);
  }
  fmt::print("{:<11} {:.7g} to {:.7g} nm, {}; {} 380 to 780 nm\n", "range",
             table["range_nm"][0].get<double>(), table["range_nm"][1].get<double>(),
             table["has_k"].get<bool>() ? "n and k" : "n alone",
             table["covers_visible"].get<bool>() ? "covers" : "does not cover");
  if (!table["f0_linear_srgb"].is_null()) {
    const Rgb rgb = table["f0_linear_srgb"];
    fmt::print("{:<11} linear sRGB {:.4f} {:.4f} {:.4f}, {}{}\n", "F0 (D65)", rgb[0], rgb[1],
               rgb[2], table["f0_srgb_hex"].get<std::string>(), swatch(rgb));
  }
  for (const json& warning : table["warnings"]) {
    fmt::print("{:<11} {}\n", "warning", warning.get<std::string>());
  }
  fmt::print("\n{:>11} {:>12} {:>12} {:>12}\n", "nm", "n", "k", "F0");
  for (const json& value : table["values"]) {
    fmt::print("{:>11.7g} {:>12} {:>12} {:>12}\n", value["nm"].get<double>(),
               number_text(value["n"]), number_text(value["k"]), number_text(value["f0"]));
  }
}

int run_show(const Options& options) {
  const IndexTablePtr table = find_index_table(options.name);
  const json facts =
      table_json(*table, options.wavelengths_nm.empty() ? usual_wavelengths(table->range())
                                                        : options.wavelengths_nm);
  if (options.as_json) {
    print_json(facts);
  } else {
    print_table(facts);
  }
  return 0;
}

class NkCommand final : public Command {
 public:
  void add_to(CLI::App& app, std::function<int()>& action) const override {
    CLI::App* nk = app.add_subcommand("nk", "Index tables: list them, show one");
    nk->require_subcommand(1);
    nk->footer("Example: karat nk show main/Au/Johnson");
    add_list(*nk, action);
    add_show(*nk, action);
  }

 private:
  static void add_list(CLI::App& nk, std::function<int()>& action) {
    const auto options = std::make_shared<Options>();
    CLI::App* list = nk.add_subcommand("list", "The tables that can be named, with their ranges");
    list->add_option("filter", options->name, "Only names that contain this text");
    list->add_flag("--all", options->everywhere, "The folders in KARAT_NK_PATH too");
    list->add_flag("--json", options->as_json, "Machine-readable output");
    list->footer("Example: karat nk list Au");
    list->callback([&action, options] { action = [options] { return run_list(*options); }; });
  }
  static void add_show(CLI::App& nk, std::function<int()>& action) {
    const auto options = std::make_shared<Options>();
    CLI::App* show = nk.add_subcommand("show", "Source, range, values and colour of one table");
    show->add_option("name", options->name, "Id (main/Au/Johnson), path below a folder, or file")
        ->required();
    show->add_option("--nm", options->wavelengths_nm, "Wavelengths in nm: 400,550,700")
        ->delimiter(',')
        ->check(number_check(1e-3, 1e9));
    show->add_flag("--json", options->as_json, "Machine-readable output");
    show->footer("Example: karat nk show main/Au/Johnson --nm 450,550,650");
    show->callback([&action, options] { action = [options] { return run_show(*options); }; });
  }
};

KARAT_REGISTER(Command, "nk", NkCommand);

}  // namespace
}  // namespace karat
