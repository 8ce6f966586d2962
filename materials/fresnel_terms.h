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

// log2(x) for x in (0, 1], within 2e-7 (relatively, beyond 1); at 0 it is -127, whose power is 0
// for what follows. Without a call of the library: 8 % of the time of lazanyi-compensated. log2(m)
// = 2 atanh(z) / ln 2, z = (m - 1)/(m + 1), by its series, for m within a factor sqrt(2) of 1.
inline float log2_of_fraction(float x) {
  const int bits = std::bit_cast<int>(x);
  const int exponent = (bits - 0x3f3504f3) >> 23;
  const float m = std::bit_cast<float>(bits - exponent * (1 << 23));
  const float z = (m - 1.0f) / (m + 1.0f), z2 = z * z;
  const float series = 1.0f + z2 * (1.0f / 3.0f + z2 * (1.0f / 5.0f + z2 * (1.0f / 7.0f)));
  return static_cast<float>(exponent) + 2.88539008f * z * series;
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
