// The figures of a render as JSON, for machines.
#pragma once

#include <string>

#include "apps/karat/render_options.h"
#include "render/film.h"
#include "render/renderer.h"

namespace karat {

// `first_ray_seconds`: from the start of the program to the first camera ray. Throws RuntimeError
// when the file cannot be written.
void write_stats(const RenderCommandOptions& options, const Scene& scene, const Film& film,
                 const RenderResult& result, double first_ray_seconds);

}  // namespace karat
