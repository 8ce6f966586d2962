// Affine transforms.
#pragma once

#include <array>

#include "materials/vector.h"

namespace karat {

// Columns of the linear part and the translation: p' = x p.x + y p.y + z p.z + origin.
struct Transform {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin{0, 0, 0};

  Vec3 point(Vec3 p) const { return vector(p) + origin; }
  Vec3 vector(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
  // The direction of a normal (cofactor matrix; not unit; flips with a mirrored transform so that
  // outward normals stay outward).
  Vec3 normal(Vec3 n) const {
    const Vec3 c = cross(y, z) * n.x + cross(z, x) * n.y + cross(x, y) * n.z;
    return determinant() < 0.0f ? -c : c;
  }
  Vec3 inverse_point(Vec3 p) const {
    const Vec3 q = p - origin;
    return Vec3{dot(q, cross(y, z)), dot(q, cross(z, x)), dot(q, cross(x, y))} *
           (1.0f / determinant());
  }
  float determinant() const { return dot(x, cross(y, z)); }

  // a * b applies b first.
  friend Transform operator*(const Transform& a, const Transform& b) {
    return {a.vector(b.x), a.vector(b.y), a.vector(b.z), a.point(b.origin)};
  }

  static Transform translate(Vec3 t) { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, t}; }
  static Transform scale(Vec3 s) { return {{s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z}, {0, 0, 0}}; }
  // Counter-clockwise around `axis` (any length but zero) by `angle` in radians.
  static Transform rotate(Vec3 axis, float angle) {
    const Vec3 a = normalize(axis);
    const float c = std::cos(angle), s = std::sin(angle), t = 1.0f - c;
    return {{c + a.x * a.x * t, a.x * a.y * t + a.z * s, a.x * a.z * t - a.y * s},
            {a.x * a.y * t - a.z * s, c + a.y * a.y * t, a.y * a.z * t + a.x * s},
            {a.x * a.z * t + a.y * s, a.y * a.z * t - a.x * s, c + a.z * a.z * t},
            {0, 0, 0}};
  }
};

}  // namespace karat
