// karat nk compare: the tables of one material side by side.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <set>

#include "apps/karat/command.h"
#include "apps/karat/json_output.h"
#include "apps/karat/nk/colour_options.h"
#include "apps/karat/nk/compare_picture.h"
#include "apps/karat/nk/index_argument.h"
#include "apps/karat/number_list.h"
#include "apps/karat/picture_check.h"
#include "apps/karat/swatch.h"
#include "materials/index/index_catalogue.h"
#include "materials/index/index_compare.h"
#include "materials/index/index_coverage.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using nlohmann::json;

struct Options {
  std::vector<std::string> materials;
  std::vector<double> wavelengths_nm;
  ColourOptions colour;
  std::string picture;
  bool models = false;
  bool as_json = false;
};

constexpr double kModelAngles[]{45.0, 60.0, 75.0, 85.0};

// Every table that one of the words means, once each. A file that is no table is left out with a
// note: it hides none of the others.
std::vector<IndexTablePtr> tables_of(const std::vector<std::string>& materials) {
  std::vector<IndexTablePtr> tables;
  std::set<std::string> seen;
  for (const std::string& material : materials) {
    if (is_made_index(material)) {
      if (seen.insert(material).second) tables.push_back(index_of_argument(material));
      continue;
    }
    for (const std::string& name : matching_index_names(material)) {
      if (!seen.insert(name).second) continue;
      try {
        tables.push_back(find_index_table(name));
      } catch (const InputError& error) {
        fmt::print(stderr, "karat: {} is left out: {}\n", name, error.what());
      }
    }
  }
  if (tables.empty()) throw InputError("none of these files is an index table");
  return tables;
}

json f0_json(const IndexTable& table, const std::vector<double>& wavelengths_nm) {
  json values = json::array();
  for (const double nm : wavelengths_nm) {
    const bool known = covers_wavelength(table, nm);
    values.push_back(known ? json(normal_reflectance(table.at(nm))) : json());
  }
  return values;
}

json table_json(const ComparedTable& compared, const Options& options) {
  const IndexTable& table = *compared.table;
  json row = {{"name", table.provenance().name},
              {"file", table.provenance().file},
              {"range_nm", {table.range().min_nm, table.range().max_nm}},
              {"covers_visible", is_covered(table.range(), kVisible)},
              {"has_k", table.has_k()},
              {"f0", f0_json(table, options.wavelengths_nm)},
              {"problem", compared.problem}};
  if (compared.colour) row.update(colour_json(*compared.colour, options.colour));
  return row;
}

json models_json(const IndexTable& table, const Options& options) {
  const std::vector<double> angles(std::begin(kModelAngles), std::end(kModelAngles));
  json result = {{"table", table.provenance().name}, {"angle_deg", angles}};
  for (const auto& model : model_differences(table, options.colour.conditions(), angles))
    result["ciede2000"][model.model] = model.ciede2000;
  return result;
}

json comparison_json(const IndexComparison& comparison, const Options& options) {
  const auto& tables = comparison.tables();
  json result = {{"materials", options.materials},
                 {"wavelength_nm", options.wavelengths_nm},
                 {"tables", json::array()},
                 {"ciede2000", json::array()},
                 {"summary", nullptr}};
  for (std::size_t i = 0; i < tables.size(); ++i) {
    result["tables"].push_back(table_json(tables[i], options));
    json row = json::array();
    for (std::size_t j = 0; j < tables.size(); ++j) {
      const auto difference = comparison.difference(i, j);
      row.push_back(difference ? json(*difference) : json());
    }
    result["ciede2000"].push_back(row);
  }
  if (const auto summary = comparison.summary()) {
    const auto name = [&](std::size_t i) { return tables[i].table->provenance().name; };
    if (options.models) result["models"] = models_json(*tables[summary->typical].table, options);
    result["summary"] = {{"pairs", summary->pairs},
                         {"median", summary->median},
                         {"largest", summary->largest},
                         {"largest_between", {name(summary->largest_i), name(summary->largest_j)}},
                         {"typical", name(summary->typical)},
                         {"typical_mean", summary->typical_mean}};
  }
  return result;
}

