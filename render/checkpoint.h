// Checkpoints: the film of an unfinished render, exactly.
#pragma once

#include <optional>
#include <string>

#include "render/film.h"
#include "render/scene.h"

namespace karat {

// Writes the film through a temporary file that is renamed. Throws RuntimeError.
void save_checkpoint(const std::string& path, const Scene& scene, const Film& film,
                     int samples_done);

// The number of samples per pixel that a checkpoint file says it holds; nothing when the file is no
// checkpoint of this version of Karat.
std::optional<int> checkpoint_samples(const std::string& path);

// Fills `film` (made for `scene`) and returns the number of samples per pixel in it. Throws
// InputError: no such file, not a checkpoint, damaged, or of another scene (says what differs).
int load_checkpoint(const std::string& path, const Scene& scene, Film& film);

}  // namespace karat
