// Hoffman's term for the dip of metals: c (1 - c)^6, largest at mu = 1/7 (81.8 degrees).
#pragma once

#include "materials/fresnel_terms.h"

namespace karat {

inline constexpr double kF82Cosine = 1.0 / 7.0;

template <typename Real>
inline Real f82_dip(Real c) {
  const Real x = Real(1) - c;
  return c * x * fifth_power(x);
}

inline double schlick_from_f0(double f0, double c) {
  return f0 + (1.0 - f0) * fifth_power(1.0 - c);
}

// The factor of the dip with which the approximation is `f82` at mu.
inline double f82_strength(double f0, double f82) {
  return (schlick_from_f0(f0, kF82Cosine) - f82) / f82_dip(kF82Cosine);
}

}  // namespace karat
