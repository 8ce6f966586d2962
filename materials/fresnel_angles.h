// The angles over which models fit their parameters: 64, evenly spread between 0 and 90 degrees.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "materials/fresnel_exact.h"

namespace karat {

inline constexpr std::size_t kFitAngles = 64;
using FitAngles = std::array<double, kFitAngles>;

inline const FitAngles& fit_cosines() {
  static const FitAngles cosines = [] {
    FitAngles c;
    for (std::size_t j = 0; j < kFitAngles; ++j) {
      c[j] = std::cos((static_cast<double>(j) + 0.5) / kFitAngles * (std::numbers::pi / 2.0));
    }
    return c;
  }();
  return cosines;
}

// The exact reflectances at these angles.
inline FitAngles exact_at_fit_cosines(ComplexIndex index) {
  FitAngles r;
  for (std::size_t j = 0; j < kFitAngles; ++j) {
    r[j] = exact_scalar(index, fit_cosines()[j]).unpolarised;
  }
  return r;
}

}  // namespace karat
