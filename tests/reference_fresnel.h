// The Fresnel equations once more, in complex amplitudes and double precision: written differently
// from what it checks, and slow.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>

namespace karat::reference {

struct Reflectance {
  double s, p;
  double unpolarised() const { return 0.5 * (s + p); }
};

// Relative index m = n + ik (k >= 0): r_s = (c - q)/(c + q), r_p = (m^2 c - q)/(m^2 c + q) with
// q = sqrt(m^2 - sin^2), Im q >= 0.
inline Reflectance fresnel(double n, double k, double cos_theta) {
  const std::complex<double> m(n, k), m2 = m * m;
  // m^2 - 1 in factors: m^2 - sin^2 would lose the digits that count near total reflection.
  std::complex<double> q = std::sqrt((m - 1.0) * (m + 1.0) + cos_theta * cos_theta);
  if (q.imag() < 0.0) q = -q;
  return {std::norm((cos_theta - q) / (cos_theta + q)),
          std::norm((m2 * cos_theta - q) / (m2 * cos_theta + q))};
}

inline double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

}  // namespace karat::reference
