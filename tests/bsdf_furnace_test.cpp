// White furnaces: what rough interfaces scatter in all, against a double precision integral over
// microfacets that shares no code with them.
#include <array>
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

TEST_CASE("a rough dielectric that scatters once reflects and refracts what integration gives",
          "[bsdf]") {
  for (const Surface& surface : {ggx(), beckmann()}) {
    for (const double alpha : {0.01, 0.2, 0.6}) {
      for (const double eta : {1.5, 1.0 / 1.5}) {
        Parameters values;
        values.set("interior", constant_index({1.5, 0.0}));
        values.set("distribution", surface.name);
        values.set("alpha", alpha);
        values.set("multiple_scattering", false);
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

namespace {

std::shared_ptr<const Material> rough_glass(const IndexTablePtr& interior, Vec2 alpha,
                                            const std::string& distribution) {
  Parameters values;
  values.set("interior", interior);
  values.set("distribution", distribution);
  values.set("alpha_x", double{alpha.x});
  values.set("alpha_y", double{alpha.y});
  return test::make_material("dielectric", values);
}

IndexTablePtr dispersive_glass() {
  return index_from_spectra(table_spectrum({380.0, 780.0}, {1.9, 1.5}, "n"), constant_spectrum(0.0),
                            {});
}

// The integral of the whole value over both hemispheres, in double precision, lane by lane.
std::array<double, kLanes> integrated(const Bsdf& bsdf, Vec3 wo, int steps) {
  std::array<double, kLanes> sums{};
  const double d_theta = M_PI / (2 * steps), d_phi = M_PI / steps;
  for (int i = 0; i < 2 * steps; ++i) {
    const double theta = (i + 0.5) * d_theta;
    for (int j = 0; j < 2 * steps; ++j) {
      const double phi = (j + 0.5) * d_phi;
      const Vec3 wi{static_cast<float>(std::sin(theta) * std::cos(phi)),
                    static_cast<float>(std::sin(theta) * std::sin(phi)),
                    static_cast<float>(std::cos(theta))};
      const SampledSpectrum value = bsdf.evaluate(wo, wi).value;
      for (int lane = 0; lane < kLanes; ++lane) {
        sums[static_cast<std::size_t>(lane)] +=
            double{value[lane]} * std::sin(theta) * d_theta * d_phi;
      }
    }
  }
  return sums;
}

}  // namespace

// The grid is what limits this: it meets the edges of total reflection and of the horizon with
// steps of half a degree, and misses alpha below 0.2 (rendered furnaces see those).
TEST_CASE("the value of a rough dielectric integrates to 1 from both sides", "[bsdf]") {
  const std::vector<IndexTablePtr> media{constant_index({1.5, 0.0}), constant_index({0.6, 0.0}),
                                         dispersive_glass()};
  double mean = 0.0;
  int count = 0;
  for (const IndexTablePtr& medium : media) {
    for (const std::string distribution : {"ggx", "beckmann"}) {
      for (const Vec2 alpha : {Vec2{0.2f, 0.2f}, Vec2{0.5f, 0.5f}, Vec2{0.2f, 0.6f}}) {
        const auto material = rough_glass(medium, alpha, distribution);
        BsdfStorage storage;
        const Bsdf& bsdf = *material->prepare({}, {3, 2}, Transport::kImportance, storage);
        for (const double theta : {0.1, 0.75, 1.3}) {
          for (const float side : {1.0f, -1.0f}) {
            const Vec3 wo{static_cast<float>(std::sin(theta) * 0.8),
                          static_cast<float>(std::sin(theta) * 0.6),
                          side * static_cast<float>(std::cos(theta))};
            const auto sums = integrated(bsdf, wo, 130);
            for (int lane = 0; lane < kLanes; lane += kLanes / 2) {
              const double sum = sums[static_cast<std::size_t>(lane)];
              CAPTURE(distribution, alpha.x, alpha.y, wo.z, lane, count);
              CHECK(sum == Approx(1.0).margin(5e-3));
              mean += sum, ++count;
            }
          }
        }
      }
    }
  }
  CHECK(mean / count == Approx(1.0).margin(5e-4));
}

TEST_CASE("no sample of a rough dielectric is lost, and their energy is 1", "[bsdf]") {
  for (const IndexTablePtr& medium :
       {constant_index({1.5, 0.0}), constant_index({1.01, 0.0}), dispersive_glass()}) {
    for (const std::string distribution : {"ggx", "beckmann"}) {
      for (const Vec2 alpha : {Vec2{0.05f, 0.05f}, Vec2{0.5f, 0.5f}, Vec2{0.1f, 0.4f}}) {
        const auto material = rough_glass(medium, alpha, distribution);
        for (const double theta : {0.05, 0.8, 1.3}) {
          for (const float side : {1.0f, -1.0f}) {
            const Scattered found =
                sampled(*material, {static_cast<float>(std::sin(theta)), 0.0f,
                                    side * static_cast<float>(std::cos(theta))});
            CAPTURE(distribution, alpha.x, alpha.y, theta, side);
            CHECK(found.reflected + found.refracted == Approx(1.0).margin(1e-3));
          }
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
