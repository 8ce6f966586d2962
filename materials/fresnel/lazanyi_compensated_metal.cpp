// Lazanyi's approximation with its error term, one pair of constants for a whole metal.
//
// R = S(cos) - a cos (1 - cos)^alpha with S the model "lazanyi": Lazanyi and Szirmay-Kalos,
// "Fresnel term approximations for metals", WSCG short papers, 2005, pages 77 to 80, which fits a
// and alpha once per metal. Its published values could not be found: here they are the least
// squares against the exact reflectance over all lattice wavelengths and over angles spread evenly
// between 0 and 90 degrees. The power is the same at every wavelength, so that it is computed once.
#include "materials/fresnel_compensation.h"

namespace karat {
namespace {

class CompensatedMetalFresnel final : public CompensatedFresnel {
 public:
  std::string description() const override {
    return "lazanyi minus a cos (1 - cos)^alpha, one a and alpha per metal";
  }
  bool per_wavelength() const override { return false; }

  std::vector<LatticeSpectrum> chosen_on(const LatticeIndex& index) const override {
    FitAngles mean{};
    for (int phase = 0; phase < kPhases; ++phase) {
      for (int i = 0; i < kLanes; ++i) {
        const FitAngles errors = rescaled_errors({index.n[phase][i], index.k[phase][i]});
        for (std::size_t j = 0; j < kFitAngles; ++j) mean[j] += errors[j] / kLatticeSize;
      }
    }
    const Compensation fit = fit_compensation(mean);
    return {LatticeSpectrum(static_cast<float>(fit.a)),
            LatticeSpectrum(static_cast<float>(fit.alpha))};
  }

  SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                              float cos_theta) const override {
    const SampledSpectrum& f0 = tables.planes[0][phase];
    const float a = tables.planes[1][0][0], alpha = tables.planes[2][0][0];
    const float x = fifth_power(1.0f - cos_theta);
    const float error =
        a * cos_theta * exp2_of_negative(alpha * log2_of_fraction(1.0f - cos_theta));
    SampledSpectrum r;
    for (int i = 0; i < kLanes; ++i) {
      r[i] = f0[i] + (1.0f - f0[i]) * x - error;
    }
    return r;
  }
};

KARAT_REGISTER(FresnelModel, "lazanyi-compensated-metal", CompensatedMetalFresnel);

}  // namespace
}  // namespace karat
