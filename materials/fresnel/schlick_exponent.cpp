// Schlick's approximation with a free exponent.
//
// R = F0 + (F90 - F0)(1 - cos)^p: the generalised Schlick of MaterialX 1.38
// (`generalized_schlick_bsdf`: color0, color90, exponent). F0 is exact; p is fitted per wavelength,
// by least squares against the exact reflectance over angles spread evenly between 0 and 90
// degrees, with F90 = 1, which every interface reflects at grazing incidence. Stated parameters may
// set another F90.
#include "materials/fresnel_angles.h"
#include "materials/fresnel_parametric.h"

namespace karat {
namespace {

// Below 1 the slope over the cosine at normal incidence would be infinite, which no surface has.
constexpr double kLeastExponent = 1.0, kLargestExponent = 100.0;
constexpr int kTried = 24;

double value(double f0, double f90, double exponent, double c) {
  return f0 + (f90 - f0) * std::pow(1.0 - c, exponent);
}

// The exponent of least squared error, found in its logarithm: the best of a few, then Newton's
// method by Gauss's approximation, damped by halving.
class ExponentFit {
 public:
  explicit ExponentFit(ComplexIndex index)
      : f0_(normal_incidence(index.n, index.k)), wanted_(exact_at_fit_cosines(index)) {}

  double best() const {
    const double low = std::log(kLeastExponent), high = std::log(kLargestExponent);
    double x = low, error = squares(low);
    for (int i = 1; i <= kTried; ++i) {
      const double at = low + (high - low) * i / kTried, e = squares(at);
      if (e < error) x = at, error = e;
    }
    for (int i = 0; i < 12; ++i) {
      double step = newton_step(x);
      double next = std::clamp(x + step, low, high);
      while (squares(next) > error && std::abs(step) > 1e-12) {
        step *= 0.5;
        next = std::clamp(x + step, low, high);
      }
      if (squares(next) > error) break;
      const double moved = std::abs(next - x);
      x = next, error = squares(next);
      if (moved < 1e-9) break;
    }
    return std::exp(x);
  }

 private:
  double squares(double x) const {
    double sum = 0.0;
    for (std::size_t j = 0; j < kFitAngles; ++j) {
      const double e = value(f0_, 1.0, std::exp(x), fit_cosines()[j]) - wanted_[j];
      sum += e * e;
    }
    return sum;
  }

  // d R / d ln p = (1 - F0) (1 - c)^p p ln(1 - c).
  double newton_step(double x) const {
    double gradient = 0.0, curvature = 0.0;
    for (std::size_t j = 0; j < kFitAngles; ++j) {
      const double c = fit_cosines()[j], p = std::exp(x);
      const double r = value(f0_, 1.0, p, c);
      const double slope = (r - f0_) * p * std::log(1.0 - c);
      gradient += (r - wanted_[j]) * slope;
      curvature += slope * slope;
    }
    return curvature > 0.0 ? -gradient / curvature : 0.0;
  }

  double f0_;
  FitAngles wanted_;
};

class SchlickExponentFresnel final : public ParametricFresnel {
 public:
  std::string description() const override {
    return "F0 + (F90 - F0)(1 - cos)^p, p fitted per wavelength with F90 = 1";
  }
  std::string source() const override {
    return "MaterialX generalized Schlick; Hoffman 2023, SIGGRAPH course; p fitted here";
  }
  std::vector<FresnelParameter> parameters() const override {
    return {{"exponent", "what 1 - cos is raised to", kLeastExponent, kLargestExponent, false},
            {"f90", "reflectance at 90 degrees", 0.0, 1.0, false}};
  }
  std::vector<double> chosen(ComplexIndex index) const override {
    return {ExponentFit(index).best(), 1.0};
  }

  SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                              float cos_theta) const override {
    const SampledSpectrum& f0 = tables.planes[0][phase];
    const SampledSpectrum& exponent = tables.planes[1][phase];
    const SampledSpectrum& f90 = tables.planes[2][phase];
    const float logarithm = log2_of_fraction(1.0f - cos_theta);
    SampledSpectrum r;
    for (int i = 0; i < kLanes; ++i) {
      r[i] = std::min(f0[i] + (f90[i] - f0[i]) * exp2_of_negative(exponent[i] * logarithm), 1.0f);
    }
    return r;
  }

  double evaluate_with(ComplexIndex index, double cos_theta,
                       const std::vector<double>& values) const override {
    const double f0 = normal_incidence(index.n, index.k);
    return std::min(value(f0, values[1], values[0], cos_theta), 1.0);
  }
};

KARAT_REGISTER(FresnelModel, "schlick-exponent", SchlickExponentFresnel);

}  // namespace
}  // namespace karat
