// What every registered distribution of microfacet normals promises.
#include "materials/microfacet.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "tests/chi_square.h"

using namespace karat;

namespace {

using Distributions = Registry<MicrofacetDistribution>;

const std::vector<Vec2> kWidths{{0.02f, 0.02f}, {0.1f, 0.1f}, {0.5f, 0.5f},
                                {1.0f, 1.0f},   {0.1f, 0.4f}, {0.8f, 0.05f}};

Vec3 direction(double theta, double phi) {
  return {static_cast<float>(std::sin(theta) * std::cos(phi)),
          static_cast<float>(std::sin(theta) * std::sin(phi)), static_cast<float>(std::cos(theta))};
}

// The integral of D(m) g(m) over the hemisphere by midpoints in the slopes' elliptical coordinates:
// slope = alpha tan(t) (cos phi, sin phi), d(slopes) = d(omega) / cos^3.
template <typename G>
double integrate_normals(const MicrofacetDistribution& distribution, Vec2 alpha, int steps, G&& g) {
  double sum = 0.0;
  const double dt = 0.5 * M_PI / steps, d_phi = 2.0 * M_PI / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) * dt, r = std::tan(t), dr = dt * (1.0 + r * r);
    for (int j = 0; j < steps; ++j) {
      const double phi = (j + 0.5) * d_phi;
      const double x = double{alpha.x} * r * std::cos(phi), y = double{alpha.y} * r * std::sin(phi);
      const double z = 1.0 / std::sqrt(1.0 + x * x + y * y);
      const Vec3 m{static_cast<float>(-x * z), static_cast<float>(-y * z), static_cast<float>(z)};
      const double solid_angle = z * z * z * r * dr * d_phi * double{alpha.x} * double{alpha.y};
      sum += double{distribution.d(m, alpha)} * g(m) * solid_angle;
    }
  }
  return sum;
}

template <typename F>
void for_each_distribution(F&& f) {
  for (const std::string& name : Distributions::instance().names()) {
    CHECK_FALSE(Distributions::instance().find(name)->description().empty());
    for (const Vec2 alpha : kWidths) f(name, *Distributions::instance().find(name), alpha);
  }
}

float uniform(std::mt19937& generator) { return static_cast<float>(generator() >> 8) * 0x1p-24f; }

}  // namespace

TEST_CASE("the projected area of all microfacets is that of the surface", "[microfacet]") {
  for_each_distribution([](const std::string& name, const MicrofacetDistribution& d, Vec2 alpha) {
    const double area = integrate_normals(d, alpha, 300, [](Vec3 m) { return double{m.z}; });
    CAPTURE(name, alpha.x, alpha.y);
    CHECK(area == Approx(1.0).margin(1e-3));
  });
}

// G1(w) integral of D(m) max(0, w.m) = w.z defines Lambda (Heitz 2014, equations 16 and 43): the
// visible normals' density is normalised exactly when Lambda is right.
TEST_CASE("Lambda follows from the distribution by integration", "[microfacet]") {
  for_each_distribution([](const std::string& name, const MicrofacetDistribution& d, Vec2 alpha) {
    for (const double theta : {0.0, 0.5, 1.0, 1.4, 1.55}) {
      const Vec3 w = direction(theta, 0.7);
      const double visible = integrate_normals(
          d, alpha, 400, [&](Vec3 m) { return std::max(0.0, double{dot(w, m)}); });
      CAPTURE(name, alpha.x, alpha.y, theta);
      CHECK(visible / double{w.z} == Approx(1.0 + double{d.lambda(w, alpha)}).epsilon(3e-3));
      CHECK(d.lambda(w, alpha) == d.lambda(-w, alpha));
    }
  });
}

