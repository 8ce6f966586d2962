// Lazanyi's approximation with its error term: the dip that metals with a large k have before
// grazing incidence.
//
// R = S(cos) - a cos (1 - cos)^alpha with S the model "lazanyi": Lazanyi and Szirmay-Kalos,
// "Fresnel term approximations for metals", WSCG short papers, 2005, pages 77 to 80. The paper fits
// a and alpha once per metal (the model "lazanyi-compensated-metal"); here they are fitted per
// wavelength, by least squares against the exact reflectance over angles spread evenly between 0
// and 90 degrees. The difference may leave [0, 1] where the fit is poor, and is clamped.
#include "materials/fresnel_compensation.h"
#include "materials/fresnel_parametric.h"

namespace karat {
namespace {

class CompensatedLazanyiFresnel final : public ParametricFresnel {
 public:
  std::string description() const override {
    return "lazanyi minus a cos (1 - cos)^alpha, fitted per wavelength, clamped to [0, 1]";
  }
  std::string source() const override {
    return "Lazanyi and Szirmay-Kalos, WSCG short papers 2005, 77-80; a and alpha fitted here";
  }
  std::vector<FresnelParameter> parameters() const override {
    return {{"a", "strength of the error term", -kLargestA, kLargestA, false},
            {"alpha", "exponent of the error term", kLeastAlpha, kLargestAlpha, false}};
  }
  std::vector<double> chosen(ComplexIndex index) const override {
    const Compensation fit = fit_compensation(rescaled_errors(index));
    return {fit.a, fit.alpha};
  }

  FresnelTables prepare_with(const LatticeIndex& index,
                             const std::vector<LatticeSpectrum>& values) const override {
    return {{lattice_of(index, normal_incidence), values[0], values[1]}};
  }

  SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                              float cos_theta) const override {
    const SampledSpectrum& f0 = tables.planes[0][phase];
    const SampledSpectrum& a = tables.planes[1][phase];
    const SampledSpectrum& alpha = tables.planes[2][phase];
    const float x = fifth_power(1.0f - cos_theta);
    const float logarithm = log2_of_fraction(1.0f - cos_theta);
    SampledSpectrum r;
    for (int i = 0; i < kLanes; ++i) {
      const float error = a[i] * cos_theta * exp2_of_negative(alpha[i] * logarithm);
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

KARAT_REGISTER(FresnelModel, "lazanyi-compensated", CompensatedLazanyiFresnel);

}  // namespace
}  // namespace karat
