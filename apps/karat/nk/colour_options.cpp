#include "apps/karat/nk/colour_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/karat/number_check.h"
#include "apps/karat/swatch.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

CLI::Validator name_check(const std::string& what, std::vector<std::string> (*names)()) {
  return {[=](const std::string& text) -> std::string {
            const auto known = names();
            const bool found = std::find(known.begin(), known.end(), text) != known.end();
            return found ? "" : unknown_name_message(what, text, known);
          },
          "NAME"};
}

}  // namespace

ColourConditions ColourOptions::conditions() const {
  // The cosine of 90 degrees is 0, which rounding would miss.
  const double cosine = angle_deg == 90.0 ? 0.0 : std::cos(angle_deg * std::numbers::pi / 180.0);
  return {illuminant, observer, cosine, "exact", clamp ? RangePolicy::kClamp : RangePolicy::kError};
}

std::string ColourOptions::text() const {
  return fmt::format("illuminant {}, observer {}, {:g} degrees", illuminant, observer, angle_deg);
}

void add_colour_options(CLI::App& command, ColourOptions& options) {
  command.add_option("--illuminant", options.illuminant, "D65, D50, A, E, FL11, LED-B3, ...")
      ->check(name_check("illuminant", illuminant_names))
      ->capture_default_str();
  command
      .add_option("--observer", options.observer, "cie1931 (2 degrees), cie1964 (10 degrees), ...")
      ->check(name_check("observer", observer_names))
      ->capture_default_str();
  command.add_option("--angle", options.angle_deg, "Angle of incidence in degrees")
      ->check(number_check(0.0, 90.0))
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--extrapolate", [&options](const std::string& how) { options.clamp = how == "clamp"; },
          "clamp: hold the end values of a table that does not cover 380 to 780 nm")
      ->check(CLI::IsMember({"error", "clamp"}))
      ->default_str("error");
}

nlohmann::json colour_json(const IndexColour& colour, const ColourOptions& options) {
  Rgb encoded = colour.linear_srgb;
  for (double& x : encoded) x = x >= 1.0 ? 1.0 : srgb_encode(std::max(x, 0.0));
  return {{"illuminant", options.illuminant},
          {"observer", options.observer},
          {"angle_deg", options.angle_deg},
          {"XYZ", colour.xyz},
          {"Lab", colour.lab},
          {"linear_srgb", colour.linear_srgb},
          {"srgb", encoded},
          {"srgb_hex", display_hex(colour.linear_srgb)}};
}

}  // namespace karat
