// Lazanyi's error term a cos (1 - cos)^alpha, fitted: shared by the models that fit it per
// wavelength and per metal.
#pragma once

#include <algorithm>
#include <cmath>

#include "materials/fresnel_angles.h"
#include "materials/fresnel_parametric.h"

namespace karat {

// Below an exponent of 1 the slope at normal incidence would be infinite, which no surface has.
inline constexpr double kLeastAlpha = 1.0, kLargestAlpha = 128.0;
inline constexpr double kLargestA = 100.0;

struct Compensation {
  double a = 0.0, alpha = 1.0;
};

// S(c) = F0 + (1 - F0)(1 - c)^5, the model "lazanyi".
double rescaled_schlick(ComplexIndex index, double cos_theta);

// S - R at the fit's angles, R exact.
FitAngles rescaled_errors(ComplexIndex index);

// The a and alpha for which a c (1 - c)^alpha is nearest to `errors`, by least squares. The fit to
// several wavelengths at once is the fit to their mean errors, as the term is the same for all.
Compensation fit_compensation(const FitAngles& errors);

// Both models but for how their values vary: S(c) - a c (1 - c)^alpha.
class CompensatedFresnel : public ParametricFresnel {
 public:
  std::string source() const final {
    return "Lazanyi and Szirmay-Kalos, WSCG short papers 2005, 77-80; a and alpha fitted here";
  }
  std::vector<FresnelParameter> parameters() const final {
    const bool constant = !per_wavelength();
    return {{"a", "strength of the error term", -kLargestA, kLargestA, constant},
            {"alpha", "exponent of the error term", kLeastAlpha, kLargestAlpha, constant}};
  }
  std::vector<double> chosen(ComplexIndex index) const final {
    const Compensation fit = fit_compensation(rescaled_errors(index));
    return {fit.a, fit.alpha};
  }
  double evaluate_with(ComplexIndex index, double cos_theta,
                       const std::vector<double>& values) const final {
    const double error = values[0] * cos_theta * std::pow(1.0 - cos_theta, values[1]);
    return rescaled_schlick(index, cos_theta) - error;
  }
};

}  // namespace karat
