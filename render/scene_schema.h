// The JSON Schema (draft 7) of scene files, written from the registries.
#pragma once

#include <string>

#include "render/scene_json.h"

namespace karat {

// Of everything that is registered now.
Json scene_schema_json();

// What valijson finds wrong with a document: the first error with its place, or "" when it
// conforms.
std::string schema_violation(const Json& document);

}  // namespace karat
