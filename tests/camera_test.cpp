#include "render/camera.h"

#include <catch2/catch.hpp>
#include <map>

#include "default_parameters.h"
#include "spectral/support/error.h"

using namespace karat;

namespace {

std::unique_ptr<const Camera> make(const std::map<std::string, ParameterValue>& values, int width,
                                   int height) {
  const CameraType* type = Registry<CameraType>::instance().find("perspective");
  REQUIRE(type);
  Parameters parameters = default_parameters(type->parameters());
  for (const auto& [name, value] : values) parameters.set(name, value);
  return type->create(parameters, width, height);
}

void check_equal(Vec3 a, Vec3 b, float margin = 1e-6f) {
  CHECK(a.x == Approx(b.x).margin(margin));
  CHECK(a.y == Approx(b.y).margin(margin));
  CHECK(a.z == Approx(b.z).margin(margin));
}

const std::map<std::string, ParameterValue> kLevel{
    {"position", Vec3{0, -2, 0}}, {"look_at", Vec3{0, 0, 0}}, {"fov_deg", 90.0}};

std::map<std::string, ParameterValue> with(std::map<std::string, ParameterValue> values,
                                           const std::string& name, ParameterValue value) {
  values[name] = std::move(value);
  return values;
}

}  // namespace

TEST_CASE("x runs to the right and y down", "[camera]") {
  const auto camera = make(kLevel, 200, 100);
  // Looking along +y with +z up, +x is to the right. 90 degrees span the smaller side.
  check_equal(camera->ray({100, 50}, {}).direction, {0, 1, 0});
  check_equal(camera->ray({100, 0}, {}).direction, normalize({0, 1, 1}));
  check_equal(camera->ray({100, 100}, {}).direction, normalize({0, 1, -1}));
  check_equal(camera->ray({0, 50}, {}).direction, normalize({-2, 1, 0}));
  check_equal(camera->ray({200, 50}, {}).direction, normalize({2, 1, 0}));
  check_equal(camera->ray({30, 70}, {0.3f, 0.9f}).origin, {0, -2, 0});
}

TEST_CASE("fov_axis names the side that the angle spans", "[camera]") {
  const auto edge = [](const std::string& axis, int width, int height) {
    return make(with(kLevel, "fov_axis", axis), width, height)
        ->ray({static_cast<float>(width), 0.5f * static_cast<float>(height)}, {})
        .direction;
  };
  check_equal(edge("x", 200, 100), normalize({1, 1, 0}));
  check_equal(edge("larger", 200, 100), normalize({1, 1, 0}));
  check_equal(edge("y", 200, 100), normalize({2, 1, 0}));
  check_equal(edge("smaller", 100, 200), normalize({1, 1, 0}));
  check_equal(edge("larger", 100, 200), normalize({0.5f, 1, 0}));
}

TEST_CASE("all rays of a film point meet in the plane in focus", "[camera]") {
  auto values = with(with(kLevel, "aperture_radius", 0.1), "focus_distance", 3.0);
  const auto lens = make(values, 64, 48), pinhole = make(kLevel, 64, 48);
  for (const Vec2 film : {Vec2{3, 40}, Vec2{32, 24}, Vec2{60.5f, 1.25f}}) {
    const Ray chief = pinhole->ray(film, {});
    const Vec3 focus = chief.origin + chief.direction * (3.0f / chief.direction.y);
    float farthest = 0.0f;
    for (const Vec2 u : {Vec2{0.5f, 0.5f}, Vec2{0, 0.5f}, Vec2{0.999f, 0.2f}, Vec2{0.4f, 0.01f}}) {
      const Ray ray = lens->ray(film, u);
      CHECK(length(ray.direction) == Approx(1.0f));
      CHECK(ray.origin.y == Approx(-2.0f));
      farthest = std::max(farthest, length(ray.origin - chief.origin));
      check_equal(ray.origin + ray.direction * (3.0f / ray.direction.y), focus, 2e-6f);
    }
    CHECK(farthest == Approx(0.1f).epsilon(1e-5));
  }
}

TEST_CASE("receive() inverts ray()", "[camera]") {
  const double aperture = GENERATE(0.0, 0.3);
  auto values = with(with(kLevel, "position", Vec3{3, -2, 1}), "aperture_radius", aperture);
  const auto camera = make(values, 320, 200);
  for (const Vec2 film : {Vec2{0.5f, 0.5f}, Vec2{160, 100}, Vec2{300.25f, 17.75f}}) {
    for (const float distance : {0.5f, 4.0f, 100.0f}) {
      const Vec2 lens{0.21f, 0.87f};
      const Ray ray = camera->ray(film, lens);
      const Vec3 point = ray.origin + ray.direction * distance;
      Camera::Receive received;
      REQUIRE(camera->receive(point, lens, received));
      CHECK(received.film.x == Approx(film.x).margin(2e-3));
      CHECK(received.film.y == Approx(film.y).margin(2e-3));
      CHECK(received.distance == Approx(distance).epsilon(1e-5));
      check_equal(received.direction, -ray.direction, 2e-6f);
    }
  }
}

TEST_CASE("importance is the density of the camera's rays", "[camera]") {
  const double aperture = GENERATE(0.0, 0.3);
  const auto camera = make(with(kLevel, "aperture_radius", aperture), 60, 40);
  // Integrated over the sphere of directions around a lens point by the midpoint rule on a plane at
  // distance 1: d omega = cos^3(theta) dA. The image at distance 1 is 3 x 2; the plane is 8 x 8, so
  // that rays from the side of the lens are inside it too.
  const Vec2 lens{0.1f, 0.6f};
  const Vec3 on_lens = camera->ray({30, 20}, lens).origin;
  const int n = 1000;
  double integral = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double x = 8.0 * (i + 0.5) / n - 4.0, z = 8.0 * (j + 0.5) / n - 4.0;
      const Vec3 offset{static_cast<float>(x), 1.0f, static_cast<float>(z)};
      Camera::Receive received;
      if (!camera->receive(on_lens + offset, lens, received)) continue;
      CHECK(received.importance > 0.0f);
      integral += double{received.importance} * std::pow(1.0 + x * x + z * z, -1.5) * 64.0 / n / n;
    }
  }
  // The image's border cuts cells: at most its length (10) times a cell's width over its area (6).
  CHECK(integral == Approx(1.0).margin(10.0 * 0.008 / 6.0));

  Camera::Receive received;
  CHECK_FALSE(camera->receive({0, -3, 0}, lens, received));    // behind
  CHECK_FALSE(camera->receive({0, 0, 2.5f}, lens, received));  // above the image
}

TEST_CASE("views that are undetermined are refused", "[camera]") {
  CHECK_THROWS_AS(make(with(kLevel, "look_at", Vec3{0, -2, 0}), 8, 8), InputError);
  CHECK_THROWS_AS(make(with(kLevel, "up", Vec3{0, 1, 0}), 8, 8), InputError);
  CHECK_THROWS_AS(make(with(kLevel, "up", Vec3{0, 0, 0}), 8, 8), InputError);
}
