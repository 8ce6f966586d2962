#include "render/light_selection.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "tests/chi_square.h"

using namespace karat;

namespace {

// Power and bounds are all that the selection may know.
class Lamp final : public Light {
 public:
  Lamp(float power, Bounds bounds) : power_(power), bounds_(bounds) {}
  std::optional<LightSample> sample(const Vec3&, const Vec2&, int) const override {
    return std::nullopt;
  }
  float pdf(const Vec3&, const Vec3&, const SurfaceHit*) const override { return 0.0f; }
  SampledSpectrum radiance(const Vec3&, const SurfaceHit*, int) const override {
    return SampledSpectrum(0.0f);
  }
  float power(float) const override { return power_; }
  Bounds bounds() const override { return bounds_; }

 private:
  float power_;
  Bounds bounds_;
};

using Lights = std::vector<std::unique_ptr<const Light>>;

// Near and far, weak and strong, a point, an environment.
Lights mixed_lights() {
  Lights lights;
  lights.push_back(std::make_unique<Lamp>(10.0f, Light::Bounds{{1, 0, 3}, 0.5f}));
  lights.push_back(std::make_unique<Lamp>(300.0f, Light::Bounds{{-8, 2, 3}, 2.0f}));
  lights.push_back(std::make_unique<Lamp>(0.5f, Light::Bounds{{0, 0, 0.5f}, 0.0f}));
  lights.push_back(std::make_unique<Lamp>(2000.0f, Light::Bounds{}));
  return lights;
}

// What a batch at one point chooses, path i with the number u[i].
LightSelection::Choice choices(const LightSelection& selection, const Vec3& point,
                               const BatchFloat& u) {
  BatchVec3 points;
  for (int i = 0; i < kBatch; ++i) points.set(i, point);
  LightSelection::Choice choice;
  selection.choose(points, u, choice);
  return choice;
}

struct OneChoice {
  const Light* light;
  float probability, total;
};
OneChoice choose(const LightSelection& selection, const Vec3& point, float number) {
  BatchFloat u;
  u[kBatch - 1] = number;
  const auto choice = choices(selection, point, u);
  return {choice.light[kBatch - 1], choice.probability[kBatch - 1], choice.total[kBatch - 1]};
}

float probability(const LightSelection& selection, const Vec3& point, const Light* light) {
  return selection.probability(point, light, choose(selection, point, 0.5f).total);
}

const Vec3 kPoints[] = {{0, 0, 0}, {0, 0, 0.5f}, {1, 0, 3}, {-30, 4, 1}, {1e4f, -1e4f, 3}};

}  // namespace

TEST_CASE("probabilities of the lights sum to one, and none that shines is left out",
          "[light_selection]") {
  const Lights lights = mixed_lights();
  const LightSelection selection(lights, 10.0f);
  for (const Vec3 point : kPoints) {
    double sum = 0.0;
    for (const auto& light : lights) {
      const float p = probability(selection, point, light.get());
      CHECK(p > 0.0f);
      sum += p;
    }
    CHECK(sum == Approx(1.0).epsilon(1e-5));
  }
}

TEST_CASE("lights are chosen with the probabilities that are told", "[light_selection]") {
  const Lights lights = mixed_lights();
  const LightSelection selection(lights, 10.0f);
  constexpr int kCount = 6250 * kBatch;
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform;
  for (const Vec3 point : kPoints) {
    std::vector<double> counted(lights.size()), expected(lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i) {
      expected[i] = double{probability(selection, point, lights[i].get())} * kCount;
    }
    bool told = true;
    for (int n = 0; n < kCount; n += kBatch) {
      BatchFloat u;
      for (int i = 0; i < kBatch; ++i) u[i] = std::min(uniform(random), 0x1.fffffep-1f);
      const auto choice = choices(selection, point, u);
      for (int i = 0; i < kBatch; ++i) {
        REQUIRE(choice.light[i]);
        const float expected_probability =
            selection.probability(point, choice.light[i], choice.total[i]);
        told &= std::abs(choice.probability[i] - expected_probability) < 1e-6f;
        for (std::size_t l = 0; l < lights.size(); ++l) {
          counted[l] += choice.light[i] == lights[l].get();
        }
      }
    }
    CHECK(told);
    CHECK(test::chi_square_p_value(counted, expected) > test::sidak_level(std::size(kPoints)));
  }
}

TEST_CASE("the ends of the random number choose lights that shine", "[light_selection]") {
  Lights lights;
  lights.push_back(std::make_unique<Lamp>(0.0f, Light::Bounds{{0, 0, 1}, 1.0f}));
  lights.push_back(std::make_unique<Lamp>(1.0f, Light::Bounds{{0, 0, 2}, 1.0f}));
  lights.push_back(std::make_unique<Lamp>(0.0f, Light::Bounds{{0, 0, 3}, 1.0f}));
  const LightSelection selection(lights, 1.0f);
  for (const float u : {0.0f, 0.5f, 0x1.fffffep-1f}) {
    const auto choice = choose(selection, {0, 0, 0}, u);
    CHECK(choice.light == lights[1].get());
    CHECK(choice.probability == 1.0f);
  }
}

TEST_CASE("one light is always chosen; without lights, or without any power, none is",
          "[light_selection]") {
  Lights lights;
  const LightSelection none(lights, 1.0f);
  CHECK(choose(none, {0, 0, 0}, 0.5f).light == nullptr);

  lights.push_back(std::make_unique<Lamp>(3.0f, Light::Bounds{{0, 0, 1}, 0.5f}));
  const LightSelection one(lights, 1.0f);
  CHECK(choose(one, {5, 5, 5}, 0.999f).light == lights[0].get());
  CHECK(probability(one, {5, 5, 5}, lights[0].get()) == 1.0f);

  Lights dark;
  dark.push_back(std::make_unique<Lamp>(0.0f, Light::Bounds{{0, 0, 1}, 0.5f}));
  dark.push_back(std::make_unique<Lamp>(0.0f, Light::Bounds{}));
  const LightSelection black(dark, 1.0f);
  CHECK(choose(black, {0, 0, 0}, 0.5f).light == nullptr);
  CHECK(probability(black, {0, 0, 0}, dark[0].get()) == 0.0f);
}

TEST_CASE("a nearer lamp is chosen more often than the same lamp far away", "[light_selection]") {
  Lights lights;
  for (const float z : {1.0f, 10.0f}) {
    lights.push_back(std::make_unique<Lamp>(1.0f, Light::Bounds{{0, 0, z}, 0.1f}));
  }
  const LightSelection selection(lights, 10.0f);
  // Inverse squares of the distances: 100 to 1.
  CHECK(probability(selection, {0, 0, 0}, lights[0].get()) == Approx(100.0 / 101.0));
  CHECK(probability(selection, {0, 0, 5.5f}, lights[0].get()) == Approx(0.5));
}