void print_tables(const json& result, const Options& options) {
  std::size_t width = 4;
  for (const json& row : result["tables"])
    width = std::max(width, row["name"].get<std::string>().size());
  fmt::print("{}\n{:>3}  {:<{}}  {:>8} {:>8}", options.colour.text(), "", "name", width, "from nm",
             "to nm");
  for (const double nm : options.wavelengths_nm) fmt::print("  {:>8}", fmt::format("F0 {:g}", nm));
  fmt::print("       Y  sRGB\n");
  int number = 0;
  for (const json& row : result["tables"]) {
    fmt::print("{:>3}  {:<{}}  {:>8.6g} {:>8.6g}", ++number, row["name"].get<std::string>(), width,
               row["range_nm"][0].get<double>(), row["range_nm"][1].get<double>());
    for (const json& value : row["f0"])
      fmt::print("  {:>8}", value.is_null() ? "-" : fmt::format("{:.4f}", value.get<double>()));
    if (row.contains("XYZ")) {
      fmt::print("  {:6.4f}  {}{}\n", row["XYZ"][1].get<double>(),
                 row["srgb_hex"].get<std::string>(), swatch(row["linear_srgb"].get<Rgb>()));
    } else {
      fmt::print("       -  no colour: {}\n", row["covers_visible"].get<bool>()
                                                  ? "negative n or k"
                                                  : "380 to 780 nm not covered");
    }
  }
}

// The lower triangle, in blocks of columns that fit a page.
void print_differences(const IndexComparison& comparison) {
  constexpr std::size_t kColumns = 16;
  std::vector<std::size_t> coloured;
  for (std::size_t i = 0; i < comparison.tables().size(); ++i) {
    if (comparison.tables()[i].colour) coloured.push_back(i);
  }
  for (std::size_t first = 0; first + 1 < coloured.size(); first += kColumns) {
    const std::size_t last = std::min(first + kColumns, coloured.size() - 1);
    fmt::print("\nCIEDE2000\n{:>5}", "");
    for (std::size_t c = first; c < last; ++c) fmt::print("{:>6}", coloured[c] + 1);
    fmt::print("\n");
    for (std::size_t r = first + 1; r < coloured.size(); ++r) {
      fmt::print("{:>5}", coloured[r] + 1);
      for (std::size_t c = first; c < std::min(last, r); ++c)
        fmt::print("{:>6.2f}", *comparison.difference(coloured[r], coloured[c]));
      fmt::print("\n");
    }
  }
}

void print_summary(const json& summary) {
  if (summary.is_null()) return;
  fmt::print(
      "\n{} pairs: median {:.2f}, largest {:.2f} ({} and {})\nmost typical: {}, on average "
      "{:.2f} from the others\n",
      summary["pairs"].get<int>(), summary["median"].get<double>(),
      summary["largest"].get<double>(), summary["largest_between"][0].get<std::string>(),
      summary["largest_between"][1].get<std::string>(), summary["typical"].get<std::string>(),
      summary["typical_mean"].get<double>());
}

void print_models(const json& models) {
  fmt::print("\nFresnel models against the exact equations, CIEDE2000 for {}\n{:<24}",
             models["table"].get<std::string>(), "");
  for (const double angle : kModelAngles) fmt::print("{:>6g}\u00b0", angle);
  fmt::print("\n");
  for (const auto& [name, differences] : models["ciede2000"].items()) {
    fmt::print("{:<24}", name);
    for (const json& difference : differences) fmt::print("{:>7.2f}", difference.get<double>());
    fmt::print("\n");
  }
}

std::string range_text(WavelengthRange range) {
  return fmt::format("{:.6g} to {:.6g} nm", range.min_nm, range.max_nm);
}

