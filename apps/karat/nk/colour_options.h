// Options that the commands about colours of index tables share.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "materials/index/index_colour.h"

namespace karat {

struct ColourOptions {
  std::string illuminant = "D65";
  std::string observer = "cie1931";
  double angle_deg = 0.0;
  bool clamp = false;

  ColourConditions conditions() const;
  // "illuminant D65, observer cie1931, 0 degrees"
  std::string text() const;
};

// --illuminant, --observer, --angle and --extrapolate. `options` must outlive `command`.
void add_colour_options(CLI::App& command, ColourOptions& options);

// illuminant, observer, angle_deg, and the colour as XYZ, Lab, linear_srgb, srgb (encoded and cut
// to [0, 1]) and srgb_hex.
nlohmann::json colour_json(const IndexColour& colour, const ColourOptions& options);

}  // namespace karat
