// Terms that several Fresnel approximations share.
#pragma once

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
