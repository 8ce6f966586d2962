// Transforms in scene files: a list of operations, the first one applied first.
#pragma once

#include <vector>

#include "render/scene_json.h"
#include "render/transform.h"

namespace karat {

// Reads [{"translate": [x, y, z]}, {"rotate": {"axis": [x, y, z], "angle_deg": a}}, {"scale": s or
// [x, y, z]}, {"look_at": {"from": p, "to": q, "up": u}}, {"matrix": 16 or 12 numbers, row by
// row}]. look_at places an object at `from` with its z axis towards `to` and its y axis near `up`.
// Throws InputError; also where the result has no inverse.
Transform read_transform(const JsonValue& list);

// The JSON schema of such a list.
Json transform_schema();

}  // namespace karat
