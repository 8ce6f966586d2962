// Maps from the unit square to disks, hemispheres and spheres.
#pragma once

#include <algorithm>
#include <cmath>

#include "materials/vector.h"

namespace karat {

// Area-preserving map of [0, 1)^2 to the unit disk that keeps strata compact (Shirley and Chiu, "A
// low distortion map between disk and square", Journal of Graphics Tools 2(3), 1997).
inline Vec2 concentric_disk(Vec2 u) {
  const float a = 2.0f * u.x - 1.0f, b = 2.0f * u.y - 1.0f;
  if (a == 0.0f && b == 0.0f) return {};
  const bool wide = std::abs(a) > std::abs(b);
  const float radius = wide ? a : b;
  const float angle = wide ? 0.25f * kPi * (b / a) : 0.5f * kPi - 0.25f * kPi * (a / b);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// Directions around +z with density cos(theta) / pi (Malley's method).
inline Vec3 cosine_hemisphere(Vec2 u) {
  const Vec2 d = concentric_disk(u);
  return {d.x, d.y, std::sqrt(std::max(0.0f, 1.0f - d.x * d.x - d.y * d.y))};
}

// Directions with density 1 / (4 pi).
inline Vec3 uniform_sphere(Vec2 u) {
  const float z = 1.0f - 2.0f * u.x;
  const float r = 2.0f * std::sqrt(std::max(0.0f, u.x * (1.0f - u.x)));
  const float angle = 2.0f * kPi * u.y;
  return {r * std::cos(angle), r * std::sin(angle), z};
}

}  // namespace karat
