// karat render: a scene to images.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "apps/karat/command.h"
#include "apps/karat/output_files.h"
#include "apps/karat/progress.h"
#include "apps/karat/render_cli.h"
#include "apps/karat/render_output.h"
#include "apps/karat/run_karat.h"
#include "apps/karat/stats.h"
#include "render/checkpoint.h"
#include "render/renderer.h"

namespace karat {
namespace {

constexpr double kSecondsBetweenCheckpoints = 30.0;

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

// While it lives, the first Ctrl-C (or SIGTERM) only asks the render to stop; the next one kills.
class InterruptGuard {
 public:
  InterruptGuard() {
    interrupted = false;
    old_int_ = std::signal(SIGINT, stop);
    old_term_ = std::signal(SIGTERM, stop);
  }
  ~InterruptGuard() {
    std::signal(SIGINT, old_int_);
    std::signal(SIGTERM, old_term_);
  }
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  using Handler = void (*)(int);
  static void stop(int signal) {
    interrupted = true;
    std::signal(signal, SIG_DFL);
  }
  Handler old_int_, old_term_;
};

void print_warnings(const std::vector<std::string>& warnings) {
  for (const auto& warning : warnings) {
    fmt::print(stderr, "karat: warning: {}\n", printable(warning));
  }
}

Film make_film(const Scene& scene) {
  const RenderSettings& settings = scene.settings;
  const FilmChannels channels{!settings.channels.empty(), settings.spectral_bins};
  return {settings.crop, channels, Sensor::make(settings.observer, scene.lattice)};
}

RenderResult render_passes(const RenderCommandOptions& options, const Scene& scene, Film& film,
                           int first_sample, Progress& progress) {
  RenderOptions render_options;
  render_options.threads = options.threads;
  render_options.first_sample = first_sample;
  render_options.time_limit_seconds = options.time_limit_seconds;
  render_options.interrupted = &interrupted;
  double saved_seconds = 0.0;
  render_options.after_pass = [&](const RenderProgress& state, const Film& so_far) {
    progress.update(state, first_sample);
    if (!options.checkpoint.empty() &&
        state.seconds - saved_seconds >= kSecondsBetweenCheckpoints) {
      save_checkpoint(options.checkpoint, scene, so_far, state.samples_done);
      saved_seconds = state.seconds;
    }
    return true;
  };
  const RenderResult result = render(scene, render_options, film);
  progress.finish();
  return result;
}

void report(const RenderCommandOptions& options, const Film& film, const RenderResult& result,
            const Progress& progress) {
  if (film.non_finite() + film.negative() > 0) {
    fmt::print(stderr,
               "karat: warning: {} samples that were not finite and {} negative ones were "
               "left out\n",
               film.non_finite(), film.negative());
  }
  std::string files = fmt::format("{}", fmt::join(options.outputs, ", "));
  if (!options.spectral.empty()) files += (files.empty() ? "" : ", ") + options.spectral;
  progress.note(fmt::format("{} spp in {:.2f} s{}{}", result.samples, result.seconds,
                            files.empty() ? "" : ", written: ", files));
}

// The samples per pixel that a checkpoint brings into `film`.
int resumed_samples(const RenderCommandOptions& options, const Scene& scene, Film& film,
                    const Progress& progress) {
  if (!options.resume) return 0;
  if (!std::filesystem::exists(options.checkpoint)) {
    progress.note(options.checkpoint + " is not there yet: the render begins with sample 1");
    return 0;
  }
  const int held = load_checkpoint(options.checkpoint, scene, film);
  if (held >= scene.settings.spp) {
    progress.note(fmt::format(
        "{} holds {} spp, {} were asked for: nothing is left to render; the images show all {}",
        options.checkpoint, held, scene.settings.spp, held));
  } else {
    progress.note(fmt::format("{} holds {} spp: goes on from there", options.checkpoint, held));
  }
  return held;
}

int run(const RenderCommandOptions& options) {
  require_safe_outputs(options);
  const RenderOutput output(options);
  Scene scene = load_scene(options.scene, options.overrides);
  require_outputs_apart(options, scene.files);
  print_warnings(scene.warnings);
  Progress progress(options.progress, options.time_limit_seconds);
  if (const auto view = output.view_description(); !view.empty()) progress.note("view: " + view);

  Film film = make_film(scene);
  const int first_sample = resumed_samples(options, scene, film, progress);
  const InterruptGuard guard;
  const double first_ray_seconds = seconds_since_start();
  const RenderResult result = render_passes(options, scene, film, first_sample, progress);
  if (!options.checkpoint.empty()) save_checkpoint(options.checkpoint, scene, film, result.samples);
  print_warnings(output.write(scene, film, result));
  if (!options.stats.empty()) write_stats(options, scene, film, result, first_ray_seconds);
  report(options, film, result, progress);
  return result.interrupted ? kInterrupted : kDone;
}

class RenderCommand final : public Command {
 public:
  void add_to(CLI::App& app, std::function<int()>& action) const override {
    const auto options = std::make_shared<RenderCommandOptions>();
    add_render_options(app, options,
                       [&action, options] { action = [options] { return run(*options); }; });
  }
};

KARAT_REGISTER(Command, "render", RenderCommand);

}  // namespace
}  // namespace karat
