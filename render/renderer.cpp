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

// The pixels of a tile that are in the crop. Tiles start at multiples of kTile, hence of kBlock.
Crop part_of(const Crop& crop, int column, int row) {
  return {std::max(crop.x0, column * kTile), std::max(crop.y0, row * kTile),
          std::min(crop.x1, (column + 1) * kTile), std::min(crop.y1, (row + 1) * kTile)};
}

struct Pass {
  const Scene& scene;
  const Integrator& integrator;
  SamplerKind sampler_kind;
  int first_sample, last_sample;

  // Every block is traced whole, even where the film holds a part of it only: see render/batch.h.
  void tile(const Crop& part, Film& film, PathCounters& counters) const {
    const bool features = film.channels().features;
    CameraBatch batch(sampler_kind, scene.settings.seed);
    for (int y = part.y0 / kBlock * kBlock; y < part.y1; y += kBlock) {
      for (int x = part.x0 / kBlock * kBlock; x < part.x1; x += kBlock) {
        batch.sampler.start_block(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
        for (int s = first_sample; s < last_sample; ++s) {
          batch.sampler.start_sample(static_cast<std::uint32_t>(s));
          if (features) batch.first_hits.assign(kBatch, {});
          aim(x, y, batch);
          integrator.trace(scene, batch, counters);
          film.add(x, y, batch);
          counters.paths += kBatch;
        }
      }
    }
  }

 private:
  void aim(int x, int y, CameraBatch& batch) const {
    BatchCameraNumbers u;
    batch.sampler.camera(u);
    BatchFloat film[2];
    for (int i = 0; i < kBatch; ++i) {
      batch.wavelengths[i] = {static_cast<int>(u.phase[i] * kPhases),
                              static_cast<int>(u.hero[i] * kLanes)};
      film[0][i] = static_cast<float>(x + i % kBlock) + u.pixel[0][i];
      film[1][i] = static_cast<float>(y + i / kBlock) + u.pixel[1][i];
    }
    scene.camera->rays(film, u.lens, batch.rays);
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
          tbb::blocked_range2d<int>(crop.y0 / kTile, (crop.y1 + kTile - 1) / kTile, 1,
                                    crop.x0 / kTile, (crop.x1 + kTile - 1) / kTile, 1),
          [&](const tbb::blocked_range2d<int>& tile) {
            PathCounters local;
            pass.tile(part_of(crop, tile.cols().begin(), tile.rows().begin()), film, local);
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
