#include "render/renderer.h"

#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace karat {
namespace {

constexpr int kTile = 16;             // pixels a side: a tile's film stays in the first-level cache
constexpr double kPassSeconds = 0.5;  // passes grow until they last about this long

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Pass {
  const Scene& scene;
  const Integrator& integrator;
  SamplerKind sampler_kind;
  int first_sample, last_sample;

  // Batches run on from pixel to pixel.
  void tile(const tbb::blocked_range2d<int>& range, Film& film, PathCounters& counters) const {
    std::vector<CameraSample> batch;
    batch.reserve(kBatch);
    Sampler sampler(sampler_kind, scene.settings.seed);
    for (int y = range.rows().begin(); y < range.rows().end(); ++y) {
      for (int x = range.cols().begin(); x < range.cols().end(); ++x) {
        sampler.start_pixel(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
        for (int s = first_sample; s < last_sample; ++s) {
          sampler.start_sample(static_cast<std::uint32_t>(s));
          add_sample(x, y, sampler, film.channels().features, batch);
          if (batch.size() == kBatch) trace(batch, film, counters);
        }
      }
    }
    trace(batch, film, counters);
  }

 private:
  void add_sample(int x, int y, const Sampler& started, bool features,
                  std::vector<CameraSample>& batch) const {
    CameraSample& sample = batch.emplace_back(x, y, started);
    const CameraNumbers u = sample.sampler.camera();
    sample.wavelengths = {static_cast<int>(u.phase * kPhases), static_cast<int>(u.hero * kLanes)};
    const Vec2 position{static_cast<float>(x) + u.pixel.x, static_cast<float>(y) + u.pixel.y};
    sample.ray = scene.camera->ray(position, u.lens);
    sample.first_hit.wanted = features;
  }

  void trace(std::vector<CameraSample>& batch, Film& film, PathCounters& counters) const {
    integrator.trace(scene, batch, counters);
    for (const CameraSample& s : batch) {
      film.add(s.x, s.y, s.radiance, s.wavelengths, &s.first_hit);
    }
    counters.paths += batch.size();
    batch.clear();
  }
};

}  // namespace

RenderResult render(const Scene& scene, const RenderOptions& options, Film& film) {
  const Clock::time_point start = Clock::now();
  const RenderSettings& settings = scene.settings;
  const Integrator* integrator = Registry<Integrator>::instance().find(settings.integrator);
  if (!integrator) throw std::logic_error("unknown integrator " + settings.integrator);
  const SamplerKind kind =
      settings.sampler == "independent" ? SamplerKind::kIndependent : SamplerKind::kSobol;

  // The control lets more threads run than there are cores, where somebody asks for that.
  const int threads =
      options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  tbb::enumerable_thread_specific<PathCounters> counters;
  const Crop crop = film.crop();

  RenderResult result;
  RenderProgress progress;
  progress.samples_total = settings.spp;
  int sample = options.first_sample, pass_samples = 1;
  while (sample < settings.spp) {
    const Clock::time_point pass_start = Clock::now();
    const Pass pass{scene, *integrator, kind, sample,
                    std::min(sample + pass_samples, settings.spp)};
    arena.execute([&] {
      tbb::parallel_for(
          tbb::blocked_range2d<int>(crop.y0, crop.y1, kTile, crop.x0, crop.x1, kTile),
          [&](const tbb::blocked_range2d<int>& tile) {
            PathCounters local;
            pass.tile(tile, film, local);
            counters.local() += local;
          },
          tbb::simple_partitioner());
    });
    sample = pass.last_sample;

    result.counters = {};
    for (const PathCounters& c : counters) result.counters += c;
    progress.samples_done = sample;
    progress.seconds = seconds_since(start);
    progress.rays = result.counters.rays;
    if (options.after_pass && !options.after_pass(progress, film)) break;
    if (options.time_limit_seconds > 0 && progress.seconds >= options.time_limit_seconds) break;
    if (options.interrupted && options.interrupted->load()) {
      result.interrupted = true;
      break;
    }
    if (seconds_since(pass_start) < 0.5 * kPassSeconds) pass_samples *= 2;
  }
  result.samples = sample;
  result.seconds = seconds_since(start);
  return result;
}

}  // namespace karat
