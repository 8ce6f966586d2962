// Illuminants: relative spectral power distributions from data/illuminants, one file each.
#pragma once

#include <string>
#include <vector>

#include "spectral/spectrum.h"

namespace karat {

// The relative spectral power distribution of "D65", "D50", "A", "E", "FL11", "LED-B3", ... as in
// its source (100 at 560 nm for most). Tables are linear between their samples and zero outside
// their range, which `range()` reports; A and E are formulas and unbounded. Throws InputError
// listing the names.
SpectrumPtr illuminant(const std::string& name);

// The names of the files in data/illuminants, sorted. A further file there is a further illuminant.
std::vector<std::string> illuminant_names();

// `spectrum` scaled to Y = 1 under the 1931 observer: sum(S ybar) = sum(ybar) at 1 nm. Throws
// InputError when it has no power there.
SpectrumPtr normalised(SpectrumPtr spectrum);

// Daylight of a correlated colour temperature in kelvin on the scale of today's second radiation
// constant (D65 is 6504 K), 4000 to 25000 K, otherwise InputError. CIE 015:2018, equations 4.2 to
// 4.10: chromaticity on the daylight locus, S = S0 + M1 S1 + M2 S2, with M1 and M2 unrounded.
SpectrumPtr daylight_spectrum(double temperature_kelvin);

}  // namespace karat
