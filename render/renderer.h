// Renders a scene into a film, pass by pass, on all threads.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "render/film.h"
#include "render/integrator.h"
#include "render/scene.h"

namespace karat {

struct RenderProgress {
  int samples_done = 0;   // per pixel, of this and earlier runs
  int samples_total = 0;  // 0: until the time is over
  double seconds = 0.0;
  std::uint64_t rays = 0;
};

struct RenderOptions {
  int threads = 0;                // 0: all
  int first_sample = 0;           // samples [first_sample, settings.spp) are rendered
  double time_limit_seconds = 0;  // > 0: stop after the pass that reaches it
  const std::atomic<bool>* interrupted = nullptr;  // finishes the current pass, then stops
  // After every pass; returns false to stop.
  std::function<bool(const RenderProgress&, const Film&)> after_pass;
};

struct RenderResult {
  int samples = 0;  // per pixel, in the film
  double seconds = 0.0;
  PathCounters counters;
  bool interrupted = false;
};

RenderResult render(const Scene& scene, const RenderOptions& options, Film& film);

}  // namespace karat
