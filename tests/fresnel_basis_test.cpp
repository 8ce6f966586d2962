#include "materials/fresnel_basis.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "materials/fresnel_eval.h"
#include "tests/reference_fresnel.h"

using namespace karat;

namespace {

using Curve = std::vector<double>;

double dot(const Curve& a, const Curve& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// The first left singular vector by power iteration, orthogonal to `other` where that is given.
Curve first_vector(const std::vector<Curve>& curves, const Curve* other = nullptr) {
  Curve v(curves[0].size(), 1.0);
  for (int iteration = 0; iteration < 3000; ++iteration) {
    Curve next(v.size(), 0.0);
    for (const Curve& curve : curves) {
      const double weight = dot(curve, v);
      for (std::size_t i = 0; i < v.size(); ++i) next[i] += weight * curve[i];
    }
    if (other) {
      const double along = dot(next, *other) / dot(*other, *other);
      for (std::size_t i = 0; i < v.size(); ++i) next[i] -= along * (*other)[i];
    }
    const double length = std::sqrt(dot(next, next));
    for (double& x : next) x /= length;
    v = next;
  }
  return v;
}

// Scaled as the basis is, whose sign and length a singular vector leaves open.
double cosine_between(const Curve& a, const Curve& b) {
  return std::abs(dot(a, b)) / std::sqrt(dot(a, a) * dot(b, b));
}

}  // namespace

TEST_CASE("the basis is made of the singular vectors of its training set", "[fresnel]") {
  const FresnelBasis& basis = FresnelBasis::instance();
  Curve b1, b2, b3, cosines;
  for (int j = 0; j < FresnelBasis::kNodes; ++j) {
    const double u = j / double{FresnelBasis::kNodes - 1};
    cosines.push_back(u / (4.0 - 3.0 * u));
    const auto values = basis.at(cosines.back());
    b1.push_back(values.b1), b2.push_back(values.b2), b3.push_back(values.b3);
  }
  std::vector<Curve> normalised, residuals;
  for (const auto& [n, k] : FresnelBasis::training_set()) {
    const double f0 = reference::fresnel(n, k, 1.0).unpolarised();
    Curve curve, residual;
    for (std::size_t j = 0; j < cosines.size(); ++j) {
      const double r = cosines[j] > 0.0 ? reference::fresnel(n, k, cosines[j]).unpolarised() : 1.0;
      curve.push_back((r - f0) / (1.0 - f0));
      residual.push_back(r - f0 - (1.0 - f0) * b1[j]);
    }
    normalised.push_back(curve), residuals.push_back(residual);
  }
  CHECK(cosine_between(b1, first_vector(normalised)) == Approx(1.0).margin(1e-9));
  const Curve second = first_vector(residuals);
  CHECK(cosine_between(b2, second) == Approx(1.0).margin(1e-9));
  CHECK(cosine_between(b3, first_vector(residuals, &second)) == Approx(1.0).margin(1e-7));
  CHECK(b1.front() == 1.0);
  CHECK(b1.back() == 0.0);
  for (const Curve* b : {&b2, &b3}) {
    CHECK((*b).front() == 0.0);
    CHECK((*b).back() == 0.0);
    CHECK(*std::max_element(b->begin(), b->end()) == 1.0);
  }
}

TEST_CASE("the decomposition is exact at its matching angles, and its kernel is its sum",
          "[fresnel]") {
  const FresnelModel& model = *Registry<FresnelModel>::instance().find("fresnel-decomposition");
  const auto& basis = FresnelBasis::instance();
  std::mt19937_64 generator(22);
  std::uniform_real_distribution<double> uniform;
  double worst = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double n = 0.1 * std::pow(40.0, uniform(generator));
    const double k = std::pow(9.0, uniform(generator));
    CAPTURE(n, k);
    for (const double c : basis.matching_cosines()) {
      CHECK(model.evaluate({n, k}, c).unpolarised ==
            Approx(reference::fresnel(n, k, c).unpolarised()).margin(1e-12));
    }
    const double theta = 90.0 * uniform(generator);
    const double f0 = reference::fresnel(n, k, 1.0).unpolarised();
    const auto b = basis.at(std::sin(reference::radians(90.0 - theta)));
    const double sum = f0 + (1.0 - f0) * b.b1 + 0.1 * b.b2 - 0.04 * b.b3;
    for (const auto precision : {FresnelPrecision::kFloat, FresnelPrecision::kDouble}) {
      const double r =
          evaluate_fresnel(model, {{n, k, theta, 1.0}}, precision, {0.1, -0.04})[0].unpolarised;
      worst = std::max(worst, std::abs(r - sum));
    }
  }
  CHECK(worst <= 1e-6);
}
