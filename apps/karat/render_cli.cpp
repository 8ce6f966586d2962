#include "apps/karat/render_cli.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>

#include "apps/karat/number_check.h"
#include "apps/karat/render_output.h"
#include "apps/karat/size_option.h"
#include "materials/fresnel.h"
#include "render/scene_settings.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr int kDefaultSpectralBins = 64;

using Options = RenderCommandOptions;

void add_output_options(CLI::App& command, Options& options) {
  command
      .add_option("-o,--output", options.outputs,
                  "Image file, repeatable: .exr is scene-linear, .png a display view")
      ->allow_extra_args(false);
  command.add_option("--spectral", options.spectral, "Spectral EXR (Fichet et al. 2021)");
  command.add_option("--spectral-bins", options.overrides.spectral_bins,
                     "Bins of the spectral EXR: a power of two up to 512 [64]");
  command
      .add_option("--aov", options.overrides.channels,
                  "Feature layers of the EXR, separated by commas: albedo, normal, depth, shape, "
                  "samples, variance")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_flag("--half", options.half, "16-bit floats in the EXR instead of 32-bit");
  command.add_flag("--reproducible", options.reproducible,
                   "Leave out what varies between runs (render time, threads): equal files");
  command.add_option("--stats", options.stats, "Write the figures of the run as JSON");
}

void add_scene_options(CLI::App& command, Options& options,
                       const std::function<void(const std::string&)>& define) {
  SceneOverrides& overrides = options.overrides;
  command.add_option("--spp", overrides.spp, "Samples per pixel")->check(integer_check(1, kMaxSpp));
  command.add_option("--seed", overrides.seed, "Seed of the random numbers")
      ->check(integer_check(0, std::numeric_limits<std::uint32_t>::max()));
  add_size_option(
      command,
      [&overrides](PictureSize size) {
        overrides.width = size.width, overrides.height = size.height;
      },
      1, kMaxFilmSide, "Image size in pixels");
  command
      .add_option_function<std::string>(
          "--crop",
          [&overrides](const std::string& text) {
            const auto c = split_integers(text, ',', 4, "--crop", "x0,y0,x1,y1 in pixels");
            overrides.crop = Crop{c[0], c[1], c[2], c[3]};
          },
          "Render pixels x0 to x1 - 1, y0 to y1 - 1 only")
      ->type_name("x0,y0,x1,y1");
  command.add_option("--fresnel", overrides.fresnel, "Fresnel model of all conductors");
  command
      .add_option_function<std::vector<std::string>>(
          "-D,--define",
          [define](const std::vector<std::string>& definitions) {
            for (const auto& definition : definitions) define(definition);
          },
          "Change a value of the scene, as materials.gold.alpha=0.2; null removes a key, the index "
          "after a list's last appends")
      ->allow_extra_args(false)
      ->type_name("PATH=VALUE");
}

void add_run_options(CLI::App& command, Options& options) {
  command.add_option("--threads", options.threads, "Threads, 0 for all")
      ->check(integer_check(0, 4096));
  command
      .add_option("--time", options.time_limit_seconds,
                  "Seconds after which to stop; alone, until then however many samples")
      ->check(number_check(0.001, 1e9));
  command.add_option("--checkpoint", options.checkpoint,
                     "File for the unfinished render, saved every 30 s and at the end; one that "
                     "exists is kept unless --resume is given");
  command
      .add_flag("--resume", options.resume,
                "Go on from the checkpoint file where it exists, else begin it; with it, the same "
                "command can be repeated until the render is whole")
      ->needs("--checkpoint");
  command
      .add_option("--progress", options.progress,
                  "bar, lines, json or none; unless given, bar on a terminal, else lines")
      ->check(CLI::IsMember({"bar", "lines", "json", "none"}));
}

void add_display_options(CLI::App& command, Options& options) {
  command.add_option("--exposure", options.exposure_stops, "Stops, for display views only [0]")
      ->check(number_check(-100.0, 100.0));
  command.add_option("--display", options.display, "Display of the OpenColorIO configuration");
  command.add_option("--view", options.view, "View of that display");
  command.add_option("--ocio", options.ocio,
                     "OpenColorIO configuration; unless given, $OCIO or Karat's own");
}

