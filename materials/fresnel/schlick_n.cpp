// Schlick's approximation for a transparent medium, from its index alone.
//
// R = ((n - 1)^2 + 4 n (1 - cos)^5) / (n + 1)^2: Schlick, "An inexpensive BRDF model for
// physically-based rendering", CGF 13(3), 1994, equation 15 with the F0 of a real index. Here for
// teaching: it leaves out k, so that gold is a poor glass. (Where slides print 2 n for 4 n, an
// interface of n = 1.5 reflects 0.52 at 90 degrees; it must reflect 1.)
#include "materials/fresnel_terms.h"

namespace karat {
namespace {

class SchlickIndexFresnel final : public FresnelModel {
 public:
  std::string description() const override {
    return "((n - 1)^2 + 4 n (1 - cos)^5) / (n + 1)^2: for transparent media; leaves out k";
  }
  std::string source() const override { return "Schlick 1994, CGF 13(3), equation 15, k = 0"; }

  FresnelTables prepare(const LatticeIndex& index) const override {
    return {{lattice_of(index, [](double n, double) { return normal_incidence(n, 0.0); })}};
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
    const double n = index.n, minus = n - 1.0, plus = n + 1.0;
    const double r = (minus * minus + 4.0 * n * fifth_power(1.0 - cos_theta)) / (plus * plus);
    return {std::nullopt, std::nullopt, std::min(r, 1.0)};
  }
};

KARAT_REGISTER(FresnelModel, "schlick-n", SchlickIndexFresnel);

}  // namespace
}  // namespace karat
