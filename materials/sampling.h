// Mappings of the unit square that reflection models, lights and cameras sample with, and the sines
// and cosines that they need: as polynomials, since a call of the library costs more than the rest.
#pragma once

#include <algorithm>
#include <cmath>

#include "materials/vector.h"

namespace karat {

struct SinCos {
  float sin, cos;
};

// For |x| <= pi / 4, to 1e-7 (minimax polynomials of Moshier's Cephes, sinf.c and cosf.c).
inline SinCos sin_cos_small(float x) {
  const float z = x * x;
  const float s = ((-1.9515295891e-4f * z + 8.3321608736e-3f) * z - 1.6666654611e-1f) * z * x + x;
  const float c =
      ((2.443315711809948e-5f * z - 1.388731625493765e-3f) * z + 4.166664568298827e-2f) * z * z -
      0.5f * z + 1.0f;
  return {s, c};
}

// Of 2 pi u, for u in [0, 1].
inline SinCos sin_cos_turns(float u) {
  const int quarter = static_cast<int>(4.0f * u + 0.5f);
  const auto [s, c] = sin_cos_small(2.0f * kPi * (u - 0.25f * static_cast<float>(quarter)));
  const float sine = (quarter & 1) != 0 ? c : s, cosine = (quarter & 1) != 0 ? s : c;
  return {(quarter & 2) != 0 ? -sine : sine, ((quarter + 1) & 2) != 0 ? -cosine : cosine};
}

// The unit disk, areas and neighbourhoods kept (Shirley and Chiu, "A low distortion map between
// disk and square", JGT 2(3), 1997).
inline Vec2 square_to_disk(Vec2 u) {
  const float x = 2.0f * u.x - 1.0f, y = 2.0f * u.y - 1.0f;
  const bool wide = std::abs(x) > std::abs(y);
  const float radius = wide ? x : y, other = wide ? y : x;
  if (radius == 0.0f) return {0.0f, 0.0f};
  const auto [s, c] = sin_cos_small(0.25f * kPi * (other / radius));
  return wide ? Vec2{radius * c, radius * s} : Vec2{radius * s, radius * c};
}

// The hemisphere around z with density cos / pi (Malley's method).
inline Vec3 square_to_cosine_hemisphere(Vec2 u) {
  const Vec2 p = square_to_disk(u);
  return {p.x, p.y, std::sqrt(std::max(0.0f, 1.0f - p.x * p.x - p.y * p.y))};
}

// The sphere with density 1 / (4 pi).
inline Vec3 square_to_sphere(Vec2 u) {
  const float z = 1.0f - 2.0f * u.x;
  const float r = 2.0f * std::sqrt(std::max(0.0f, u.x * (1.0f - u.x)));
  const auto [s, c] = sin_cos_turns(u.y);
  return {r * c, r * s, z};
}

}  // namespace karat
