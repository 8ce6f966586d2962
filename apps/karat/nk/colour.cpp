// karat nk colour: the colours of index tables under a light, at an angle.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <vector>

#include "apps/karat/command.h"
#include "apps/karat/json_output.h"
#include "apps/karat/nk/colour_options.h"
#include "apps/karat/nk/index_argument.h"
#include "apps/karat/swatch.h"
#include "materials/index/index_coverage.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using nlohmann::json;

struct Options {
  std::vector<std::string> names;
  ColourOptions colour;
  bool as_json = false;
};

// A made or measured table's colour; what leaves its range says how to hold its ends.
IndexColour colour_of(const IndexTable& table, const ColourOptions& options) {
  if (options.clamp || is_covered(table.range(), kVisible)) {
    return index_colour(table, options.conditions());
  }
  try {
    return index_colour(table, options.conditions());
  } catch (const InputError& error) {
    throw InputError(std::string(error.what()) + "; --extrapolate clamp holds its end values");
  }
}

json row_of(const std::string& typed, const Options& options) {
  const IndexTablePtr table = index_of_argument(typed);
  json row = {{"name", table->provenance().name},
              {"file", table->provenance().file},
              {"range_nm", {table->range().min_nm, table->range().max_nm}},
              {"covers_visible", is_covered(table->range(), kVisible)}};
  row.update(colour_json(colour_of(*table, options.colour), options.colour));
  return row;
}

void print_rows(const std::vector<json>& rows, const Options& options) {
  std::size_t width = 4;
  for (const json& row : rows) width = std::max(width, row["name"].get<std::string>().size());
  fmt::print("{}\n{:<{}}  {:^26}  {:^23}  {:^26}  {:<7}\n", options.colour.text(), "", width, "XYZ",
             "CIELAB", "linear sRGB", "sRGB");
  for (const json& row : rows) {
    const Xyz xyz = row["XYZ"];
    const Lab lab = row["Lab"];
    const Rgb rgb = row["linear_srgb"];
    fmt::print(
        "{:<{}}  {:8.5f} {:8.5f} {:8.5f}  {:7.3f} {:7.3f} {:7.3f}  {:8.5f} {:8.5f} {:8.5f}  {}{}",
        row["name"].get<std::string>(), width, xyz[0], xyz[1], xyz[2], lab[0], lab[1], lab[2],
        rgb[0], rgb[1], rgb[2], row["srgb_hex"].get<std::string>(), swatch(rgb));
    fmt::print("{}\n", row["covers_visible"].get<bool>()
                           ? ""
                           : fmt::format("  measured from {:.6g} to {:.6g} nm alone",
                                         row["range_nm"][0].get<double>(),
                                         row["range_nm"][1].get<double>()));
  }
}

int run_colour(const Options& options) {
  std::vector<json> rows;
  for (const std::string& name : options.names) rows.push_back(row_of(name, options));
  if (!options.as_json) {
    print_rows(rows, options);
  } else if (rows.size() == 1) {
    print_json(rows.front());
  } else {
    print_json(json(rows));
  }
  return 0;
}

class NkColour final : public Command {
 public:
  void add_to(CLI::App& nk, std::function<int()>& action) const override {
    const auto options = std::make_shared<Options>();
    CLI::App* colour = nk.add_subcommand("colour", "Colours of tables under a light, at an angle");
    colour->alias("color");
    colour->add_option("page", options->names, index_argument_help())->required();
    add_colour_options(*colour, options->colour);
    colour->add_flag("--json", options->as_json,
                     "Machine-readable output: XYZ, Lab, linear_srgb, srgb; one object for one "
                     "page, a list for several");
    colour->footer(
        "Unpolarised light on a smooth surface in air, by the exact Fresnel equations. XYZ is "
        "summed\n"
        "at every nm, Y = 1 for the perfect reflector; CIELAB is against the light's white; sRGB "
        "is\n"
        "adapted from that white to D65 (Bradford). Linear sRGB may exceed 1: gold's red does.\n"
        "Example: karat nk colour main/Au/Johnson main/Ag/Johnson --illuminant A --angle 60");
    colour->callback([&action, options] { action = [options] { return run_colour(*options); }; });
  }
};

KARAT_REGISTER(Command, "nk colour", NkColour);

}  // namespace
}  // namespace karat
