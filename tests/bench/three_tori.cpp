// The price of everything but Embree: renders three tori on one thread, records the rays that were
// traced, and traces the same rays again through Embree alone. Prints the ratio of the two times,
// rays per second, and nanoseconds (and instructions, where the kernel counts them) per path
// vertex.
//
//   bench_three_tori [SCENE.json ...]      default: tests/scenes/three_tori_{smooth,rough}.json
#include <fmt/format.h>
#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "render/scene_loader.h"

namespace {

using namespace karat;

constexpr int kRepetitions = 9;

double cpu_seconds() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// Instructions in user mode, or nothing where the machine does not count them.
class InstructionCounter {
 public:
  InstructionCounter() {
    perf_event_attr attributes;
    std::memset(&attributes, 0, sizeof attributes);
    attributes.type = PERF_TYPE_HARDWARE;
    attributes.size = sizeof attributes;
    attributes.config = PERF_COUNT_HW_INSTRUCTIONS;
    attributes.exclude_kernel = 1;
    attributes.inherit = 1;
    file_ = static_cast<int>(syscall(SYS_perf_event_open, &attributes, 0, -1, -1, 0));
  }
  ~InstructionCounter() {
    if (file_ >= 0) close(file_);
  }
  bool available() const { return file_ >= 0; }
  long long read_count() const {
    long long count = 0;
    if (file_ < 0 || read(file_, &count, sizeof count) != sizeof count) return 0;
    return count;
  }

 private:
  int file_;
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

RenderResult render_once(const Scene& scene, Film& film) {
  RenderOptions options;
  options.threads = 1;
  return render(scene, options, film);
}

// The hits are counted so that no compiler leaves the tracing out.
std::size_t replay(const RayScene& scene, const std::vector<RecordedRay>& rays) {
  std::size_t hits = 0;
  EmbreeHit hit;
  for (const RecordedRay& recorded : rays) {
    hits += recorded.occlusion ? scene.occluded(recorded.ray) : scene.intersect(recorded.ray, hit);
  }
  return hits;
}

void measure(const std::string& file) {
  Scene scene = load_scene(file);
  Film film(scene.settings.crop, {}, Sensor::make(scene.settings.observer, scene.lattice));
  std::vector<RecordedRay> rays;
  scene.world.rays().record_to(&rays);
  const PathCounters counters = render_once(scene, film).counters;
  scene.world.rays().record_to(nullptr);

  const InstructionCounter instructions;
  std::vector<double> whole, embree, ratio, instructions_per_vertex;
  std::size_t hits = 0;
  const auto vertices = static_cast<double>(counters.vertices);
  for (int i = 0; i < kRepetitions; ++i) {
    const double start = cpu_seconds();
    const long long first = instructions.read_count();
    render_once(scene, film);
    instructions_per_vertex.push_back(static_cast<double>(instructions.read_count() - first) /
                                      vertices);
    const double middle = cpu_seconds();
    hits += replay(scene.world.rays(), rays);
    const double end = cpu_seconds();
    whole.push_back(middle - start);
    embree.push_back(end - middle);
    ratio.push_back((middle - start) / (end - middle));
  }
  const auto [least, most] = std::minmax_element(ratio.begin(), ratio.end());
  fmt::print("{}: {} lanes, {} rays, {} vertices, {} paths, {} replayed hits\n", file, kLanes,
             counters.rays, counters.vertices, counters.paths, hits / kRepetitions);
  fmt::print("  whole {:.3f} s, Embree alone {:.3f} s, whole / Embree {:.3f} ({:.3f} to {:.3f})\n",
             median(whole), median(embree), median(ratio), *least, *most);
  fmt::print("  {:.2f} million rays/s, {:.0f} ns per vertex",
             1e-6 * static_cast<double>(counters.rays) / median(whole),
             1e9 * median(whole) / vertices);
  if (instructions.available()) {
    fmt::print(", {:.0f} instructions per vertex\n", median(instructions_per_vertex));
  } else {
    fmt::print("; this machine does not count instructions\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> scenes(argv + 1, argv + argc);
  if (scenes.empty()) {
    const std::string folder = KARAT_SOURCE_DIR "/tests/scenes/three_tori_";
    scenes = {folder + "smooth.json", folder + "rough.json"};
  }
  for (const std::string& scene : scenes) measure(scene);
}
