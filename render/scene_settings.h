// The parts of a scene file that are not things in space: wavelengths, film, sampling, colour.
#pragma once

#include "render/scene.h"
#include "render/scene_json.h"
#include "render/scene_loader.h"

namespace karat {

inline constexpr int kMaxFilmSide = 65536;
inline constexpr int kMaxSpp = 1 << 24;
inline constexpr int kMaxPathDepth = 4096;

// The feature channels that an image can carry.
const std::vector<std::string>& known_channels();

// "wavelengths": 380 to 780 nm where the scene says nothing. Throws InputError.
WavelengthRange read_wavelengths(const JsonValue& scene);

RangePolicy read_range_policy(const JsonValue& scene);

// Film, sampling, integrator, observer and white, with what the command line changes. Throws
// InputError; also when the film would not fit into this machine's memory.
RenderSettings read_settings(const JsonValue& scene, const SceneOverrides& overrides);

}  // namespace karat
