#include "apps/karat/stats.h"

#include <sys/resource.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/karat/render_output.h"
#include "render/replace_file.h"
#include "render/version.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

std::string cpu_name() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double quotient(double a, double b) { return b > 0.0 ? a / b : 0.0; }

}  // namespace

void write_stats(const RenderCommandOptions& options, const Scene& scene, const Film& film,
                 const RenderResult& result, double first_ray_seconds) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const double cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  const auto rays = static_cast<double>(result.counters.rays);
  const auto vertices = static_cast<double>(result.counters.vertices);
  const int threads = thread_count(options);
  nlohmann::json tables = nlohmann::json::array();
  for (const auto& table : scene.tables) {
    tables.push_back({{"name", table.name}, {"file", table.file}, {"reference", table.reference}});
  }
  const nlohmann::json stats = {
      {"version", version()},
      {"commit", commit()},
      {"compiler", compiler()},
      {"lanes", kLanes},
      {"cpu", cpu_name()},
      {"threads", threads},
      {"scene", scene.file},
      {"width", scene.settings.width},
      {"height", scene.settings.height},
      {"spp", result.samples},
      {"seed", scene.settings.seed},
      {"seconds", result.seconds},
      {"cpu_seconds", cpu_seconds},
      {"paths", result.counters.paths},
      {"rays", result.counters.rays},
      {"rays_per_second", quotient(rays, result.seconds)},
      {"vertices", result.counters.vertices},
      {"ns_per_vertex", 1e9 * quotient(result.seconds * threads, vertices)},
      {"first_ray_seconds", first_ray_seconds},
      {"peak_memory_bytes", static_cast<std::int64_t>(usage.ru_maxrss) * 1024},
      {"non_finite", film.non_finite()},
      {"negative", film.negative()},
      {"interrupted", result.interrupted},
      {"fresnel", scene.fresnel},
      {"warnings", scene.warnings},
      {"tables", tables}};
  replace_file(options.stats, [&](const std::string& temporary) {
    std::ofstream stream(temporary, std::ios::binary);
    stream << stats.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
    stream.close();
    if (!stream) throw RuntimeError("the disk is full or the file cannot be written");
  });
}

}  // namespace karat
