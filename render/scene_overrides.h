// Changes to a scene document from the command line: -D PATH=VALUE.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "render/scene_json.h"

namespace karat {

// Sets values in `document`. A path is a JSON pointer ("/materials/gold/alpha") or dotted
// ("materials.gold.alpha", "shapes.0.material"); a value is JSON, or else plain text. The index
// after a list's last appends; null removes a key that need not be there. Returns what was set.
// Throws InputError where the schema knows no such path, or where it leads to a material, group,
// shape or light that the document does not have.
std::vector<ChangedPlace> apply_overrides(
    Json& document, const Json& schema,
    const std::vector<std::pair<std::string, std::string>>& values);

}  // namespace karat