void add_definition(Options& options, const std::string& definition) {
  const auto equals = definition.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw CLI::ValidationError("-D", "found \"" + definition + "\", allowed: PATH=VALUE");
  }
  options.overrides.values.emplace_back(definition.substr(0, equals),
                                        definition.substr(equals + 1));
}

void require_known(const std::string& option, const std::string& what,
                   const std::vector<std::string>& names, const std::vector<std::string>& known) {
  for (const auto& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw CLI::ValidationError(option, unknown_name_message(what, name, known));
  }
}

// Options that would do nothing are mistakes: what they need must be there.
void require_effect(const CLI::App& command, const Options& options) {
  const auto any = [&](bool (*is_kind)(const std::string&)) {
    return std::any_of(options.outputs.begin(), options.outputs.end(), is_kind);
  };
  const bool exr = any(is_exr), png = any(is_png);
  const auto require = [&](std::initializer_list<const char*> names, bool useful,
                           const char* needed) {
    for (const char* name : names) {
      if (command.count(name) > 0 && !useful) throw CLI::ValidationError(name, needed);
    }
  };
  require({"--exposure", "--display", "--view", "--ocio"}, png, "needs -o FILE.png");
  // A checkpoint keeps the feature layers for the EXR of a later run.
  require({"--aov"}, exr || !options.checkpoint.empty(), "needs -o FILE.exr");
  require({"--half"}, exr || !options.spectral.empty(), "needs -o FILE.exr or --spectral FILE.exr");
  require({"--spectral-bins"}, !options.spectral.empty(), "needs --spectral FILE.exr");
}

void require_sense(const CLI::App& command, Options& options) {
  for (const auto& path : options.outputs) {
    if (!is_png(path) && !is_exr(path)) {
      throw CLI::ValidationError("-o", "found \"" + path + "\", allowed: a name in .exr or .png");
    }
  }
  if (!options.spectral.empty() && !is_exr(options.spectral)) {
    throw CLI::ValidationError("--spectral",
                               "found \"" + options.spectral + "\", allowed: a name in .exr");
  }
  if (options.outputs.empty() && options.spectral.empty() && options.stats.empty() &&
      options.checkpoint.empty()) {
    throw CLI::ValidationError("-o", "nothing to write: give -o FILE.exr or -o FILE.png");
  }
  require_known("--aov", "channel", options.overrides.channels, known_channels());
  if (!options.overrides.fresnel.empty()) {
    require_known("--fresnel", "Fresnel model", {options.overrides.fresnel},
                  Registry<FresnelModel>::instance().names());
  }
  int& bins = options.overrides.spectral_bins;
  if (!options.spectral.empty() && bins == 0) bins = kDefaultSpectralBins;
  if (bins < 0 || bins > kLatticeSize || (bins & (bins - 1)) != 0) {
    throw CLI::ValidationError(
        "--spectral-bins", "found " + std::to_string(bins) + ", allowed: a power of two up to 512");
  }
  require_effect(command, options);
  // A time alone means: as many samples as fit.
  if (options.time_limit_seconds > 0.0 && !options.overrides.spp) options.overrides.spp = kMaxSpp;
}

}  // namespace

void add_render_options(CLI::App& app, const std::shared_ptr<RenderCommandOptions>& options,
                        const std::function<void()>& parsed) {
  CLI::App* command = app.add_subcommand("render", "Render a scene to images");
  command->add_option("scene", options->scene, "Scene file (JSON)")->required();
  add_output_options(*command, *options);
  add_scene_options(*command, *options, [options](const std::string& definition) {
    add_definition(*options, definition);
  });
  add_run_options(*command, *options);
  add_display_options(*command, *options);
  command->footer(
      "Example: karat render data/scenes/rings.json -o rings.exr -o rings.png --spp 256 "
      "-D materials.gold.alpha=0.2");
  command->callback([command, options, parsed] {
    require_sense(*command, *options);
    parsed();
  });
}

}  // namespace karat
