// The schema of the indices that render/index_reader.h reads.
#pragma once

#include <vector>

#include "render/scene_json.h"

namespace karat {

// One JSON schema a form. They refer to "#/definitions/index" for the indices inside them.
std::vector<Json> composed_index_schemas();

}  // namespace karat
