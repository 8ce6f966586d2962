// What `karat render` was asked to do.
#pragma once

#include <string>
#include <vector>

#include "render/scene_loader.h"

namespace karat {

struct RenderCommandOptions {
  std::string scene;
  std::vector<std::string> outputs;  // .exr and .png
  std::string spectral;              // spectral EXR, or ""
  bool half = false;
  bool reproducible = false;

  std::string ocio, display, view;
  double exposure_stops = 0.0;

  int threads = 0;
  double time_limit_seconds = 0.0;
  std::string checkpoint;
  bool resume = false;

  std::string progress;  // bar, lines, json, none; "": bar on a terminal, else lines
  std::string stats;     // JSON file, or ""
  SceneOverrides overrides;
};

}  // namespace karat
