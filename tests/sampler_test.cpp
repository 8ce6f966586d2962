#include "render/sampler.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <vector>

using namespace karat;

namespace {

// All pairs of numbers of a camera sample and its first vertices, for samples [0, count) of a
// pixel.
std::vector<std::vector<Vec2>> pairs_of(SamplerKind kind, std::uint32_t seed, int count) {
  std::vector<std::vector<Vec2>> pairs(2 + 2 * 4);
  Sampler sampler(kind, seed);
  for (int s = 0; s < count; ++s) {
    sampler.start(7, 11, static_cast<std::uint32_t>(s));
    const CameraNumbers camera = sampler.camera();
    pairs[0].push_back(camera.pixel);
    pairs[1].push_back({camera.phase, camera.hero});
    for (std::size_t depth = 0; depth < 4; ++depth) {
      const VertexNumbers u = sampler.vertex(static_cast<int>(depth));
      pairs[2 + 2 * depth].push_back(u.bsdf);
      pairs[3 + 2 * depth].push_back(u.light);
    }
  }
  return pairs;
}

}  // namespace

TEST_CASE("every pair of dimensions is a (0, m, 2)-net over a power of two of samples",
          "[sampler]") {
  constexpr int kLog = 6, kCount = 1 << kLog;
  for (const auto& points : pairs_of(SamplerKind::kSobol, 3, kCount)) {
    for (int columns = 0; columns <= kLog; ++columns) {  // elementary intervals 2^-c by 2^-(m - c)
      std::set<std::pair<int, int>> cells;
      for (const Vec2& p : points) {
        cells.insert({static_cast<int>(std::ldexp(p.x, columns)),
                      static_cast<int>(std::ldexp(p.y, kLog - columns))});
      }
      CHECK(cells.size() == static_cast<std::size_t>(kCount));
    }
  }
}

TEST_CASE("numbers lie in [0, 1) and depend on pixel, sample, seed and nothing else", "[sampler]") {
  const auto first = pairs_of(SamplerKind::kSobol, 3, 64);
  const auto again = pairs_of(SamplerKind::kSobol, 3, 64);
  const auto other = pairs_of(SamplerKind::kSobol, 4, 64);
  int equal = 0;
  for (std::size_t p = 0; p < first.size(); ++p) {
    for (std::size_t i = 0; i < first[p].size(); ++i) {
      CHECK((first[p][i].x >= 0.0f && first[p][i].x < 1.0f));
      CHECK((first[p][i].x == again[p][i].x && first[p][i].y == again[p][i].y));
      equal += first[p][i].x == other[p][i].x;
    }
  }
  CHECK(equal <= 1);
}

TEST_CASE("a vertex gets the same numbers in whatever order vertices are asked for", "[sampler]") {
  Sampler sampler(SamplerKind::kSobol, 0);
  sampler.start(1, 2, 3);
  const float later = sampler.vertex(5).bsdf.x;
  sampler.vertex(0);
  CHECK(sampler.vertex(5).bsdf.x == later);
}

TEST_CASE("different pairs of a pixel are uncorrelated", "[sampler]") {
  constexpr int kCount = 4096;
  for (const SamplerKind kind : {SamplerKind::kSobol, SamplerKind::kIndependent}) {
    const auto pairs = pairs_of(kind, 1, kCount);
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      for (std::size_t q = p + 1; q < pairs.size(); ++q) {
        double covariance = 0.0;
        for (std::size_t i = 0; i < kCount; ++i) {
          covariance += (double{pairs[p][i].x} - 0.5) * (double{pairs[q][i].x} - 0.5);
        }
        // Variance of a product of two independent uniforms about 1/2 is 1/144: six deviations.
        CHECK(std::abs(covariance / kCount) < 6.0 / 12.0 / std::sqrt(double{kCount}));
      }
    }
  }
}

TEST_CASE("Sobol pairs integrate a smooth function far better than independent ones", "[sampler]") {
  constexpr int kCount = 1024;
  const auto error = [](SamplerKind kind) {
    double worst = 0.0;
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
      double sum = 0.0;
      const auto pairs = pairs_of(kind, seed, kCount);
      for (const Vec2& p : pairs[2]) {
        sum += std::exp(double{p.x} * double{p.y});
      }
      worst = std::max(worst, std::abs(sum / kCount - 1.3179021514544038));  // Ei(1) - gamma
    }
    return worst;
  };
  CHECK(error(SamplerKind::kSobol) < 0.05 * error(SamplerKind::kIndependent));
}

TEST_CASE("a batch gets the numbers that its paths get one by one", "[sampler]") {
  for (const SamplerKind kind : {SamplerKind::kSobol, SamplerKind::kIndependent}) {
    BatchSampler batch(kind, 9);
    Sampler one(kind, 9);
    batch.start_block(8, 120);
    batch.start_sample(37);
    BatchCameraNumbers camera;
    batch.camera(camera);
    BatchVertexNumbers vertices[3];
    for (int depth = 0; depth < 3; ++depth) batch.vertex(depth, vertices[depth]);
    for (int i = 0; i < kBatch; ++i) {
      const auto place = static_cast<std::uint32_t>(i);
      one.start(8 + place % kBlock, 120 + place / kBlock, 37);
      const CameraNumbers c = one.camera();
      CHECK((camera.pixel[0][i] == c.pixel.x && camera.pixel[1][i] == c.pixel.y));
      CHECK((camera.lens[0][i] == c.lens.x && camera.lens[1][i] == c.lens.y));
      CHECK((camera.phase[i] == c.phase && camera.hero[i] == c.hero));
      Sampler path = batch.path(i);
      for (int depth = 0; depth < 3; ++depth) {
        const VertexNumbers v = one.vertex(depth), same = path.vertex(depth);
        const BatchVertexNumbers& u = vertices[depth];
        CHECK((u.bsdf[0][i] == v.bsdf.x && u.bsdf[1][i] == v.bsdf.y));
        CHECK((u.light[0][i] == v.light.x && u.light[1][i] == v.light.y));
        CHECK((u.lobe[i] == v.lobe && u.light_choice[i] == v.light_choice));
        CHECK((u.roulette[i] == v.roulette && same.bsdf.x == v.bsdf.x));
      }
    }
  }
}
