// How much faster two threads are than one, in one run with interleaved repetitions, and how long a
// scene takes until its first ray (loading, tables, acceleration structure).
//
//   bench_threads [SCENE.json]      default: data/scenes/rings.json at 480x270, 8 samples per pixel
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "render/scene_loader.h"

namespace {

using namespace karat;

constexpr int kRepetitions = 7;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + kRepetitions / 2, v.end());
  return v[kRepetitions / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const std::string file = argc > 1 ? argv[1] : KARAT_SOURCE_DIR "/data/scenes/rings.json";
  SceneOverrides overrides;
  overrides.width = 480;
  overrides.height = 270;
  overrides.spp = 8;
  std::vector<double> loading, one, two, ratio;
  for (int i = 0; i < kRepetitions; ++i) {
    const double start = seconds();
    const Scene scene = load_scene(file, overrides);
    loading.push_back(seconds() - start);
    Film film(scene.settings.crop, {}, Sensor::make(scene.settings.observer, scene.lattice));
    RenderOptions options;
    options.threads = 1;
    one.push_back(render(scene, options, film).seconds);
    options.threads = 2;
    two.push_back(render(scene, options, film).seconds);
    ratio.push_back(one.back() / two.back());
  }
  const auto [least, most] = std::minmax_element(ratio.begin(), ratio.end());
  fmt::print(
      "{}: loading {:.3f} s; one thread {:.3f} s, two {:.3f} s, {:.2f} times faster ({:.2f} to "
      "{:.2f})\n",
      file, median(loading), median(one), median(two), median(ratio), *least, *most);
}
