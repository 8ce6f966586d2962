// What every reflection model promises at its interface, asked of every registered one.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "tests/chi_square.h"
#include "tests/material_cases.h"

using namespace karat;

namespace {

constexpr int kHero = 5;

Vec3 direction(double theta, double phi) {
  return {static_cast<float>(std::sin(theta) * std::cos(phi)),
          static_cast<float>(std::sin(theta) * std::sin(phi)), static_cast<float>(std::cos(theta))};
}

const Bsdf& prepared(const Material& material, BsdfStorage& storage,
                     Transport transport = Transport::kImportance, int hero = kHero) {
  return *material.prepare({}, {7, hero}, transport, storage);
}

class Numbers {
 public:
  explicit Numbers(unsigned seed) : generator_(seed) {}
  float next() { return static_cast<float>(generator_() >> 8) * 0x1p-24f; }
  BsdfNumbers sample() { return {next(), {next(), next()}}; }
  Vec3 sphere() {
    return direction(std::acos(1.0 - 2.0 * double{next()}), 6.283185307 * double{next()});
  }

 private:
  std::mt19937 generator_;
};

std::vector<Vec3> views(const Material& material) {
  std::vector<Vec3> directions{direction(0.0, 0.0), direction(0.8, 0.6), direction(1.4, 4.0)};
  if (material.transmits()) directions.push_back(direction(2.2, 1.0));
  return directions;
}

// Cells of equal steps in theta and phi over the whole sphere, and one for "no sample".
struct SphereGrid {
  static constexpr int kTheta = 24, kPhi = 48, kCells = kTheta * kPhi;

  static std::size_t cell(Vec3 w) {
    const double theta = std::acos(std::clamp(double{w.z}, -1.0, 1.0));
    double phi = std::atan2(double{w.y}, double{w.x});
    if (phi < 0.0) phi += 2.0 * M_PI;
    const int i = std::min(static_cast<int>(theta / M_PI * kTheta), kTheta - 1);
    const int j = std::min(static_cast<int>(phi / (2.0 * M_PI) * kPhi), kPhi - 1);
    return static_cast<std::size_t>(i * kPhi + j);
  }

  // The integral of `density` over every cell by the midpoint rule; the last entry is what is
  // missing to 1.
  template <typename F>
  static std::vector<double> integrate(int steps, F&& density) {
    std::vector<double> cells(kCells + 1, 0.0);
    const double d_theta = M_PI / (kTheta * steps), d_phi = 2.0 * M_PI / (kPhi * steps);
    double total = 0.0;
    for (int i = 0; i < kTheta * steps; ++i) {
      const double theta = (i + 0.5) * d_theta, area = std::sin(theta) * d_theta * d_phi;
      for (int j = 0; j < kPhi * steps; ++j) {
        const double mass = double{density(direction(theta, (j + 0.5) * d_phi))} * area;
        cells[static_cast<std::size_t>(i / steps * kPhi + j / steps)] += mass;
        total += mass;
      }
    }
    cells[kCells] = 1.0 - total;
    return cells;
  }
};

struct HistogramOutcome {
  double p;
  double heaviest;  // the fraction of the lobe that one quadrature point carries, at most
};

HistogramOutcome compare_histograms(const Bsdf& bsdf, Vec3 wo, unsigned seed, int steps) {
  constexpr int kSamples = 60000;
  double highest = 0.0;
  std::vector<double> expected = SphereGrid::integrate(steps, [&](Vec3 wi) {
    const float pdf = bsdf.evaluate(wo, wi).pdf;
    highest = std::max(highest, double{pdf});
    return pdf;
  });
  for (double& e : expected) e *= kSamples;
  std::vector<double> observed(expected.size(), 0.0);
  Numbers numbers(seed);
  for (int i = 0; i < kSamples; ++i) {
    const auto s = bsdf.sample(wo, numbers.sample());
    observed[s ? SphereGrid::cell(s->wi) : SphereGrid::kCells] += 1.0;
  }
  const double solid_angle = 2.0 * M_PI * M_PI / (SphereGrid::kCells * steps * steps);
  // What the density lacks to 1 must be the samples that were none; it is a small difference, to
  // which the quadrature's error is not small, and no cell of the histogram.
  const double missing = std::abs(expected.back() - observed.back()) / kSamples;
  expected.pop_back(), observed.pop_back();
  const double p = missing < 0.01 ? test::chi_square_p_value(observed, expected) : 0.0;
  return {p, highest * solid_angle};
}

// A coarse quadrature first; where its own error may matter, a fine one of the same samples
// decides. Nothing for a lobe too narrow for that.
std::optional<double> p_value(const Bsdf& bsdf, Vec3 wo, unsigned seed) {
  constexpr int kCoarse = 6, kFine = 30;
  constexpr double kResolved = 0.005;
  const HistogramOutcome coarse = compare_histograms(bsdf, wo, seed, kCoarse);
  if (coarse.heaviest < kResolved && coarse.p > 0.01) return coarse.p;
  if (coarse.heaviest > kResolved * (kFine * kFine) / (kCoarse * kCoarse)) return std::nullopt;
  const HistogramOutcome fine = compare_histograms(bsdf, wo, seed, kFine);
  if (fine.heaviest > kResolved) return std::nullopt;
  return fine.p;
}

// How far the values of each lane move when wi does by a few of its roundings: what two ways to
// compute a value may differ by where it is steep (narrow lobes, grazing and critical angles).
SampledSpectrum sensitivity(const Bsdf& bsdf, Vec3 wo, Vec3 wi) {
  const SampledSpectrum centre = bsdf.evaluate(wo, wi).value;
  SampledSpectrum largest(0.0f);
  for (const Vec3 step : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0},
                          Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
    const SampledSpectrum moved = bsdf.evaluate(wo, normalize(wi + step * 1e-6f)).value;
    for (int i = 0; i < kLanes; ++i) {
      largest[i] = std::max(largest[i], std::abs(moved[i] - centre[i]));
    }
  }
  return largest;
}

