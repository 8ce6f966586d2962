// Tables of samples as smooth curves that do not overshoot.
#pragma once

#include "spectral/spectrum.h"

namespace karat {

// A cubic through the samples of `table`, monotone between any two of them, so that it has no
// extremum that they have not, with a continuous first derivative: M. Steffen, "A simple method for
// monotonic interpolation in one dimension", Astronomy and Astrophysics 239 (1990), 443-450. Where
// a wavelength is repeated the curve jumps, as the table does. Range and samples are the table's;
// what has no samples is returned as it is.
SpectrumPtr monotone_cubic(SpectrumPtr table);

}  // namespace karat
