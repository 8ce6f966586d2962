// Schlick's approximation from the exact reflectance at normal incidence.
//
// R = F0 + (1 - F0)(1 - cos)^5: Schlick, "An inexpensive BRDF model for physically-based
// rendering", CGF 13(3), 1994, equation 15, with the F0 of the complex index.
#include "materials/fresnel_terms.h"

namespace karat {
namespace {

class SchlickFresnel final : public FresnelModel {
 public:
  std::string description() const override {
    return "F0 + (1 - F0)(1 - cos)^5, F0 exact from n and k";
  }
  std::string source() const override { return "Schlick 1994, CGF 13(3), equation 15"; }

  FresnelTables prepare(const LatticeIndex& index) const override {
    return {{lattice_of(index, normal_incidence)}};
  }

  SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                              float cos_theta) const override {
    const SampledSpectrum& f0 = tables.planes[0][phase];
    const float x = fifth_power(1.0f - cos_theta);
    SampledSpectrum r;
    for (int i = 0; i < kLanes; ++i) r[i] = f0[i] + (1.0f - f0[i]) * x;
    return r;
  }

  Scalar evaluate(ComplexIndex index, double cos_theta) const override {
    const double f0 = normal_incidence(index.n, index.k);
    return {std::nullopt, std::nullopt, f0 + (1.0 - f0) * fifth_power(1.0 - cos_theta)};
  }
};

KARAT_REGISTER(FresnelModel, "schlick", SchlickFresnel);

}  // namespace
}  // namespace karat
