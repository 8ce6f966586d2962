#include "materials/fresnel_compensation.h"

#include "materials/fresnel_terms.h"

namespace karat {
namespace {

constexpr std::size_t kExponents = 128;

// Exponents are spread evenly in their logarithm.
double exponent(double place) {
  return kLeastAlpha * std::pow(kLargestAlpha / kLeastAlpha, place / (kExponents - 1));
}

// For a given alpha the best a is a quotient of two sums, and the error that it removes is
// (sum e b)^2 / sum b^2 with b = c (1 - c)^alpha: only alpha is searched for, first among fixed
// exponents whose b are tabulated once, then by the parabola through the best three.
class LeastSquares {
 public:
  LeastSquares() {
    for (std::size_t j = 0; j < kFitAngles; ++j) {
      const double c = fit_cosines()[j];
      for (std::size_t e = 0; e < kExponents; ++e) {
        basis_[j][e] = c * std::pow(1.0 - c, exponent(static_cast<double>(e)));
        squares_[e] += basis_[j][e] * basis_[j][e];
      }
    }
  }

  Compensation fit(const FitAngles& errors) const {
    std::array<double, kExponents> products{};
    for (std::size_t j = 0; j < kFitAngles; ++j) {
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
  static Compensation with_exponent(double alpha, const FitAngles& errors) {
    double product = 0.0, square = 0.0;
    for (std::size_t j = 0; j < kFitAngles; ++j) {
      const double c = fit_cosines()[j], b = c * std::pow(1.0 - c, alpha);
      product += errors[j] * b;
      square += b * b;
    }
    return {product / square, alpha};
  }

  std::array<std::array<double, kExponents>, kFitAngles> basis_;
  std::array<double, kExponents> squares_{};
};

}  // namespace

double rescaled_schlick(ComplexIndex index, double cos_theta) {
  return normal_incidence(index.n, index.k) +
         normal_absorptance(index.n, index.k) * fifth_power(1.0 - cos_theta);
}

FitAngles rescaled_errors(ComplexIndex index) {
  FitAngles errors = exact_at_fit_cosines(index);
  for (std::size_t j = 0; j < kFitAngles; ++j) {
    errors[j] = rescaled_schlick(index, fit_cosines()[j]) - errors[j];
  }
  return errors;
}

Compensation fit_compensation(const FitAngles& errors) {
  static const LeastSquares least_squares;
  return least_squares.fit(errors);
}

}  // namespace karat
