// The exact reflectance of a plane interface to an absorbing medium: the kernel of the model
// "exact" and of those that are exact for another index than the measured one.
//
// Fresnel 1823, in the real form of Born and Wolf, "Principles of Optics", section 14.2. With
// c = cos(theta), s2 = sin^2(theta), d = n^2 - k^2 - s2, C = hypot(d, 2nk), a^2 = (C + d)/2 and
// b^2 = (C - d)/2, so that a + ib = sqrt((n + ik)^2 - s2):
//   R_s = ((a - c)^2 + b^2) / ((a + c)^2 + b^2)
//   R_p = R_s ((a c - s2)^2 + b^2 c^2) / ((a c + s2)^2 + b^2 c^2)
//
// Why this form: tan(theta) never appears, so that 90 degrees is no exception. With L = max(a, b),
// the smaller of the two is n k / L, which does not cancel as sqrt(C - |d|) does; a, b and both
// numerators and denominators are scaled by L, which leaves one division for the unpolarised value.
// d is (n^2 - k^2 - 1) + c^2, its bracket rounded from double precision to two floats and the sum
// fused: near total reflection, where d is all that counts, it keeps its relative accuracy.
#pragma once

#include <algorithm>
#include <cmath>

#include "materials/fresnel.h"

namespace karat {

// Planes: n^2 - k^2 - 1 (what float holds, and the rest), and n k.
enum ExactPlane { kExactReal, kExactRealRest, kExactImaginary, kExactPlanes };

// In the float kernel the eighth power of an index must stay below the largest float. At this limit
// a surface reflects 1 - 1.4e-4 at normal incidence.
inline constexpr double kLargestKernelIndex = 3e4;

// The least L^2, reached at the critical angle itself, and the least denominator. The cube of the
// former is above the latter, so that at exactly 90 degrees even a matched index (n = 1, k = 0),
// for which the formula is 0/0, reflects 1 as every other one does.
template <typename Real>
struct ExactFloor;
template <>
struct ExactFloor<float> {
  static constexpr float square = 1e-12f, denominator = 1e-37f;
};
template <>
struct ExactFloor<double> {
  static constexpr double square = 1e-60, denominator = 1e-300;
};

// c * c + x rounded once, where the instruction set can; a call of the library would cost more than
// all the rest.
inline float square_plus(float c, float x) {
#ifdef __FMA__
  return std::fma(c, c, x);
#else
  return c * c + x;
#endif
}

// Numerators and denominators of R_s and of R_p / R_s, each times L^2.
template <typename Real>
struct ExactTerms {
  Real s_numerator, s_denominator, p_numerator, p_denominator;
};

template <typename Real>
inline ExactTerms<Real> exact_terms(Real d, Real nk, Real c, Real s2) {
  const Real hypotenuse = std::sqrt(d * d + Real(4) * nk * nk);
  const Real square = std::max(Real(0.5) * (hypotenuse + std::abs(d)), ExactFloor<Real>::square);
  const Real larger = std::sqrt(square);
  const Real a = d >= Real(0) ? square : nk;  // a L
  const Real b = d >= Real(0) ? nk : square;  // b L
  const Real cl = c * larger, sl = s2 * larger;
  const Real b2 = b * b, b2c2 = b2 * c * c, ac = a * c;
  return {(a - cl) * (a - cl) + b2, (a + cl) * (a + cl) + b2, (ac - sl) * (ac - sl) + b2c2,
          (ac + sl) * (ac + sl) + b2c2};
}

// The planes of the index that `index_at(n, k)` makes of the given one, in double precision.
template <typename F>
FresnelTables exact_tables(const LatticeIndex& index, F&& index_at) {
  FresnelTables tables;
  tables.planes.resize(kExactPlanes);
  for (int phase = 0; phase < kPhases; ++phase) {
    for (int i = 0; i < kLanes; ++i) {
      const ComplexIndex m = index_at(double{index.n[phase][i]}, double{index.k[phase][i]});
      const double n = std::min(m.n, kLargestKernelIndex), k = std::min(m.k, kLargestKernelIndex);
      const double real = (n - 1.0) * (n + 1.0) - k * k;
      const float rounded = static_cast<float>(real);
      tables.planes[kExactReal][phase][i] = rounded;
      tables.planes[kExactRealRest][phase][i] = static_cast<float>(real - rounded);
      tables.planes[kExactImaginary][phase][i] = static_cast<float>(n * k);
    }
  }
  return tables;
}

// The mean of R_s and R_p over one common denominator: one division per lane.
inline SampledSpectrum exact_reflectance(const FresnelTables& tables, int phase, float cos_theta) {
  const SampledSpectrum& real = tables.planes[kExactReal][phase];
  const SampledSpectrum& rest = tables.planes[kExactRealRest][phase];
  const SampledSpectrum& nk = tables.planes[kExactImaginary][phase];
  const float s2 = (1.0f - cos_theta) * (1.0f + cos_theta);
  SampledSpectrum r;
  for (int i = 0; i < kLanes; ++i) {
    const float d = square_plus(cos_theta, real[i]) + rest[i];
    const ExactTerms<float> t = exact_terms(d, nk[i], cos_theta, s2);
    const float numerator = 0.5f * t.s_numerator * (t.p_numerator + t.p_denominator);
    const float denominator = t.s_denominator * t.p_denominator;
    r[i] = std::min(numerator / std::max(denominator, ExactFloor<float>::denominator), 1.0f);
  }
  return r;
}

inline PolarisedReflectance exact_polarised(const FresnelTables& tables, int phase,
                                            float cos_theta) {
  constexpr float kFloor = ExactFloor<float>::denominator;
  const SampledSpectrum& real = tables.planes[kExactReal][phase];
  const SampledSpectrum& rest = tables.planes[kExactRealRest][phase];
  const SampledSpectrum& nk = tables.planes[kExactImaginary][phase];
  const float s2 = (1.0f - cos_theta) * (1.0f + cos_theta);
  PolarisedReflectance r;
  for (int i = 0; i < kLanes; ++i) {
    const float d = square_plus(cos_theta, real[i]) + rest[i];
    const ExactTerms<float> t = exact_terms(d, nk[i], cos_theta, s2);
    r.s[i] = std::min(t.s_numerator / std::max(t.s_denominator, kFloor), 1.0f);
    r.p[i] = r.s[i] * t.p_numerator / std::max(t.p_denominator, kFloor);
  }
  return r;
}

// One wavelength in double precision.
inline FresnelModel::Scalar exact_scalar(ComplexIndex index, double cos_theta) {
  constexpr double kFloor = ExactFloor<double>::denominator;
  const double s2 = (1.0 - cos_theta) * (1.0 + cos_theta);
  const auto [n, k] = index;
  const double d = (n - 1.0) * (n + 1.0) - k * k + cos_theta * cos_theta;
  const ExactTerms<double> t = exact_terms(d, n * k, cos_theta, s2);
  const double s = std::min(t.s_numerator / std::max(t.s_denominator, kFloor), 1.0);
  const double p = s * t.p_numerator / std::max(t.p_denominator, kFloor);
  return {s, p, 0.5 * (s + p)};
}

// A model that is the exact one for the index that it puts in place of the given one.
class ExactFormFresnel : public FresnelModel {
 public:
  virtual ComplexIndex substitute(ComplexIndex index) const = 0;

  FresnelTables prepare(const LatticeIndex& index) const final {
    return exact_tables(index, [&](double n, double k) { return substitute({n, k}); });
  }
  SampledSpectrum reflectance(const FresnelTables& tables, int phase, float cos_theta) const final {
    return exact_reflectance(tables, phase, cos_theta);
  }
  std::optional<PolarisedReflectance> polarised(const FresnelTables& tables, int phase,
                                                float cos_theta) const final {
    return exact_polarised(tables, phase, cos_theta);
  }
  Scalar evaluate(ComplexIndex index, double cos_theta) const final {
    return exact_scalar(substitute(index), cos_theta);
  }
};

}  // namespace karat
