// Mappings of the unit square that reflection models sample with.
#pragma once

#include <algorithm>
#include <cmath>

#include "materials/vector.h"

namespace karat {

// The unit disk, areas and neighbourhoods kept (Shirley and Chiu, "A low distortion map between
// disk and square", JGT 2(3), 1997).
inline Vec2 square_to_disk(Vec2 u) {
  const float x = 2.0f * u.x - 1.0f, y = 2.0f * u.y - 1.0f;
  if (x == 0.0f && y == 0.0f) return {0.0f, 0.0f};
  const bool wide = std::abs(x) > std::abs(y);
  const float radius = wide ? x : y;
  const float phi = wide ? 0.25f * kPi * (y / x) : 0.5f * kPi - 0.25f * kPi * (x / y);
  return {radius * std::cos(phi), radius * std::sin(phi)};
}

// The hemisphere around z with density cos / pi.
inline Vec3 square_to_cosine_hemisphere(Vec2 u) {
  const Vec2 p = square_to_disk(u);
  return {p.x, p.y, std::sqrt(std::max(0.0f, 1.0f - p.x * p.x - p.y * p.y))};
}

}  // namespace karat