bool near(float a, float b, float sensitivity) {
  return std::abs(a - b) <= 1e-4f * std::max(std::abs(a), std::abs(b)) + sensitivity + 1e-6f;
}

}  // namespace

TEST_CASE("every material's samples follow its density", "[bsdf]") {
  struct Outcome {
    std::string name;
    double p;
  };
  std::vector<Outcome> outcomes;
  for (const auto& [name, material] : test::material_cases()) {
    if (material->only_delta()) continue;
    BsdfStorage storage;
    const Bsdf& bsdf = prepared(*material, storage);
    unsigned seed = 1;
    for (const Vec3 wo : views(*material)) {
      const auto p = p_value(bsdf, wo, seed++);
      if (p) outcomes.push_back({name + " from z " + std::to_string(wo.z), *p});
    }
  }
  REQUIRE(outcomes.size() > 10);
  const double level = test::sidak_level(outcomes.size());
  for (const auto& [name, p] : outcomes) {
    CAPTURE(name, p, level);
    CHECK(p >= level);
  }
}

TEST_CASE("weight times density is the value, for every material", "[bsdf]") {
  for (const auto& [name, material] : test::material_cases()) {
    for (const Transport transport : {Transport::kRadiance, Transport::kImportance}) {
      BsdfStorage storage;
      const Bsdf& bsdf = prepared(*material, storage, transport);
      Numbers numbers(3);
      int mismatches = 0;
      for (int i = 0; i < 2000; ++i) {
        const Vec3 wo = numbers.sphere();
        const auto s = bsdf.sample(wo, numbers.sample());
        if (!s) continue;
        if ((s->lobes & lobe::kDelta) != 0) {
          mismatches += s->pdf != 1.0f;
          continue;
        }
        const BsdfValue v = bsdf.evaluate(wo, s->wi);
        const SampledSpectrum slack = sensitivity(bsdf, wo, s->wi);
        for (int lane = 0; lane < kLanes; ++lane) {
          mismatches += !near(v.value[lane], s->weight[lane] * s->pdf, slack[lane]);
        }
        // The density moves as its lane's value does.
        const float scale = s->weight[kHero] > 0.0f ? 1.0f / s->weight[kHero] : 0.0f;
        mismatches += !near(v.pdf, s->pdf, slack[kHero] * scale);
        mismatches += !near(bsdf.lane_pdfs(wo, s->wi)[kHero], s->pdf, slack[kHero] * scale);
      }
      CAPTURE(name, static_cast<int>(transport));
      CHECK(mismatches == 0);
    }
  }
}

TEST_CASE("samples state lobes that the model lists, unit directions and the right side",
          "[bsdf]") {
  for (const auto& [name, material] : test::material_cases()) {
    BsdfStorage storage;
    const Bsdf& bsdf = prepared(*material, storage);
    Numbers numbers(4);
    int wrong = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 wo = numbers.sphere();
      const auto s = bsdf.sample(wo, numbers.sample());
      if (!s) continue;
      wrong += std::abs(length(s->wi) - 1.0f) > 1e-5f;
      wrong += (s->lobes & ~bsdf.lobes()) != 0;
      const bool crosses = wo.z * s->wi.z < 0.0f;
      wrong += crosses != ((s->lobes & lobe::kTransmit) != 0);
      wrong += crosses == (s->relative_eta == 1.0f);
      wrong += !material->transmits() && (wo.z < 0.0f || s->wi.z < 0.0f);
      wrong += s->dispersive && !bsdf.dispersive();
    }
    CAPTURE(name);
    CHECK(wrong == 0);
  }
}

