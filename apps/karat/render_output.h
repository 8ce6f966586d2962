// The files that `karat render` writes.
#pragma once

#include <optional>
#include <string>

#include "apps/karat/render_options.h"
#include "render/film.h"
#include "render/renderer.h"
#include "spectral/ocio_view.h"

namespace karat {

// Made before rendering, so that what cannot be written, or shown, is known before time is spent.
class RenderOutput {
 public:
  // Throws RuntimeError for files that cannot be written, InputError for an OCIO view that is not.
  explicit RenderOutput(const RenderCommandOptions& options);

  // "" when no display view is written.
  std::string view_description() const;

  // Writes all images. What is wrong with the picture is returned, and added to the scene's
  // warnings, which the images carry. Throws RuntimeError.
  std::vector<std::string> write(Scene& scene, const Film& film, const RenderResult& result) const;

 private:
  const RenderCommandOptions& options_;
  std::optional<OcioView> view_;
};

// The number of threads that a render will use.
int thread_count(const RenderCommandOptions& options);

bool is_png(const std::string& path);
bool is_exr(const std::string& path);

}  // namespace karat
