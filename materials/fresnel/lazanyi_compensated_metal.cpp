// Lazanyi's approximation with its error term, one pair of constants for a whole metal.
//
// R = S(cos) - a cos (1 - cos)^alpha with S the model "lazanyi": Lazanyi and Szirmay-Kalos,
// "Fresnel term approximations for metals", WSCG short papers, 2005, pages 77 to 80, which fits a
// and alpha once per metal. Its published values could not be found: here they are the least
// squares against the exact reflectance over all lattice wavelengths and over angles spread evenly
// between 0 and 90 degrees. The power is the same at every wavelength, so that it is computed once.
#include "materials/fresnel_compensation.h"
#include "materials/fresnel_parametric.h"

namespace karat {
namespace {

class CompensatedMetalFresnel final : public ParametricFresnel {
 public:
  std::string description() const override {
    return "lazanyi minus a cos (1 - cos)^alpha, one a and alpha per metal, clamped to [0, 1]";
  }
  std::string source() const override {
    return "Lazanyi and Szirmay-Kalos, WSCG short papers 2005, 77-80; a and alpha fitted here";
  }
  bool per_wavelength() const override { return false; }
  std::vector<FresnelParameter> parameters() const override {
    return {{"a", "strength of the error term", -kLargestA, kLargestA, true},
            {"alpha", "exponent of the error term", kLeastAlpha, kLargestAlpha, true}};
  }
  std::vector<double> chosen(ComplexIndex index) const override {
    const Compensation fit = fit_compensation(rescaled_errors(index));
    return {fit.a, fit.alpha};
  }

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

  FresnelTables prepare_with(const LatticeIndex& index,
                             const std::vector<LatticeSpectrum>& values) const override {
    return {{lattice_of(index, normal_incidence), values[0], values[1]}};
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
      r[i] = std::clamp(f0[i] + (1.0f - f0[i]) * x - error, 0.0f, 1.0f);
    }
    return r;
  }

  double evaluate_with(ComplexIndex index, double cos_theta,
                       const std::vector<double>& values) const override {
    const double error = values[0] * cos_theta * std::pow(1.0 - cos_theta, values[1]);
    return std::clamp(rescaled_schlick(index, cos_theta) - error, 0.0, 1.0);
  }
};

KARAT_REGISTER(FresnelModel, "lazanyi-compensated-metal", CompensatedMetalFresnel);

}  // namespace
}  // namespace karat
