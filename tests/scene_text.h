// A small scene as JSON for tests that change one thing in it.
#pragma once

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "render/scene_loader.h"
#include "spectral/support/error.h"

namespace karat {

// A diffuse sphere before a camera in a uniform environment.
inline nlohmann::json small_scene() {
  return nlohmann::json::parse(R"({
    "camera": {"type": "perspective", "position": [0, -5, 0], "look_at": [0, 0, 0]},
    "film": {"width": 8, "height": 6},
    "sampling": {"spp": 4},
    "materials": {"clay": {"type": "diffuse", "reflectance": 0.5}},
    "shapes": [{"type": "sphere", "material": "clay"}],
    "lights": [{"type": "constant"}]
  })");
}

// The message of the InputError that loading gives; fails the test when there is none.
inline std::string load_error(const std::string& text, const SceneOverrides& overrides = {}) {
  try {
    load_scene_text(text, "test.json", "", overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  FAIL("loaded without error");
  return "";
}
inline std::string load_error(const nlohmann::json& scene, const SceneOverrides& overrides = {}) {
  return load_error(scene.dump(), overrides);
}

}  // namespace karat
