// Scenes at the edges of what floats can hold render without a single dropped sample.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/rendered.h"

using namespace karat;
using nlohmann::json;

namespace {

// Everything that is delicate at once, `size` scene units large and `away` of its own sizes from
// the origin: nearly smooth metal and glass, a camera that grazes the floor, lamps that touch it.
json extreme_scene(double size, double away) {
  const auto at = [&](double x, double y, double z) {
    return json{size * (x + away), size * (y - away), size * z};
  };
  const auto moved = [&](double x, double y, double z) {
    return json{{{"scale", size}}, {{"translate", at(x, y, z)}}};
  };
  json scene = json::parse(R"({
    "film": {"width": 24, "height": 24},
    "sampling": {"spp": 64},
    "integrator": {"type": "path", "max_depth": 32},
    "materials": {
      "clay": {"type": "diffuse", "reflectance": 1},
      "sharp": {"type": "conductor", "nk": {"eta": 0.2, "k": 4}, "alpha": 0.0011},
      "wide": {"type": "conductor", "nk": {"eta": 0.2, "k": 4}, "alpha_x": 1, "alpha_y": 0.0011,
               "distribution": "beckmann"},
      "glass": {"type": "dielectric", "alpha": 0.0011, "distribution": "beckmann",
                "interior": {"eta": {"table": [[380, 2.4], [780, 1.1]]}, "k": 0}},
      "frosted": {"type": "dielectric", "alpha": 1,
                  "interior": {"eta": {"table": [[380, 2.4], [780, 1.1]]}, "k": 0}},
      "clear": {"type": "dielectric",
                "interior": {"eta": {"table": [[380, 2.4], [780, 1.1]]}, "k": 0}}},
    "lights": [{"type": "constant", "radiance": 0.2}]
  })");
  scene["camera"] = {{"type", "perspective"},
                     {"position", at(0, -6, 0.001)},
                     {"look_at", at(0, 0, 0.3)},
                     {"fov_deg", 40}};
  scene["lights"].push_back(
      {{"type", "point"}, {"position", at(0, 0, 1e-3)}, {"intensity", size * size}});
  json& shapes = scene["shapes"];
  shapes = json::array();
  const auto ball = [&](const char* material, double x, double y) {
    shapes.push_back({{"type", "sphere"},
                      {"material", material},
                      {"radius", 0.5},
                      {"transform", moved(x, y, 0.5)}});
  };
  ball("sharp", -1.2, 0), ball("wide", 0, 0), ball("glass", 1.2, 0);
  ball("frosted", -0.6, 1), ball("clear", 0.6, 1);
  shapes.push_back({{"type", "rectangle"},
                    {"material", "clay"},
                    {"width", 20},
                    {"height", 20},
                    {"transform", moved(0, 0, 0)}});
  shapes.push_back({{"type", "torus"},
                    {"material", "wide"},
                    {"major_radius", 0.5},
                    {"minor_radius", 0.1},
                    {"segments_u", 48},
                    {"segments_v", 24},
                    {"transform", moved(0, -1.2, 0.1)}});
  shapes.push_back(
      {{"type", "sphere"}, {"emission", 5}, {"radius", 0.1}, {"transform", moved(1.5, -1, 0.1)}});
  shapes.push_back({{"type", "rectangle"},
                    {"emission", 5},
                    {"two_sided", true},
                    {"transform", json{{{"rotate", {{"axis", {1, 0, 0}}, {"angle_deg", 90}}}},
                                       {{"scale", size}},
                                       {{"translate", at(-1.5, 1.5, 0.5)}}}}});
  shapes.push_back({{"type", "disk"},
                    {"emission", 1e6},
                    {"radius", 1e-3},
                    {"transform", json{{{"rotate", {{"axis", {1, 0, 0}}, {"angle_deg", 180}}}},
                                       {{"scale", size}},
                                       {{"translate", at(0, 0, 3)}}}}});
  return scene;
}

double mean_luminance(const Film& film) {
  double sum = 0.0, pixels = 0.0;
  test::for_each_pixel(film, [&](int x, int y) { sum += film.pixel(x, y).xyz[1], ++pixels; });
  return sum / pixels;
}

}  // namespace

TEST_CASE("delicate scenes of any size give no sample that must be dropped", "[extremes]") {
  for (const double size : {1e-3, 1.0, 1e4}) {
    for (const double away : {0.0, 10.0}) {
      CAPTURE(size, away);
      const double mean =
          mean_luminance(test::rendered(test::scene_from(extreme_scene(size, away))));
      CHECK(mean > 0.05);
      CHECK(mean < 50.0);
    }
  }
}

// The same numbers at every size: apart from paths that rounding sends another way, the noise is
// the same too, and four standard errors are a wide bound.
TEST_CASE("neither the size of a scene nor its place changes the image's mean", "[extremes]") {
  const auto mean_and_error = [](double size, double away) {
    json scene = extreme_scene(size, away);
    scene["shapes"].erase(scene["shapes"].size() - 1);  // the tiny lamp: all noise
    scene["shapes"].erase(3), scene["shapes"].erase(2);
    scene["lights"].erase(1);
    scene["sampling"]["spp"] = 256;
    scene["camera"]["position"] = {size * away, size * (-6 - away), size * 2};
    const Film film = test::rendered(test::scene_from(scene));
    double variance = 0.0, pixels = 0.0;
    test::for_each_pixel(
        film, [&](int x, int y) { variance += film.pixel(x, y).variance_of_mean, ++pixels; });
    return std::pair{mean_luminance(film), std::sqrt(variance) / pixels};
  };
  const auto [expected, error] = mean_and_error(1.0, 0.0);
  CHECK(error < 0.01 * expected);
  for (const double size : {0x1p-10, 0x1p14}) {
    for (const double away : {0.0, 64.0}) {
      const double mean = mean_and_error(size, away).first;
      CAPTURE(size, away, mean, expected, error);
      CHECK(std::abs(mean - expected) < 4.0 * error);
    }
  }
}

TEST_CASE("emission at the edge of floats is not dropped silently", "[extremes]") {
  for (const double radiance : {1e-30, 1e12}) {
    json scene = json::parse(R"({
      "camera": {"type": "perspective", "position": [0, -5, 0], "look_at": [0, 0, 0]},
      "film": {"width": 8, "height": 8},
      "materials": {"clay": {"type": "diffuse", "reflectance": 0.5}},
      "shapes": [{"type": "sphere", "material": "clay"}]
    })");
    scene["lights"] = {{{"type", "constant"}, {"radiance", radiance}}};
    const Film film = test::rendered(test::scene_from(scene));
    CHECK(std::isfinite(mean_luminance(film)));
  }
}
