// Lazanyi's approximation with its error term: the dip that metals with a large k have before
// grazing incidence.
//
// R = S(cos) - a cos (1 - cos)^alpha with S the model "lazanyi": Lazanyi and Szirmay-Kalos,
// "Fresnel term approximations for metals", WSCG short papers, 2005, pages 77 to 80. The paper fits
// a and alpha once per metal (the model "lazanyi-compensated-metal"); here they are fitted per
// wavelength, by least squares against the exact reflectance over angles spread evenly between 0
// and 90 degrees. The difference may leave [0, 1] where the fit is poor.
#include "materials/fresnel_compensation.h"

namespace karat {
namespace {

class CompensatedLazanyiFresnel final : public CompensatedFresnel {
 public:
  std::string description() const override {
    return "lazanyi minus a cos (1 - cos)^alpha, fitted per wavelength";
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
      r[i] = f0[i] + (1.0f - f0[i]) * x - error;
    }
    return r;
  }
};

KARAT_REGISTER(FresnelModel, "lazanyi-compensated", CompensatedLazanyiFresnel);

}  // namespace
}  // namespace karat
