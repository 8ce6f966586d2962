// Files that a scene names.
#pragma once

#include <optional>
#include <string>

#include "render/spectrum_reader.h"

namespace karat {

// A file that a scene names, absolute: a relative path is looked for beside the scene file, then in
// the working folder. The same for tables, spectra, images and meshes. Nothing where neither has
// it.
std::optional<std::string> find_scene_file(const std::string& path, const ReadContext& context);

// "no such file: looked for /scene/tinn.yml and /here/tinn.yml; did you mean "tin.yml"?" `further`
// tells where else it was looked for: " and below /tables".
std::string missing_file_message(const std::string& path, const ReadContext& context,
                                 const std::string& further = "");

}  // namespace karat
