// The colour of a material's reflectance at normal incidence.
#pragma once

#include <optional>

#include "materials/index_table.h"
#include "spectral/colour.h"

namespace karat {

// F0 of an interface from air: ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2), in [0, 1] for n, k >= 0.
double normal_reflectance(ComplexIndex index);

// XYZ of F0 under D65 for the 1931 observer, Y = 1 for the perfect reflector, over the wavelengths
// that the table covers; nothing where these are not at least 380 to 780 nm. Throws InputError
// where the table has no index.
std::optional<Xyz> normal_colour(const IndexTable& table);

}  // namespace karat
