// Small float vectors and orthonormal frames.
#pragma once

#include <algorithm>
#include <cmath>

namespace karat {

inline constexpr float kPi = 3.14159265358979323846f;
inline constexpr float kInvPi = 0.31830988618379067154f;

struct Vec2 {
  float x = 0.0f, y = 0.0f;
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator*(Vec2 a, float s) { return {a.x * s, a.y * s}; }

struct Vec3 {
  float x = 0.0f, y = 0.0f, z = 0.0f;

  Vec3& operator+=(Vec3 o) { return *this = {x + o.x, y + o.y, z + o.z}; }
  Vec3& operator*=(float s) { return *this = {x * s, y * s, z * s}; }
};

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
inline Vec3 operator*(Vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
inline Vec3 operator*(float s, Vec3 a) { return a * s; }
inline Vec3 operator/(Vec3 a, float s) { return a * (1.0f / s); }
inline bool operator==(Vec3 a, Vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

inline float dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length_squared(Vec3 a) { return dot(a, a); }
inline float length(Vec3 a) { return std::sqrt(length_squared(a)); }
inline Vec3 normalize(Vec3 a) { return a * (1.0f / length(a)); }

// Any unit vector orthogonal to a unit normal (Duff et al., "Building an orthonormal basis,
// revisited", JCGT 6(1), 2017).
inline Vec3 any_tangent(const Vec3& n) {
  const float sign = std::copysign(1.0f, n.z);
  const float a = -1.0f / (sign + n.z);
  return {1.0f + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}

// The one nearest to `tangent`, which need be neither unit nor orthogonal; any where that is
// parallel to the normal or zero. Free of branches, for loops over many.
inline Vec3 unit_tangent(const Vec3& n, const Vec3& tangent) {
  const Vec3 any = any_tangent(n), along = tangent - n * dot(n, tangent);
  const float l2 = length_squared(along);
  const bool given = l2 > 1e-12f * length_squared(tangent);
  const float own = given ? 1.0f / std::sqrt(l2) : 0.0f, other = given ? 0.0f : 1.0f;
  return along * own + any * other;
}

// A right-handed orthonormal frame; `n` is the local z axis.
struct Frame {
  Vec3 s, t, n;

  static Frame around(Vec3 n) {
    const Vec3 s = any_tangent(n);
    return {s, cross(n, s), n};
  }
  static Frame around(Vec3 n, Vec3 tangent) {
    const Vec3 s = unit_tangent(n, tangent);
    return {s, cross(n, s), n};
  }

  Vec3 to_local(Vec3 v) const { return {dot(v, s), dot(v, t), dot(v, n)}; }
  Vec3 to_world(Vec3 v) const { return s * v.x + t * v.y + n * v.z; }
};

}  // namespace karat