// f*(wo, wi) = f(wi, wo): the importance form is the radiance form with the directions exchanged.
// For reflection both forms are one, and this is Helmholtz reciprocity (Veach 1997, section 5.2).
TEST_CASE("exchanging the directions gives the adjoint of every material", "[bsdf]") {
  for (const auto& [name, material] : test::material_cases()) {
    BsdfStorage for_radiance, for_importance;
    const Bsdf& radiance = prepared(*material, for_radiance, Transport::kRadiance);
    const Bsdf& importance = prepared(*material, for_importance, Transport::kImportance);
    Numbers numbers(5);
    int mismatches = 0, compared = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 wo = numbers.sphere();
      const auto s = importance.sample(wo, numbers.sample());
      if (!s || (s->lobes & lobe::kDelta) != 0) continue;
      const Vec3 wi = s->wi;
      const SampledSpectrum there = importance.evaluate(wo, wi).value * (1.0f / std::abs(wi.z));
      const SampledSpectrum back = radiance.evaluate(wi, wo).value * (1.0f / std::abs(wo.z));
      const SampledSpectrum slack = sensitivity(importance, wo, wi) * (1.0f / std::abs(wi.z));
      const SampledSpectrum back_slack = sensitivity(radiance, wi, wo) * (1.0f / std::abs(wo.z));
      for (int lane = 0; lane < kLanes; ++lane) {
        mismatches += !near(there[lane], back[lane], slack[lane] + back_slack[lane]);
      }
      ++compared;
    }
    CAPTURE(name);
    CHECK(mismatches == 0);
    if (!material->only_delta()) CHECK(compared > 100);
  }
}

TEST_CASE("no material scatters more than it receives", "[bsdf]") {
  for (const auto& [name, material] : test::material_cases()) {
    BsdfStorage storage;
    const Bsdf& bsdf = prepared(*material, storage);
    for (const double theta : {0.0, 0.7, 1.2, 1.5, 1.56, 1.9, 3.0}) {
      const Vec3 wo = direction(theta, 0.4);
      if (wo.z < 0.0f && !material->transmits()) continue;
      // Stratified numbers; where wavelengths part, the mean over heroes counts every lane once.
      constexpr int kSide = 40;
      Numbers numbers(6);
      double total = 0.0, squares = 0.0;
      for (int i = 0; i < kSide * kSide; ++i) {
        const Vec2 u{(static_cast<float>(i % kSide) + numbers.next()) / kSide,
                     (static_cast<float>(i / kSide) + numbers.next()) / kSide};
        const auto s = bsdf.sample(wo, {numbers.next(), u});
        if (!s) continue;
        const double weight = double{s->weight[kHero]};
        total += weight, squares += weight * weight;
      }
      constexpr double kCount = double{kSide} * kSide;
      const double albedo = total / kCount;
      const double error = std::sqrt(std::max(0.0, squares / kCount - albedo * albedo) / kCount);
      CAPTURE(name, theta, albedo, error);
      // The estimate's own noise: weights of the hero lane are 1 at most but for the choice between
      // reflection and refraction, and the sampling of light scattered more than once.
      CHECK(albedo <= 1.0 + std::max(0.005, 4.0 * error));
    }
  }
}

TEST_CASE("no material returns anything but finite, non-negative numbers", "[bsdf]") {
  std::vector<Vec3> extremes{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
  for (const float z : {1e-20f, 1e-9f, 1e-7f, 1.1e-6f, 1e-4f, 0.5f, 0.999999f}) {
    const float r = std::sqrt(1.0f - z * z);
    for (const Vec3 w :
         {Vec3{r, 0, z}, Vec3{-r, 0, z}, Vec3{0, r, -z}, Vec3{0.6f * r, -0.8f * r, z}}) {
      extremes.push_back(w);
      extremes.push_back(-w);
    }
  }
  const float ends[]{0.0f, 1e-7f, 0.5f, 0.99999994f};
  const auto bad = [](const SampledSpectrum& s, float pdf) {
    bool negative = false;
    for (int i = 0; i < kLanes; ++i) negative |= s[i] < 0.0f;
    return !is_finite(s) || negative || !std::isfinite(pdf) || pdf < 0.0f;
  };
  for (const auto& [name, material] : test::material_cases()) {
    BsdfStorage storage;
    const Bsdf& bsdf = prepared(*material, storage, Transport::kRadiance);
    int wrong = 0;
    for (const Vec3 wo : extremes) {
      for (const Vec3 wi : extremes) {
        const BsdfValue v = bsdf.evaluate(wo, wi);
        wrong += bad(v.value, v.pdf) || bad(bsdf.lane_pdfs(wo, wi), 0.0f);
      }
      for (int i = 0; i < 64; ++i) {
        const auto s = bsdf.sample(wo, {ends[i / 16], {ends[i / 4 % 4], ends[i % 4]}});
        if (s) wrong += bad(s->weight, s->pdf) || !(std::abs(length(s->wi) - 1.0f) < 1e-4f);
      }
    }
    CAPTURE(name);
    CHECK(wrong == 0);
  }
}
