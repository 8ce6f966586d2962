// Lazanyi's error term a cos (1 - cos)^alpha, fitted: shared by the models that fit it per
// wavelength and per metal.
#pragma once

#include "materials/fresnel_angles.h"

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

}  // namespace karat
