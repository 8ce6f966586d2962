// Lazanyi's approximation with its error term: the dip that metals with a large k have before
// grazing incidence.
//
// R = S(cos) - a cos (1 - cos)^alpha with S the model "lazanyi": Lazanyi and Szirmay-Kalos,
// "Fresnel term approximations for metals", WSCG short papers, 2005, pages 77 to 80. The paper fits
// a and alpha once per metal; here they are fitted per wavelength, by least squares against the
// exact reflectance over angles spread evenly between 0 and 90 degrees. The difference may leave
// [0, 1] where the fit is poor, and is clamped.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "materials/fresnel_terms.h"

namespace karat {
namespace {

constexpr std::size_t kAngles = 64;
constexpr std::size_t kExponents = 128;
// Below an exponent of 1 the slope at normal incidence would be infinite, which no surface has.
constexpr double kFirstExponent = 1.0, kLastExponent = 128.0;

struct Fit {
  double a = 0.0, alpha = 1.0;
};

double rescaled(double n, double k, double c) {
  const double f0 = normal_incidence(n, k);
  return f0 + (1.0 - f0) * fifth_power(1.0 - c);
}

// For a given alpha the best a is a quotient of two sums, and the error that it removes is
// (sum e b)^2 / sum b^2 with b = c (1 - c)^alpha: only alpha is searched for, first among fixed
// exponents whose b are tabulated once, then by the parabola through the best three.
class LeastSquares {
 public:
  LeastSquares() {
    for (std::size_t j = 0; j < kAngles; ++j) {
      const double theta = (static_cast<double>(j) + 0.5) / kAngles * (std::numbers::pi / 2.0);
      cosines_[j] = std::cos(theta);
      for (std::size_t e = 0; e < kExponents; ++e) {
        basis_[j][e] = cosines_[j] * std::pow(1.0 - cosines_[j], exponent(static_cast<double>(e)));
        squares_[e] += basis_[j][e] * basis_[j][e];
      }
    }
  }

  Fit fit(double n, double k) const {
    std::array<double, kAngles> errors;
    std::array<double, kExponents> products{};
    for (std::size_t j = 0; j < kAngles; ++j) {
      errors[j] = rescaled(n, k, cosines_[j]) - exact_.evaluate({n, k}, cosines_[j]).unpolarised;
      for (std::size_t e = 0; e < kExponents; ++e) products[e] += errors[j] * basis_[j][e];
    }
    const auto removed = [&](std::size_t e) { return products[e] * products[e] / squares_[e]; };
    std::size_t best = 0;
    for (std::size_t e = 1; e < kExponents; ++e) {
      if (removed(e) > removed(best)) best = e;
    }
    double place = static_cast<double>(best);
    if (best > 0 && best + 1 < kExponents) {
      const double below = removed(best - 1), above = removed(best + 1);
      const double curvature = below - 2.0 * removed(best) + above;
      if (curvature < 0.0) place += 0.5 * (below - above) / curvature;
    }
    return with_exponent(exponent(place), errors);
  }

 private:
  // Exponents are spread evenly in their logarithm.
  static double exponent(double place) {
    return kFirstExponent * std::pow(kLastExponent / kFirstExponent, place / (kExponents - 1));
  }

  Fit with_exponent(double alpha, const std::array<double, kAngles>& errors) const {
    double product = 0.0, square = 0.0;
    for (std::size_t j = 0; j < kAngles; ++j) {
      const double b = cosines_[j] * std::pow(1.0 - cosines_[j], alpha);
      product += errors[j] * b;
      square += b * b;
    }
    return {product / square, alpha};
  }

  const FresnelModel& exact_ = *Registry<FresnelModel>::instance().find("exact");
  std::array<double, kAngles> cosines_;
  std::array<std::array<double, kExponents>, kAngles> basis_;
  std::array<double, kExponents> squares_{};
};

const LeastSquares& least_squares() {
  static const LeastSquares instance;
  return instance;
}

// 2^x for x <= 0, within 2e-7 of it relatively; std::exp2 would keep the lanes from vectorising.
// Taylor series of 2^f over |f| <= 1/2, coefficients ln(2)^i / i!.
inline float exp2_of_negative(float x) {
  const float bounded = std::max(x, -125.0f);
  const int whole = static_cast<int>(bounded - 0.5f);
  const float f = bounded - static_cast<float>(whole);
  float p = 1.54035304e-4f;
  p = p * f + 1.33335581e-3f;
  p = p * f + 9.61812911e-3f;
  p = p * f + 5.55041087e-2f;
  p = p * f + 2.40226507e-1f;
  p = p * f + 6.93147181e-1f;
  p = p * f + 1.0f;
  return p * std::bit_cast<float>((whole + 127) << 23);
}

class CompensatedLazanyiFresnel final : public FresnelModel {
 public:
  std::string description() const override {
    return "lazanyi minus a cos (1 - cos)^alpha, fitted per wavelength, clamped to [0, 1]";
  }
  std::string source() const override {
    return "Lazanyi and Szirmay-Kalos, WSCG short papers 2005, 77-80; a and alpha fitted here";
  }

  FresnelTables prepare(const LatticeIndex& index) const override {
    FresnelTables tables{{lattice_of(index, normal_incidence), {}, {}}};
    for (int phase = 0; phase < kPhases; ++phase) {
      for (int i = 0; i < kLanes; ++i) {
        const Fit fit = least_squares().fit(index.n[phase][i], index.k[phase][i]);
        tables.planes[1][phase][i] = static_cast<float>(fit.a);
        tables.planes[2][phase][i] = static_cast<float>(fit.alpha);
      }
    }
    return tables;
  }

  // At normal incidence the logarithm is minus infinity and the power zero.
  SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                              float cos_theta) const override {
    const SampledSpectrum& f0 = tables.planes[0][phase];
    const SampledSpectrum& a = tables.planes[1][phase];
    const SampledSpectrum& alpha = tables.planes[2][phase];
    const float x = fifth_power(1.0f - cos_theta);
    const float logarithm = std::log2(1.0f - cos_theta);
    SampledSpectrum r;
    for (int i = 0; i < kLanes; ++i) {
      const float error = a[i] * cos_theta * exp2_of_negative(alpha[i] * logarithm);
      r[i] = std::clamp(f0[i] + (1.0f - f0[i]) * x - error, 0.0f, 1.0f);
    }
    return r;
  }

  Scalar evaluate(ComplexIndex index, double cos_theta) const override {
    const auto [n, k] = index;
    const Fit fit = least_squares().fit(n, k);
    const double error = fit.a * cos_theta * std::pow(1.0 - cos_theta, fit.alpha);
    const double r = rescaled(n, k, cos_theta) - error;
    return {std::nullopt, std::nullopt, std::clamp(r, 0.0, 1.0)};
  }
};

KARAT_REGISTER(FresnelModel, "lazanyi-compensated", CompensatedLazanyiFresnel);

}  // namespace
}  // namespace karat