TEST_CASE("sampled normals follow the density of visible normals", "[microfacet]") {
  constexpr int kRadial = 24, kAngular = 24, kSteps = 12, kSamples = 60000;
  std::vector<std::pair<std::string, double>> outcomes;
  for_each_distribution([&](const std::string& name, const MicrofacetDistribution& d, Vec2 alpha) {
    for (const double theta : {0.0, 0.6, 1.3, 1.55}) {
      const Vec3 w = direction(theta, 2.1);
      // Cells of equal steps in the elliptical coordinates of the slopes, which fit every width.
      std::vector<double> expected(kRadial * kAngular, 0.0), observed(expected.size(), 0.0);
      const double dt = 0.5 * M_PI / (kRadial * kSteps), d_phi = 2.0 * M_PI / (kAngular * kSteps);
      for (int i = 0; i < kRadial * kSteps; ++i) {
        const double r = std::tan((i + 0.5) * dt);
        for (int j = 0; j < kAngular * kSteps; ++j) {
          const double phi = (j + 0.5) * d_phi;
          const double x = double{alpha.x} * r * std::cos(phi);
          const double y = double{alpha.y} * r * std::sin(phi);
          const double z = 1.0 / std::sqrt(1.0 + x * x + y * y);
          const Vec3 m{static_cast<float>(x * z), static_cast<float>(y * z), static_cast<float>(z)};
          const double density = double{d.d(m, alpha)} * double{d.g1(w, alpha)} *
                                 std::max(0.0, double{dot(w, m)}) / double{w.z};
          expected[static_cast<std::size_t>(i / kSteps * kAngular + j / kSteps)] +=
              kSamples * density * z * z * z * r * (1.0 + r * r) * dt * d_phi * double{alpha.x} *
              double{alpha.y};
        }
      }
      std::mt19937 generator(21);
      for (int i = 0; i < kSamples; ++i) {
        const Vec2 u{uniform(generator), uniform(generator)};
        const Vec3 m = d.sample_visible(w, alpha, u);
        const double x = double{m.x} / double{m.z} / double{alpha.x};
        const double y = double{m.y} / double{m.z} / double{alpha.y};
        double phi = std::atan2(y, x);
        if (phi < 0.0) phi += 2.0 * M_PI;
        const int ring = std::min(
            kRadial - 1, static_cast<int>(std::atan(std::hypot(x, y)) / (0.5 * M_PI) * kRadial));
        const int sector = std::min(kAngular - 1, static_cast<int>(phi / (2.0 * M_PI) * kAngular));
        observed[static_cast<std::size_t>(ring * kAngular + sector)] += 1.0;
      }
      outcomes.emplace_back(name + " alpha " + std::to_string(alpha.x) + " " +
                                std::to_string(alpha.y) + " theta " + std::to_string(theta),
                            test::chi_square_p_value(observed, expected));
    }
  });
  const double level = test::sidak_level(outcomes.size());
  for (const auto& [name, p] : outcomes) {
    CAPTURE(name, p, level);
    CHECK(p >= level);
  }
}

TEST_CASE("distributions are finite and sampled normals visible at every angle", "[microfacet]") {
  for_each_distribution([](const std::string& name, const MicrofacetDistribution& d, Vec2 alpha) {
    int wrong = 0;
    for (const float z : {2e-6f, 1e-4f, 0.01f, 0.5f, 0.9999f, 1.0f}) {
      const Vec3 w{std::sqrt(1.0f - z * z), 0.0f, z};
      wrong += !std::isfinite(d.d(w, alpha)) || d.d(w, alpha) < 0.0f;
      wrong += !std::isfinite(d.lambda(w, alpha)) || d.lambda(w, alpha) < 0.0f;
      for (const float u : {0.0f, 1e-7f, 0.3f, 0.5f, 0.99999994f}) {
        for (const float v : {0.0f, 1e-7f, 0.3f, 0.5f, 0.99999994f}) {
          const Vec3 m = d.sample_visible(w, alpha, {u, v});
          wrong += !(std::abs(length(m) - 1.0f) < 1e-5f);
          wrong += !(m.z > 0.0f) || !std::isfinite(d.d(m, alpha));
          wrong += dot(w, m) < -1e-5f;
        }
      }
    }
    CAPTURE(name, alpha.x, alpha.y);
    CHECK(wrong == 0);
    CHECK(d.d({0, 0, 1}, alpha) == Approx(kInvPi / (alpha.x * alpha.y)));
    CHECK(d.d({1, 0, 0}, alpha) <= d.d({0, 0, 1}, alpha));
  });
}
