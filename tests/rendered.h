// Films of whole scenes, for tests that judge what comes out.
#pragma once

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "render/film.h"
#include "render/renderer.h"
#include "render/scene_loader.h"

namespace karat::test {

inline Scene scene_from(const nlohmann::json& json) {
  return load_scene_text(json.dump(), "test.json", "");
}

// An empty film for the scene, with the channels given.
inline Film film_for(const Scene& scene, FilmChannels channels = {}) {
  return {scene.settings.crop, channels, Sensor::make(scene.settings.observer, scene.lattice)};
}

// The finished film. No test renders anything of which a sample may be dropped.
inline Film rendered(const Scene& scene, FilmChannels channels = {},
                     const RenderOptions& options = {}) {
  Film film = film_for(scene, channels);
  render(scene, options, film);
  CHECK(film.non_finite() == 0);
  CHECK(film.negative() == 0);
  return film;
}

// Calls `visit(x, y)` for every pixel of the film.
template <typename Visit>
void for_each_pixel(const Film& film, Visit&& visit) {
  const Crop crop = film.crop();
  for (int y = crop.y0; y < crop.y1; ++y) {
    for (int x = crop.x0; x < crop.x1; ++x) visit(x, y);
  }
}

}  // namespace karat::test
