// Terms that several Fresnel approximations share.
#pragma once

#include <algorithm>
#include <bit>

#include "materials/fresnel.h"

namespace karat {

// The exact reflectance at normal incidence.
inline double normal_incidence(double n, double k) {
  return ((n - 1.0) * (n - 1.0) + k * k) / ((n + 1.0) * (n + 1.0) + k * k);
}

template <typename Real>
inline Real fifth_power(Real x) {
  const Real square = x * x;
  return square * square * x;
}

// 1 - F0, without the cancellation next to total reflection.
inline double normal_absorptance(double n, double k) {
  return 4.0 * n / ((n + 1.0) * (n + 1.0) + k * k);
}

// 2^x for x <= 0, within 2e-7 of it relatively; std::exp2 would keep the lanes from vectorising.
// Taylor series of 2^f over |f| <= 1/2, coefficients ln(2)^i / i!.
inline float exp2_of_negative(float x) {
  const float bounded = std::max(x, -125.0f);
  const int whole = static_cast<int>(bounded - 0.5f);
  const float f = bounded - static_cast<float>(whole);
  float p = 1.54035304e-4f;
  p = p * f + 1.33335581e-3f;
  p = p * f + 9.61812911e-3f;
  p = p * f + 5.55041087e-2f;
  p = p * f + 2.40226507e-1f;
  p = p * f + 6.93147181e-1f;
  p = p * f + 1.0f;
  return p * std::bit_cast<float>((whole + 127) << 23);
}

// `value(n, k)`, computed in double precision, at every lattice wavelength.
template <typename F>
LatticeSpectrum lattice_of(const LatticeIndex& index, F&& value) {
  LatticeSpectrum result;
  for (int phase = 0; phase < kPhases; ++phase) {
    result[phase] = for_each_lane([&](int i) {
      return static_cast<float>(value(double{index.n[phase][i]}, double{index.k[phase][i]}));
    });
  }
  return result;
}

}  // namespace karat