// "main/Au/" where all names begin so: the patches need not say it again.
std::string common_folder(const IndexComparison& comparison) {
  std::string folder = comparison.tables().front().table->provenance().name;
  folder.erase(folder.rfind('/') + 1);
  for (const ComparedTable& compared : comparison.tables()) {
    if (!compared.table->provenance().name.starts_with(folder)) return "";
  }
  return folder;
}

void write_picture(const IndexComparison& comparison, const Options& options) {
  const auto summary = comparison.summary();
  const std::string folder = common_folder(comparison);
  std::vector<Swatch> swatches;
  for (std::size_t i = 0; i < comparison.tables().size(); ++i) {
    const ComparedTable& compared = comparison.tables()[i];
    Swatch swatch{compared.colour.has_value(),
                  {},
                  compared.table->provenance().name.substr(folder.size()),
                  {}};
    if (compared.colour) {
      swatch.linear_srgb = compared.colour->linear_srgb;
      swatch.lines.push_back(fmt::format("Y {:.3f}", compared.colour->xyz[1]));
      if (summary)
        swatch.lines.back() +=
            fmt::format(", \u0394E {:.1f}", *comparison.difference(i, summary->typical));
    }
    if (!is_covered(compared.table->range(), kVisible))
      swatch.lines.push_back((compared.colour ? "measured " : "") +
                             range_text(compared.table->range()));
    swatches.push_back(std::move(swatch));
  }
  std::stable_partition(swatches.begin(), swatches.end(),
                        [](const Swatch& swatch) { return swatch.has_colour; });
  std::string small_print = options.colour.text();
  if (summary)
    small_print += fmt::format("; Y luminance, \u0394E CIEDE2000 from {}",
                               comparison.tables()[summary->typical].table->provenance().name);
  write_swatches(options.picture,
                 fmt::format("{}: {} tables", fmt::join(options.materials, ", "), swatches.size()),
                 small_print, swatches);
}

int run_compare(const Options& options) {
  const IndexComparison comparison(tables_of(options.materials), options.colour.conditions());
  const json result = comparison_json(comparison, options);
  if (!options.picture.empty()) write_picture(comparison, options);
  if (options.as_json) {
    print_json(result);
    return 0;
  }
  print_tables(result, options);
  print_differences(comparison);
  print_summary(result["summary"]);
  if (result.contains("models")) print_models(result["models"]);
  return 0;
}

class NkCompare final : public Command {
 public:
  void add_to(CLI::App& nk, std::function<int()>& action) const override {
    const auto options = std::make_shared<Options>();
    CLI::App* compare = nk.add_subcommand("compare", "All tables of a material side by side");
    compare
        ->add_option("material", options->materials,
                     "Au, main/Au, gold, Au/Olmon, Johnson, names of single tables, alloy:NAME")
        ->required();
    add_number_list(*compare, "--nm", options->wavelengths_nm,
                    "Wavelengths of the reflectances F0, in nm (450,550,650)", 1e-3, 1e15);
    add_colour_options(*compare, options->colour);
    compare->add_option("-o,--output", options->picture, "A picture of the colours: .png or .svg")
        ->check(picture_check);
    compare->add_flag("--models", options->models,
                      "Also how far each Fresnel model is from the exact one for the most typical "
                      "table, at 45, 60, 75 and 85 degrees");
    compare->add_flag("--json", options->as_json, "Machine-readable output");
    compare->footer(
        "Ranges, reflectances, colours, and the colour difference CIEDE2000 between each pair; "
        "about\n"
        "1 is the least that is seen side by side. Tables that do not cover 380 to 780 nm have no\n"
        "colour unless --extrapolate clamp holds their end values.\n"
        "Example: karat nk compare Au --illuminant D65 -o gold.png");
    compare->callback([&action, options] {
      if (options->wavelengths_nm.empty()) options->wavelengths_nm = {450.0, 550.0, 650.0};
      action = [options] { return run_compare(*options); };
    });
  }
};

KARAT_REGISTER(Command, "nk compare", NkCompare);

}  // namespace
}  // namespace karat
