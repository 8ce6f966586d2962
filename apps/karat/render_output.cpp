#include "apps/karat/render_output.h"

#include <tbb/info.h>

#include <algorithm>
#include <filesystem>

#include "apps/karat/picture_warnings.h"
#include "render/film_image.h"
#include "render/image_codec.h"
#include "render/image_file.h"
#include "render/replace_file.h"

namespace karat {
namespace {

bool has_extension(const std::string& path, const std::string& extension) {
  std::string found = std::filesystem::path(path).extension().string();
  std::transform(found.begin(), found.end(), found.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return found == extension;
}

// Whether the loader found that the scene cannot give light.
bool known_to_be_black(const Scene& scene) {
  return std::any_of(scene.warnings.begin(), scene.warnings.end(), [](const std::string& warning) {
    return warning.starts_with("the image will be black");
  });
}

// The colours alone, as the view shows them.
Image displayed(const Image& linear, const OcioView& view) {
  Image shown = linear;
  shown.channels = {"R", "G", "B"};
  shown.values.clear();
  const std::size_t stride = linear.channels.size();
  for (std::size_t i = 0; i < linear.values.size(); i += stride) {
    shown.values.insert(shown.values.end(), &linear.values[i], &linear.values[i] + 3);
  }
  view.apply(shown.values.data(), shown.values.size() / 3);
  shown.attributes["karat:view"] = view.description();
  return shown;
}

}  // namespace

bool is_png(const std::string& path) { return has_extension(path, ".png"); }
bool is_exr(const std::string& path) { return has_extension(path, ".exr"); }

int thread_count(const RenderCommandOptions& options) {
  return options.threads > 0 ? options.threads : tbb::info::default_concurrency();
}

RenderOutput::RenderOutput(const RenderCommandOptions& options) : options_(options) {
  for (const auto& path : options.outputs) check_writable(path);
  for (const auto& path : {options.spectral, options.checkpoint, options.stats}) {
    if (!path.empty()) check_writable(path);
  }
  if (std::any_of(options.outputs.begin(), options.outputs.end(), is_png)) {
    require_image_codec();
    view_.emplace(options.ocio, options.display, options.view, options.exposure_stops);
  }
}

std::string RenderOutput::view_description() const { return view_ ? view_->description() : ""; }

std::vector<std::string> RenderOutput::write(Scene& scene, const Film& film,
                                             const RenderResult& result) const {
  const RunFacts run{result.seconds, thread_count(options_)};
  const RunFacts* facts = options_.reproducible ? nullptr : &run;
  Image image = film_image(scene, film);
  std::vector<std::string> warnings;
  // What must be black was said before rendering, with the cause.
  if (result.samples > 0 && !known_to_be_black(scene)) {
    warnings = picture_warnings(image, view_ ? &*view_ : nullptr);
    scene.warnings.insert(scene.warnings.end(), warnings.begin(), warnings.end());
  }
  add_provenance(image, scene, result.samples, facts);
  for (const auto& path : options_.outputs) {
    if (is_png(path)) {
      write_png(path, displayed(image, *view_));
    } else {
      write_exr(path, image, options_.half);
    }
  }
  if (!options_.spectral.empty()) {
    Image spectral = spectral_image(scene, film);
    add_provenance(spectral, scene, result.samples, facts);
    write_exr(options_.spectral, spectral, options_.half);
  }
  return warnings;
}

}  // namespace karat
