// The path tracer against the literal reference integrator: both estimate the same image, one with
// every trick, the other with none. Numbers are independent, so that the film's variances hold.
#include "render/integrator.h"

#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <vector>

#include "render/image_file.h"
#include "tests/chi_square.h"
#include "tests/rendered.h"

using namespace karat;

namespace {

namespace fs = std::filesystem;
using Overrides = std::vector<std::pair<std::string, std::string>>;

constexpr int kRuns = 16;  // renders with seeds of their own, whose spread shows their error
constexpr int kBins = 4;   // spectral quarters
constexpr int kPathSpp = 1 << 13, kReferenceSpp = 1 << 16;

struct Estimate {
  Film film;                                    // of all runs
  std::vector<std::array<double, kBins>> runs;  // image means of each
};

Scene load(const std::string& name, const Overrides& overrides = {}) {
  SceneOverrides changes;
  changes.values = overrides;
  return load_scene(KARAT_TEST_SCENE_DIR "/" + name + ".json", changes);
}

Estimate estimate(Scene& scene, const std::string& integrator, int spp, std::uint32_t first_seed) {
  scene.settings.integrator = integrator;
  scene.settings.sampler = "independent";
  scene.settings.spp = spp / kRuns;
  const FilmChannels channels{false, kBins};
  Estimate all{test::film_for(scene, channels), {}};
  for (std::uint32_t run = 0; run < kRuns; ++run) {
    scene.settings.seed = first_seed + run;
    const Film film = test::rendered(scene, channels);
    all.film.merge(film);
    std::array<double, kBins> means{};
    double pixels = 0.0;
    test::for_each_pixel(film, [&](int x, int y) {
      ++pixels;
      for (int b = 0; b < kBins; ++b) means[static_cast<std::size_t>(b)] += film.spectral(x, y, b);
    });
    for (double& mean : means) mean /= pixels;
    all.runs.push_back(means);
  }
  return all;
}

Estimate path(const std::string& name, const Overrides& overrides = {}) {
  Scene scene = load(name, overrides);
  return estimate(scene, "path", kPathSpp, 1);
}
Estimate reference(const std::string& name, const Overrides& overrides = {},
                   int spp = kReferenceSpp) {
  Scene scene = load(name, overrides);
  return estimate(scene, "reference", spp, 1001);
}

double two_sided_p(double z) { return std::erfc(std::abs(z) / std::sqrt(2.0)); }

struct Verdict {
  std::size_t pixels = 0;
  double worst_z = 0.0;      // of any pixel's Y
  double z_of_mean_z = 0.0;  // the pixels' z as a whole are shifted: a small bias everywhere
  double z_of_image = 0.0;   // of the mean of Y over the image
  double worst_bin_t = 0.0;  // of a spectral quarter's image mean, Welch's t
  double relative_difference = 0.0, relative_error = 0.0;  // of the image mean, path to reference

  // Each of the four fails by chance once in a thousand. Welch's t has at least kRuns - 1 = 15
  // degrees of freedom: beyond 5.1 once in 4 x 1900.
  bool agrees() const {
    return two_sided_p(worst_z) > test::sidak_level(pixels) &&
           two_sided_p(z_of_mean_z) > test::sidak_level(1) &&
           two_sided_p(z_of_image) > test::sidak_level(1) && std::abs(worst_bin_t) < 5.1;
  }
};

double farther(double a, double b) { return std::abs(a) > std::abs(b) ? a : b; }

double welch_t(const Estimate& a, const Estimate& b, std::size_t bin) {
  const auto moments = [&](const Estimate& e) {
    double mean = 0.0, spread = 0.0;
    for (const auto& run : e.runs) mean += run[bin] / kRuns;
    for (const auto& run : e.runs) spread += (run[bin] - mean) * (run[bin] - mean);
    return std::pair{mean, spread / (kRuns - 1.0) / kRuns};
  };
  const auto [mean_a, variance_a] = moments(a);
  const auto [mean_b, variance_b] = moments(b);
  return (mean_a - mean_b) / std::sqrt(variance_a + variance_b);
}

Verdict compare(const Estimate& tested, const Estimate& truth) {
  Verdict v;
  double sum_z = 0.0, sum_tested = 0.0, sum_truth = 0.0, sum_variance = 0.0;
  test::for_each_pixel(truth.film, [&](int x, int y) {
    const PixelValue a = tested.film.pixel(x, y), b = truth.film.pixel(x, y);
    const double variance = a.variance_of_mean + b.variance_of_mean;
    REQUIRE(variance > 0.0);
    const double z = (a.xyz[1] - b.xyz[1]) / std::sqrt(variance);
    ++v.pixels;
    v.worst_z = farther(z, v.worst_z);
    sum_z += z;
    sum_tested += a.xyz[1], sum_truth += b.xyz[1], sum_variance += variance;
  });
  v.z_of_mean_z = sum_z / std::sqrt(static_cast<double>(v.pixels));
  v.z_of_image = (sum_tested - sum_truth) / std::sqrt(sum_variance);
  v.relative_difference = sum_tested / sum_truth - 1.0;
  v.relative_error = std::sqrt(sum_variance) / sum_truth;
  for (std::size_t b = 0; b < kBins; ++b)
    v.worst_bin_t = farther(welch_t(tested, truth, b), v.worst_bin_t);
  return v;
}

// Also: the comparison is sharp enough, the image mean known to 0.4 %.
void check_agreement(const Verdict& v) {
  INFO("worst pixel z " << v.worst_z << ", mean of z over its error " << v.z_of_mean_z
                        << ", image mean z " << v.z_of_image << ", worst spectral t "
                        << v.worst_bin_t << ", path / reference - 1 = " << v.relative_difference
                        << " +- " << v.relative_error);
  CHECK(v.agrees());
  CHECK(v.relative_error < 0.004);
}

// A small sky, brighter towards one side, written for this test alone.
struct SkyFile {
  std::string path =
      (fs::temp_directory_path() / ("karat_sky_" + std::to_string(::getpid()) + ".exr")).string();

