// Between n + ik and its square.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>

#include "materials/index/index_table.h"

namespace karat {

inline std::complex<double> permittivity_of(ComplexIndex index) {
  return {(index.n - index.k) * (index.n + index.k), 2.0 * index.n * index.k};
}

// The root with n, k >= 0. Of two nearly equal magnitudes only the larger root is taken directly:
// the other would cancel.
inline ComplexIndex index_of(std::complex<double> permittivity) {
  const double real = permittivity.real(), size = std::abs(permittivity);
  const double larger = std::sqrt(0.5 * (size + std::abs(real)));
  if (!(larger > 0.0)) return {0.0, 0.0};
  const double smaller = 0.5 * std::max(permittivity.imag(), 0.0) / larger;
  return real >= 0.0 ? ComplexIndex{larger, smaller} : ComplexIndex{smaller, larger};
}

}  // namespace karat
