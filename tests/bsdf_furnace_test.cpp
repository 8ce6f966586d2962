// White furnaces: what rough interfaces scatter in all, against a double precision integral over
// microfacets that shares no code with them.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/facet_integral.h"
#include "tests/material_cases.h"

using namespace karat;
using namespace karat::facets;

namespace {

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
