// Scenes from JSON files.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/scene.h"

namespace karat {

// What the command line changes about a scene before it is loaded.
struct SceneOverrides {
  std::vector<std::pair<std::string, std::string>> values;  // -D path=value, JSON pointer or dotted
  std::string fresnel;                                      // --fresnel MODEL
  std::optional<int> width, height, spp;
  std::optional<std::uint32_t> seed;
  std::optional<Crop> crop;
  std::vector<std::string> channels;
  int spectral_bins = 0;
};

// Throws InputError with file, JSON path, what was found and what is allowed.
Scene load_scene(const std::string& path, const SceneOverrides& overrides = {});

// The same from text; relative paths are resolved against `directory`, `name` stands in messages.
Scene load_scene_text(const std::string& text, const std::string& name,
                      const std::string& directory, const SceneOverrides& overrides = {});

// The JSON schema of scenes, written from the registries (published in data/schema).
std::string scene_schema();

}  // namespace karat
