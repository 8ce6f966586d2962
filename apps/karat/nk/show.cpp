// karat nk show: what one index table says, and what colour it is.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <vector>

#include "apps/karat/command.h"
#include "apps/karat/json_output.h"
#include "apps/karat/nk/index_argument.h"
#include "apps/karat/number_list.h"
#include "apps/karat/swatch.h"
#include "materials/index/index_colour.h"
#include "materials/index/index_coverage.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using nlohmann::json;

struct Options {
  std::string name;
  std::vector<double> wavelengths_nm;
  bool as_json = false;
};

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
  if (!covers_wavelength(table, nm)) return value;
  try {
    const ComplexIndex index = table.at(nm);
    value["n"] = index.n;
    if (table.has_k()) value["k"] = index.k;
    value["f0"] = normal_reflectance(index);
  } catch (const InputError&) {
  }
  return value;
}

json table_json(const IndexTable& table, const std::vector<double>& wavelengths_nm) {
  const Provenance& source = table.provenance();
  json result = {{"name", source.name},
                 {"file", source.file},
                 {"reference", source.reference},
                 {"comments", source.comments},
                 {"conditions", source.conditions},
                 {"range_nm", {table.range().min_nm, table.range().max_nm}},
                 {"has_k", table.has_k()},
                 {"covers_visible", is_covered(table.range(), kVisible)},
                 {"values", json::array()},
                 {"f0_xyz", nullptr},
                 {"f0_linear_srgb", nullptr},
                 {"f0_srgb_hex", nullptr},
                 {"warnings", table.warnings()}};
  for (const double nm : wavelengths_nm) result["values"].push_back(value_json(table, nm));
  if (const auto xyz = normal_colour(table)) {
    const Rgb rgb = linear_srgb_of_xyz(*xyz);
    result["f0_xyz"] = *xyz;
    result["f0_linear_srgb"] = rgb;
    result["f0_srgb_hex"] = display_hex(rgb);
  }
  return result;
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
  const IndexTablePtr table = index_of_argument(options.name);
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

class NkShow final : public Command {
 public:
  void add_to(CLI::App& nk, std::function<int()>& action) const override {
    const auto options = std::make_shared<Options>();
    CLI::App* show = nk.add_subcommand("show", "Source, range, values and colour of one table");
    show->add_option("name", options->name, index_argument_help())->required();
    add_number_list(*show, "--nm", options->wavelengths_nm,
                    "Wavelengths in nm: 400,550:600:10 is 400, 550, 560, ..., 600", 1e-3, 1e15);
    show->add_flag("--json", options->as_json, "Machine-readable output");
    show->footer("Example: karat nk show main/Au/Johnson --nm 450,550,650");
    show->callback([&action, options] { action = [options] { return run_show(*options); }; });
  }
};

KARAT_REGISTER(Command, "nk show", NkShow);

}  // namespace
}  // namespace karat
