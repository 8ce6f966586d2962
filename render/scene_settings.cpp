#include "render/scene_settings.h"

#include <fmt/format.h>
#include <unistd.h>

#include "materials/index/index_interpolation.h"
#include "render/integrator.h"
#include "spectral/observer.h"
#include "spectral/support/error.h"
#include "spectral/support/registry.h"

namespace karat {
namespace {

const Json kEmptyObject = Json::object();

// The member of that name, or an empty object in its place: every key inside then has its default.
JsonValue section(const JsonValue& scene, const std::string& name) {
  if (scene.has(name)) return scene.member(name).require_object();
  return {kEmptyObject, scene.file(), scene.place() + "/" + name};
}

void read_integer(const JsonValue& object, const std::string& key, const Allowed& allowed,
                  int& target) {
  if (object.has(key)) target = object.member(key).integer(allowed);
}

// What the command line gives stands in the scene's place, so it is checked the same way.
void override_integer(const std::optional<int>& given, const std::string& option,
                      const Allowed& allowed, int& target) {
  if (!given) return;
  if (!allowed.contains(*given)) {
    throw InputError("", option, fmt::format("found {}, allowed: {}", *given, allowed.text()));
  }
  target = *given;
}

// What is wrong with it, or "".
std::string crop_error(const Crop& crop, const RenderSettings& settings) {
  const bool inside = crop.x0 >= 0 && crop.y0 >= 0 && crop.x1 <= settings.width &&
                      crop.y1 <= settings.height && crop.x0 < crop.x1 && crop.y0 < crop.y1;
  if (inside) return "";
  return fmt::format("found [{}, {}, {}, {}], allowed: x0 < x1 <= {} and y0 < y1 <= {}", crop.x0,
                     crop.y0, crop.x1, crop.y1, settings.width, settings.height);
}

Crop read_crop(const JsonValue& value) {
  const Allowed pixels{0, kMaxFilmSide};
  if (!value.json().is_array() || value.size() != 4) value.fail_found("[x0, y0, x1, y1]");
  return {value.element(0).integer(pixels), value.element(1).integer(pixels),
          value.element(2).integer(pixels), value.element(3).integer(pixels)};
}

void read_film(const JsonValue& scene, const SceneOverrides& overrides, RenderSettings& settings) {
  const Allowed side{1, kMaxFilmSide};
  const JsonValue film = section(scene, "film");
  film.allow_keys({"width", "height", "crop"});
  read_integer(film, "width", side, settings.width);
  read_integer(film, "height", side, settings.height);
  override_integer(overrides.width, "--size", side, settings.width);
  override_integer(overrides.height, "--size", side, settings.height);
  settings.crop = {0, 0, settings.width, settings.height};
  if (overrides.crop) {
    settings.crop = *overrides.crop;
    const std::string wrong = crop_error(settings.crop, settings);
    if (!wrong.empty()) throw InputError("", "--crop", wrong);
  } else if (film.has("crop")) {
    const JsonValue crop = film.member("crop");
    settings.crop = read_crop(crop);
    if (const auto wrong = crop_error(settings.crop, settings); !wrong.empty()) crop.fail(wrong);
  }
}

void read_sampling(const JsonValue& scene, const SceneOverrides& overrides,
                   RenderSettings& settings) {
  const JsonValue sampling = section(scene, "sampling");
  sampling.allow_keys({"spp", "seed", "sampler"});
  read_integer(sampling, "spp", {1, kMaxSpp}, settings.spp);
  override_integer(overrides.spp, "--spp", {1, kMaxSpp}, settings.spp);
  if (sampling.has("seed")) {
    const JsonValue seed = sampling.member("seed");
    const double value = seed.number({0, 4294967295.0});
    if (!seed.json().is_number_integer()) seed.fail_found("a whole number");
    settings.seed = static_cast<std::uint32_t>(value);
  }
  if (overrides.seed) settings.seed = *overrides.seed;
  if (sampling.has("sampler")) {
    settings.sampler = sampling.member("sampler").choice("sampler", {"sobol", "independent"});
  }
}

void read_integrator(const JsonValue& scene, RenderSettings& settings) {
  const JsonValue integrator = section(scene, "integrator");
  integrator.allow_keys({"type", "max_depth"});
  if (integrator.has("type")) {
    settings.integrator =
        integrator.member("type").choice("integrator", Registry<Integrator>::instance().names());
  }
  read_integer(integrator, "max_depth", {0, kMaxPathDepth}, settings.max_depth);
}

void read_channels(const SceneOverrides& overrides, RenderSettings& settings) {
  for (const auto& channel : overrides.channels) {
    if (std::find(known_channels().begin(), known_channels().end(), channel) ==
        known_channels().end()) {
      throw InputError("", "--aov", unknown_name_message("channel", channel, known_channels()));
    }
  }
  settings.channels = overrides.channels;
  override_integer(std::optional<int>(overrides.spectral_bins), "--spectral-bins",
                   {0, kLatticeSize}, settings.spectral_bins);
}

// A pixel of the film holds 128-bit sums: X, Y, Z, Y squared and counts, 8 more with features.
double film_bytes(const RenderSettings& settings) {
  const double pixels = static_cast<double>(settings.crop.x1 - settings.crop.x0) *
                        static_cast<double>(settings.crop.y1 - settings.crop.y0);
  return pixels *
         (80.0 + (settings.channels.empty() ? 0.0 : 144.0) + 16.0 * settings.spectral_bins);
}

void require_memory(const JsonValue& scene, const RenderSettings& settings) {
  const double machine =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  const double needed = film_bytes(settings), gib = 1 << 30;
  if (machine > 0.0 && needed > machine) {
    throw InputError(scene.file(), "/film",
                     fmt::format("{} x {} pixels need {:.1f} GiB of film, this machine has {:.1f} "
                                 "GiB; render crops of it",
                                 settings.crop.x1 - settings.crop.x0,
                                 settings.crop.y1 - settings.crop.y0, needed / gib, machine / gib));
  }
}

}  // namespace

const std::vector<std::string>& known_channels() {
  static const std::vector<std::string> names{"albedo", "normal",  "depth",
                                              "shape",  "samples", "variance"};
  return names;
}

WavelengthRange read_wavelengths(const JsonValue& scene) {
  if (!scene.has("wavelengths")) return kVisible;
  const JsonValue value = scene.member("wavelengths");
  value.allow_keys({"min", "max"});
  const Allowed nm{10.0, 100000.0};
  WavelengthRange range = kVisible;
  if (value.has("min")) range.min_nm = value.member("min").number(nm);
  if (value.has("max")) range.max_nm = value.member("max").number(nm);
  if (!(range.width_nm() >= 1.0)) {
    value.fail(fmt::format("found {:g} to {:g} nm, allowed: max at least 1 nm above min",
                           range.min_nm, range.max_nm));
  }
  return range;
}

RangePolicy read_range_policy(const JsonValue& scene) {
  if (!scene.has("extrapolate")) return RangePolicy::kError;
  const auto& policy = scene.member("extrapolate").choice("extrapolation", {"error", "clamp"});
  return policy == "clamp" ? RangePolicy::kClamp : RangePolicy::kError;
}

RenderSettings read_settings(const JsonValue& scene, const SceneOverrides& overrides) {
  RenderSettings settings;
  read_film(scene, overrides, settings);
  read_sampling(scene, overrides, settings);
  read_integrator(scene, settings);
  if (scene.has("observer")) {
    settings.observer = scene.member("observer").choice("observer", observer_names());
  }
  if (scene.has("white")) {
    const JsonValue white = scene.member("white");
    settings.white = white.json().is_number() ? fmt::format("{}", white.number({500.0, 100000.0}))
                                              : white.string();
  }
  if (scene.has("interpolation")) {
    settings.interpolation =
        scene.member("interpolation").choice("interpolation", interpolation_names());
  }
  read_channels(overrides, settings);
  require_memory(scene, settings);
  return settings;
}

}  // namespace karat
