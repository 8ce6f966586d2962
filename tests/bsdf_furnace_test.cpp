// White furnaces: what rough interfaces scatter in all, against a double precision integral over
// microfacets that shares no code with them.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "tests/material_cases.h"
#include "tests/reference_fresnel.h"

using namespace karat;

namespace {

struct Direction {
  double x, y, z;
};
double dot(Direction a, Direction b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// Slope density and Lambda from the tangent of a direction, alpha isotropic.
struct Surface {
  std::string name;
  std::function<double(double r2)> slopes;       // density of slope / alpha, r2 its square
  std::function<double(double tangent)> lambda;  // of alpha tan(theta)
};

Surface ggx() {
  return {"ggx", [](double r2) { return 1.0 / (M_PI * (1.0 + r2) * (1.0 + r2)); },
          [](double t) { return 0.5 * (std::sqrt(1.0 + t * t) - 1.0); }};
}

Surface beckmann() {
  return {"beckmann", [](double r2) { return std::exp(-r2) / M_PI; },
          [](double t) {
            if (!(t > 0.0)) return 0.0;
            const double a = 1.0 / t;
            return 0.5 * (std::erf(a) - 1.0 + std::exp(-a * a) * t / std::sqrt(M_PI));
          }};
}

struct Scattered {
  double reflected, refracted;
};

// Each facet m shows w an area D(m) <w.m> / cos, of which F is reflected and 1 - F refracted; what
// leaves is not shadowed with probability G2 (reflection) or G1 (refraction, both sides apart).
Scattered integrate_facets(const Surface& surface, double alpha, Direction w, double eta,
                           bool perfect) {
  const auto lambda = [&](Direction d) {
    return surface.lambda(alpha * std::hypot(d.x, d.y) / std::abs(d.z));
  };
  const double lambda_w = lambda(w);
  Scattered total{0.0, 0.0};
  constexpr int kSteps = 400;
  for (int i = 0; i < kSteps; ++i) {
    const double t = (i + 0.5) * 0.5 * M_PI / kSteps, r = std::tan(t);
    const double ring = surface.slopes(r * r) * r * (1.0 + r * r) * (0.5 * M_PI / kSteps);
    for (int j = 0; j < kSteps; ++j) {
      const double phi = (j + 0.5) * 2.0 * M_PI / kSteps;
      const double x = -alpha * r * std::cos(phi), y = -alpha * r * std::sin(phi);
      const double z = 1.0 / std::sqrt(1.0 + x * x + y * y);
      const Direction m{x * z, y * z, z};
      const double c = dot(w, m);
      if (!(c > 0.0)) continue;
      // Slopes' density is D cos^4 and d(slopes) = d(omega) / cos^3: D d(omega) = P d(slopes) /
      // cos.
      const double shown = ring * 2.0 * M_PI / kSteps / z * c / w.z;
      const double f = perfect ? 1.0 : reference::fresnel(eta, 0.0, c).unpolarised();
      const Direction up{2 * c * m.x - w.x, 2 * c * m.y - w.y, 2 * c * m.z - w.z};
      if (up.z > 0.0) total.reflected += f * shown / (1.0 + lambda_w + lambda(up));
      const double far2 = 1.0 - (1.0 - c * c) / (eta * eta);
      if (perfect || !(far2 > 0.0)) continue;
      const double along = c / eta - std::sqrt(far2);
      const Direction down{m.x * along - w.x / eta, m.y * along - w.y / eta,
                           m.z * along - w.z / eta};
      if (down.z < 0.0) {
        total.refracted += (1.0 - f) * shown / ((1.0 + lambda_w) * (1.0 + lambda(down)));
      }
    }
  }
  return total;
}

Scattered sampled(const Material& material, Vec3 wo) {
  BsdfStorage storage;
  const Bsdf& bsdf = *material.prepare({}, {3, 2}, Transport::kImportance, storage);
  constexpr int kSide = 150, kLobes = 4;
  double reflected = 0.0, refracted = 0.0;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      for (int l = 0; l < kLobes; ++l) {
        const Vec2 u{(static_cast<float>(i) + 0.5f) / kSide,
                     (static_cast<float>(j) + 0.5f) / kSide};
        // The lobe's numbers are shifted from point to point (golden ratio), so that they are even.
        const double shifted = (l + 0.6180339887 * (i * kSide + j)) / kLobes;
        const auto s =
            bsdf.sample(wo, {static_cast<float>(shifted - std::floor(shifted)) * 0.9999f, u});
        if (!s) continue;
        ((s->lobes & lobe::kReflect) != 0 ? reflected : refracted) += double{s->weight[2]};
      }
    }
  }
  constexpr double kCount = double{kSide} * kSide * kLobes;
  return {reflected / kCount, refracted / kCount};
}

}  // namespace