  SkyFile() {
    Image image;
    image.width = image.full_width = 16;
    image.height = image.full_height = 8;
    image.channels = {"R", "G", "B"};
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const float glow = (x > 2 && x < 6 && y > 0 && y < 4) ? 2.0f : 0.3f;
        image.values.insert(image.values.end(), {glow, 0.8f * glow, 0.2f + 0.3f * glow});
      }
    }
    write_exr(path, image);
  }
  ~SkyFile() { fs::remove(path); }
};

}  // namespace

TEST_CASE("path tracer = reference: rough metals under a large lamp and a sky", "[integrator]") {
  const Estimate truth = reference("unbiased_metal");
  check_agreement(compare(path("unbiased_metal"), truth));

  SECTION("and a floor that is 3 % brighter is found out") {
    const Verdict v =
        compare(path("unbiased_metal", {{"materials.floor.reflectance", "0.515"}}), truth);
    INFO("worst pixel z " << v.worst_z << ", mean of z over its error " << v.z_of_mean_z
                          << ", image mean z " << v.z_of_image);
    CHECK_FALSE(v.agrees());
    CHECK(two_sided_p(v.z_of_image) < test::sidak_level(1));
    CHECK(two_sided_p(v.z_of_mean_z) < test::sidak_level(1));
  }
}

// Uniform directions suit refraction badly: the reference needs more samples here.
TEST_CASE("path tracer = reference: rough dispersive glass, solid and as a slab", "[integrator]") {
  check_agreement(compare(path("unbiased_rough_glass"),
                          reference("unbiased_rough_glass", {}, 4 * kReferenceSpp)));
}

TEST_CASE("path tracer = reference: smooth dispersive glass and water", "[integrator]") {
  check_agreement(compare(path("unbiased_smooth_glass"), reference("unbiased_smooth_glass")));
}

TEST_CASE("path tracer = reference: instances under point lights", "[integrator]") {
  check_agreement(compare(path("unbiased_instances"), reference("unbiased_instances")));
}

TEST_CASE("path tracer = reference: lamps of meshes and spheres, two-sided, image sky",
          "[integrator]") {
  const SkyFile sky;
  const Overrides overrides{{"lights.0.file", sky.path}};
  check_agreement(
      compare(path("unbiased_lamps", overrides), reference("unbiased_lamps", overrides)));
}

// A sphere of radiance L and radius R, its middle h above a surface and d away from a point of it,
// gives the irradiance pi L R^2 h / d^3 there, as long as it is above the horizon; a point of
// intensity I gives I h / d^3. The gap is a sixth of the radius, so that the last step of the path
// is short against the scene's coordinates.
TEST_CASE("lamps close to a surface light it by the closed form, wherever the scene lies",
          "[integrator]") {
  const double radius = 0.6, height = 0.7, aside = 0.3, reflectance = 0.5, emitted = 3.0;
  for (const double away : {0.0, 5.0, 50.0}) {
    for (const bool sphere : {true, false}) {
      const auto at = [&](double x, double z) { return nlohmann::json{x + away, away, z + away}; };
      nlohmann::json scene = {
          {"camera",
           {{"type", "perspective"},
            {"position", at(3, 0.3)},
            {"look_at", at(aside, 0)},
            {"fov_deg", 0.05}}},
          {"film", {{"width", 4}, {"height", 4}}},
          {"sampling", {{"spp", 4096}, {"sampler", "independent"}}},
          {"integrator", {{"type", "path"}, {"max_depth", 1}}},
          {"wavelengths", {{"min", 360}, {"max", 830}}},
          {"materials", {{"floor", {{"type", "diffuse"}, {"reflectance", reflectance}}}}},
          {"shapes",
           {{{"type", "rectangle"},
             {"material", "floor"},
             {"width", 8},
             {"height", 8},
             {"transform", {{{"translate", at(0, 0)}}}}}}}};
      if (sphere) {
        scene["shapes"].push_back({{"type", "sphere"},
                                   {"radius", radius},
                                   {"emission", emitted},
                                   {"transform", {{{"translate", at(0, height)}}}}});
      } else {
        scene["lights"] = {
            {{"type", "point"}, {"intensity", emitted}, {"position", at(0, height)}}};
      }
      const double d = std::hypot(height, aside),
                   per_intensity = reflectance * height / (d * d * d);
      const double expected = per_intensity * emitted * (sphere ? radius * radius : M_1_PI);
      const Film film = test::rendered(test::scene_from(scene));
      double sum = 0.0, variance = 0.0, pixels = 0.0;
      test::for_each_pixel(film, [&](int x, int y) {
        const PixelValue value = film.pixel(x, y);
        sum += value.xyz[1], variance += value.variance_of_mean, ++pixels;
      });
      const double mean = sum / pixels, error = std::sqrt(variance) / pixels;
      CAPTURE(away, sphere, mean, error, expected);
      // The camera's pixels cover 0.1 % of the distance; at 50 units floats place the floor as
      // well.
      CHECK(std::abs(mean - expected) < 4.0 * error + 1e-3 * expected);
      CHECK(error < 2e-3 * expected);
    }
  }
}
