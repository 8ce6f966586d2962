#include "materials/index/import/permittivity.h"

#include <cmath>

namespace karat {

ComplexIndex index_of_permittivity(double eps1, double eps2) {
  // n^2 = (|eps| + eps1) / 2 and k^2 = (|eps| - eps1) / 2; the one of the two that is a difference
  // of like numbers follows from 2 n k = eps2 instead.
  const double larger = std::sqrt((std::hypot(eps1, eps2) + std::abs(eps1)) / 2.0);
  if (larger == 0.0) return {0.0, 0.0};
  const double smaller = std::abs(eps2) / (2.0 * larger);
  const double n = eps1 >= 0.0 ? larger : smaller;
  const double k = eps1 >= 0.0 ? smaller : larger;
  return {n, std::copysign(k, eps2)};
}

}  // namespace karat
