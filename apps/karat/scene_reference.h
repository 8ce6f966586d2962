// The manual's page of all that a scene may hold, from the same lists as the schema.
#pragma once

#include <string>

namespace karat {

// Markdown, with links that hold in docs/. Published as docs/scene_reference.md.
std::string scene_reference();

}  // namespace karat
