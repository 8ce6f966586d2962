#include "materials/fresnel_compensation.h"

#include <utility>

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
// exponents whose b are tabulated once, then by Newton's method between the best one's neighbours.
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
    const auto tabulated = [](std::size_t e) { return exponent(static_cast<double>(e)); };
    double low = tabulated(best > 0 ? best - 1 : 0);
    double high = tabulated(std::min(best + 1, kExponents - 1));
    double alpha = tabulated(best);
    for (int i = 0; i < kSteps; ++i) {
      const Sums sums(alpha, errors);
      (sums.slope() > 0.0 ? low : high) = alpha;
      const double next = alpha - sums.slope() / sums.curvature();
      const bool inside = next >= low && next <= high;  // false for a NaN
      const double last = std::exchange(alpha, inside ? next : 0.5 * (low + high));
      if (std::abs(alpha - last) <= 1e-13 * alpha) break;
    }
    return {Sums(alpha, errors).strength(), alpha};
  }

 private:
  static constexpr int kSteps = 60;  // Newton takes 3 to 5; bisection ends in the last bit

  // Of one exponent: sum e b, sum b^2, and their first and second derivatives by alpha.
  struct Sums {
    double product = 0.0, product1 = 0.0, product2 = 0.0;
    double square = 0.0, square1 = 0.0, square2 = 0.0;

    Sums(double alpha, const FitAngles& errors) {
      for (std::size_t j = 0; j < kFitAngles; ++j) {
        const double c = fit_cosines()[j], log = std::log1p(-c);
        const double b = c * std::exp(alpha * log);
        product += errors[j] * b;
        product1 += errors[j] * b * log;
        product2 += errors[j] * b * log * log;
        square += b * b;
        square1 += 2.0 * b * b * log;
        square2 += 4.0 * b * b * log * log;
      }
    }
    double strength() const { return product / square; }
    // Of the logarithm of the error removed.
    double slope() const { return 2.0 * product1 / product - square1 / square; }
    double curvature() const {
      return 2.0 * (product2 * product - product1 * product1) / (product * product) -
             (square2 * square - square1 * square1) / (square * square);
    }
  };

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
