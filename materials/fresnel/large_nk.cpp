// The limit of the Fresnel equations for a large index.
//
// Where |n + ik| >> 1 the angle inside the metal is nearly zero, and with q = n^2 + k^2
//   R_s = (q - 2 n c + c^2) / (q + 2 n c + c^2),  R_p = (q c^2 - 2 n c + 1) / (q c^2 + 2 n c + 1):
// Siegel and Howell, "Thermal Radiation Heat Transfer", section on metals; Pharr and Humphreys,
// "Physically Based Rendering", 2004, section 9.2 (FrConductor). Exact at 0 and at 90 degrees.
//
// Numerators are the squares (n - c)^2 + k^2 and (n c - 1)^2 + k^2 c^2, which cannot fall below 0.
#include "materials/fresnel_terms.h"

namespace karat {
namespace {

constexpr double kLargestIndex = 1e6;  // its fourth power is a float

template <typename Real>
struct Fractions {
  Real s_numerator, s_denominator, p_numerator, p_denominator;
};

template <typename Real>
inline Fractions<Real> fractions(Real n, Real k, Real c) {
  const Real k2 = k * k, nc = n * c, kc2 = k2 * c * c;
  return {(n - c) * (n - c) + k2, (n + c) * (n + c) + k2, (nc - Real(1)) * (nc - Real(1)) + kc2,
          (nc + Real(1)) * (nc + Real(1)) + kc2};
}

class LargeIndexFresnel final : public FresnelModel {
 public:
  std::string description() const override {
    return "the Fresnel equations where |n + ik| is much above 1; exact at 0 and 90 degrees";
  }
  std::string source() const override {
    return "Siegel and Howell, Thermal Radiation Heat Transfer; Pharr and Humphreys 2004, 9.2";
  }

  FresnelTables prepare(const LatticeIndex& index) const override {
    const auto bounded = [](double x) { return std::min(x, kLargestIndex); };
    return {{lattice_of(index, [&](double n, double) { return bounded(n); }),
             lattice_of(index, [&](double, double k) { return bounded(k); })}};
  }

  SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                              float cos_theta) const override {
    const SampledSpectrum& n = tables.planes[0][phase];
    const SampledSpectrum& k = tables.planes[1][phase];
    SampledSpectrum r;
    for (int i = 0; i < kLanes; ++i) {
      const Fractions<float> f = fractions(n[i], k[i], cos_theta);
      const float sum = f.s_numerator * f.p_denominator + f.p_numerator * f.s_denominator;
      // n = k = c = 0 is 0/0: the metal without index reflects all, as every one does at c = 0.
      const float both = f.s_denominator * f.p_denominator;
      r[i] = both > 0.0f ? std::min(0.5f * sum / both, 1.0f) : 1.0f;
    }
    return r;
  }

  std::optional<PolarisedReflectance> polarised(const FresnelTables& tables, int phase,
                                                float cos_theta) const override {
    const SampledSpectrum& n = tables.planes[0][phase];
    const SampledSpectrum& k = tables.planes[1][phase];
    PolarisedReflectance r;
    for (int i = 0; i < kLanes; ++i) {
      const Fractions<float> f = fractions(n[i], k[i], cos_theta);
      r.s[i] = f.s_denominator > 0.0f ? f.s_numerator / f.s_denominator : 1.0f;
      r.p[i] = f.p_numerator / f.p_denominator;
    }
    return r;
  }

  Scalar evaluate(ComplexIndex index, double cos_theta) const override {
    const Fractions<double> f = fractions(index.n, index.k, cos_theta);
    const double s = f.s_denominator > 0.0 ? f.s_numerator / f.s_denominator : 1.0;
    const double p = f.p_numerator / f.p_denominator;
    return {s, p, 0.5 * (s + p)};
  }
};

KARAT_REGISTER(FresnelModel, "large-nk", LargeIndexFresnel);

}  // namespace
}  // namespace karat
