// Error against time on a scene that other renderers have rendered too
// (shared/reference/rings_area): mean squared error, relative mean squared error and their product
// with the CPU seconds of loading and rendering, per seed and in the median.
//
//   bench_rings_area [SPP [REFERENCE.exr]]      default: 16, and the reference beside the project
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "render/film_image.h"
#include "render/image_file.h"
#include "render/renderer.h"
#include "render/scene_loader.h"

namespace {

using namespace karat;

constexpr int kSeeds = 5;
// Mitsuba divides by an integral of ybar that is 0.1 % smaller (the reference's README).
constexpr double kReferenceScale = 0.999;

struct Result {
  double mse, relative_mse, cpu_seconds;
};

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Result measure(const std::string& scene_file, int spp, std::uint32_t seed, const Image& reference) {
  const double start = cpu_seconds();
  SceneOverrides overrides;
  overrides.spp = spp;
  overrides.seed = seed;
  const Scene scene = load_scene(scene_file, overrides);
  Film film(scene.settings.crop, {}, Sensor::make(scene.settings.observer, scene.lattice));
  render(scene, {}, film);
  Result result{0.0, 0.0, cpu_seconds() - start};

  const Image image = film_image(scene, film);
  const std::size_t stride = reference.channels.size();
  const auto channel = [&](const char* name) {
    return static_cast<std::size_t>(
        std::find(reference.channels.begin(), reference.channels.end(), name) -
        reference.channels.begin());
  };
  const std::array<std::size_t, 3> rgb{channel("R"), channel("G"), channel("B")};
  const std::size_t pixels = image.values.size() / 3;
  for (std::size_t p = 0; p < pixels; ++p) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double b = kReferenceScale * double{reference.values[p * stride + rgb[c]]};
      const double d = double{image.values[p * 3 + c]} - b;
      result.mse += d * d;
      result.relative_mse += d * d / (b * b + 0.01);
    }
  }
  result.mse /= static_cast<double>(3 * pixels);
  result.relative_mse /= static_cast<double>(3 * pixels);
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string root = KARAT_SOURCE_DIR;
  const int spp = argc > 1 ? std::stoi(argv[1]) : 16;
  const std::string file =
      argc > 2 ? argv[2] : root + "/../shared/reference/rings_area/mitsuba_reference.exr";
  if (!std::filesystem::exists(file)) {
    fmt::print("no reference image: {} does not exist\n", file);
    return 0;
  }
  const Image reference = read_image(file);
  std::vector<double> mse, relative, product;
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const Result r = measure(root + "/tests/scenes/rings_area.json", spp, seed, reference);
    fmt::print("seed {}: {:.2f} CPU s, MSE {:.3e}, relMSE {:.4f}, MSE x CPU s {:.4f}\n", seed,
               r.cpu_seconds, r.mse, r.relative_mse, r.mse * r.cpu_seconds);
    mse.push_back(r.mse);
    relative.push_back(r.relative_mse);
    product.push_back(r.mse * r.cpu_seconds);
  }
  const auto median = [](std::vector<double> v) {
    std::nth_element(v.begin(), v.begin() + kSeeds / 2, v.end());
    return v[kSeeds / 2];
  };
  fmt::print(
      "median of {} seeds at {} samples per pixel: MSE {:.3e}, relMSE {:.4f}, MSE x CPU s {:.4f}\n",
      kSeeds, spp, median(mse), median(relative), median(product));
}
