// The colour of a material's reflectance.
#pragma once

#include <optional>
#include <string>

#include "materials/index/index_table.h"
#include "spectral/colour.h"

namespace karat {

// F0 of an interface from air: ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2), in [0, 1] for n, k >= 0.
double normal_reflectance(ComplexIndex index);

// XYZ of F0 under D65 for the 1931 observer, Y = 1 for the perfect reflector, over the wavelengths
// that the table covers; nothing where these are not at least 380 to 780 nm. Throws InputError
// where the table has no index.
std::optional<Xyz> normal_colour(const IndexTable& table);

// How a smooth surface in air is lit and seen.
struct ColourConditions {
  std::string illuminant = "D65";  // one of illuminant_names()
  std::string observer = "cie1931";
  double cos_theta = 1.0;         // of the angle of incidence, in [0, 1]
  std::string fresnel = "exact";  // a registered FresnelModel
  // kClamp holds the end values of a table that does not cover 380 to 780 nm; kError throws.
  RangePolicy range = RangePolicy::kError;
};

struct IndexColour {
  Xyz xyz;          // sum(R S xyzbar) / sum(S ybar) at 1 nm: Y = 1 for the perfect reflector
  Lab lab;          // against the white of the same sums
  Rgb linear_srgb;  // of xyz adapted from the illuminant's white to D65 (Bradford), not clamped
};

// The colour of the unpolarised reflectance over the wavelengths that the table covers. Throws
// InputError where the table does not cover 380 to 780 nm, gives no index or a negative one, or the
// illuminant has no power.
IndexColour index_colour(const IndexTable& table, const ColourConditions& conditions = {});

// The same for a reflectance that is known at all wavelengths of the observer.
IndexColour reflectance_colour(const WavelengthFunction& reflectance,
                               const ColourConditions& conditions,
                               WavelengthRange range = kWholeObserver);

}  // namespace karat
