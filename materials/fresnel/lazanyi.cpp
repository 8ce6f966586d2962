// Lazanyi's rescaled form of Schlick's approximation for metals.
//
// R = ((n - 1)^2 + 4 n (1 - cos)^5 + k^2) / ((n + 1)^2 + k^2): Lazanyi and Szirmay-Kalos, "Fresnel
// term approximations for metals", WSCG short papers, 2005, pages 77 to 80, equation 4.
//
// Because 1 - F0 = 4 n / ((n + 1)^2 + k^2) this is F0 + (1 - F0)(1 - cos)^5: the model "schlick".
// Both stand here because both names are in use; a test holds them equal.
#include <algorithm>

#include "materials/fresnel_terms.h"

namespace karat {
namespace {

// What (1 - cos)^5 is multiplied by.
double grazing_part(double n, double k) { return 4.0 * n / ((n + 1.0) * (n + 1.0) + k * k); }

class LazanyiFresnel final : public FresnelModel {
 public:
  std::string description() const override {
    return "Schlick's form rescaled for a complex index; the same function as schlick";
  }
  std::string source() const override {
    return "Lazanyi and Szirmay-Kalos, WSCG short papers 2005, 77-80";
  }

  FresnelTables prepare(const LatticeIndex& index) const override {
    return {{lattice_of(index, normal_incidence), lattice_of(index, grazing_part)}};
  }

  SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                              float cos_theta) const override {
    const SampledSpectrum& f0 = tables.planes[0][phase];
    const SampledSpectrum& grazing = tables.planes[1][phase];
    const float x = fifth_power(1.0f - cos_theta);
    SampledSpectrum r;
    for (int i = 0; i < kLanes; ++i) r[i] = std::min(f0[i] + grazing[i] * x, 1.0f);
    return r;
  }

  Scalar evaluate(ComplexIndex index, double cos_theta) const override {
    const auto [n, k] = index;
    const double x = fifth_power(1.0 - cos_theta);
    const double numerator = (n - 1.0) * (n - 1.0) + 4.0 * n * x + k * k;
    const double r = numerator / ((n + 1.0) * (n + 1.0) + k * k);
    return {std::nullopt, std::nullopt, std::min(r, 1.0)};
  }
};

KARAT_REGISTER(FresnelModel, "lazanyi", LazanyiFresnel);

}  // namespace
}  // namespace karat