TEST_CASE("a rough metal that absorbs nothing reflects what integration gives, never above 1",
          "[bsdf]") {
  for (const Surface& surface : {ggx(), beckmann()}) {
    for (const double alpha : {0.1, 0.5, 1.0}) {
      Parameters values;
      values.set("nk", constant_index({1e-3, 100.0}));  // R = 1 - 4e-7
      values.set("distribution", surface.name);
      values.set("alpha", alpha);
      const auto material = test::make_material("conductor", values);
      for (const double theta : {0.05, 0.8, 1.3, 1.5}) {
        const Direction w{std::sin(theta), 0.0, std::cos(theta)};
        const double expected = integrate_facets(surface, alpha, w, 1.0, true).reflected;
        const double found =
            sampled(*material, {static_cast<float>(w.x), 0.0f, static_cast<float>(w.z)}).reflected;
        CAPTURE(surface.name, alpha, theta);
        CHECK(found == Approx(expected).margin(2e-3));
        CHECK(found <= 1.0);
      }
    }
  }
}

TEST_CASE("a rough dielectric reflects and refracts what integration gives", "[bsdf]") {
  for (const Surface& surface : {ggx(), beckmann()}) {
    for (const double alpha : {0.01, 0.2, 0.6}) {
      for (const double eta : {1.5, 1.0 / 1.5}) {
        Parameters values;
        values.set("interior", constant_index({1.5, 0.0}));
        values.set("distribution", surface.name);
        values.set("alpha", alpha);
        const auto material = test::make_material("dielectric", values);
        for (const double theta : {0.05, 0.6, 1.3}) {
          const Direction w{std::sin(theta), 0.0, std::cos(theta)};
          const Scattered expected = integrate_facets(surface, alpha, w, eta, false);
          const float side = eta > 1.0 ? 1.0f : -1.0f;  // wo.z < 0 is inside
          const Scattered found =
              sampled(*material, {static_cast<float>(w.x), 0.0f, side * static_cast<float>(w.z)});
          CAPTURE(surface.name, alpha, eta, theta);
          CHECK(found.reflected == Approx(expected.reflected).margin(3e-3));
          CHECK(found.refracted == Approx(expected.refracted).margin(3e-3));
          CHECK(found.reflected + found.refracted <= 1.0 + 1e-3);
          if (alpha < 0.02) CHECK(found.reflected + found.refracted > 0.995);
        }
      }
    }
  }
}

TEST_CASE("smooth interfaces lose nothing", "[bsdf]") {
  Parameters glass;
  glass.set("interior", constant_index({1.5, 0.0}));
  const auto dielectric = test::make_material("dielectric", glass);
  const auto mirror = test::make_material("mirror", {});
  for (const double theta : {0.0, 0.6, 1.3, 1.5}) {
    const auto x = static_cast<float>(std::sin(theta)), z = static_cast<float>(std::cos(theta));
    CHECK(sampled(*mirror, {x, 0.0f, z}).reflected == Approx(1.0));
    for (const float side : {1.0f, -1.0f}) {
      const Scattered s = sampled(*dielectric, {x, 0.0f, side * z});
      const double f =
          reference::fresnel(side > 0.0f ? 1.5 : 1.0 / 1.5, 0.0, std::cos(theta)).unpolarised();
      CHECK(s.reflected == Approx(f).margin(1e-3));
      CHECK(s.refracted == Approx(1.0 - f).margin(1e-3));
    }
  }
}
