// The nine dispersion formulas of refractiveindex.info: n as a function of wavelength.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "spectral/spectrum.h"

namespace karat {

// Formula `number` (1 to 9) with its coefficients C1, C2, ...; missing trailing ones are 0.
struct DispersionFormula {
  int number = 0;
  std::vector<double> coefficients;

  // n at a wavelength in micrometres, or nothing where the formula gives none: n^2 < 0, a pole, or
  // a value beyond kLargestIndex.
  std::optional<double> index(double wavelength_um) const;

  // Wavelengths in micrometres of the resonances (poles) of formulas 1 and 2 with non-zero
  // strength.
  std::vector<double> resonances_um() const;
};

// Beyond this an index is an error of the data: measured ones stay below some thousands, even for
// metals in the far infrared.
inline constexpr double kLargestIndex = 1e6;

// A formula over the range that its file states.
struct FormulaCurve {
  SpectrumPtr n;     // throws InputError at a wavelength where the formula gives no index
  std::string gaps;  // "20113 to 44608 nm": where that is so, as found by sampling; "" mostly
};

// `origin` names file and block in errors. Throws InputError when the formula gives no index
// anywhere in `range`.
FormulaCurve formula_curve(DispersionFormula formula, WavelengthRange range, std::string origin);

}  // namespace karat
