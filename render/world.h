// All surfaces of a scene, ready to be hit.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <vector>

#include "materials/vector.h"
#include "render/batch.h"
#include "render/ray_scene.h"
#include "render/shape.h"
#include "render/transform.h"

namespace karat {

class Light;
class Material;

struct Ray {
  Vec3 origin;
  Vec3 direction;  // unit
};

// One placed geometry: what it is made of and whether it emits.
struct Surface {
  const Material* material = nullptr;  // null: black to light that arrives
  const Light* light = nullptr;        // the area light that this surface is, or null
  std::uint32_t id = 0;                // number of the shape in the scene file, for the id channel

  // What the loop asks of the material at every hit; set by World.
  bool transmits = false, only_delta = false;
};

struct SurfaceHit {
  Vec3 position;
  Vec3 geometric_normal;  // unit, outward side of the geometry
  Vec3 shading_normal;    // unit, on the same side as the geometric normal
  // Along increasing u where the geometry has one; any length. Tangent and uv are zero where the
  // surface's material does not use them.
  Vec3 tangent;
  Vec2 uv;
  float distance;
  const Surface* surface;
};

// The hits of a batch of rays.
struct BatchHit {
  BatchVec3 position, geometric_normal, shading_normal, tangent;
  BatchFloat u, v, distance;
  const Surface* surface[kBatch] = {};

  SurfaceHit operator[](int i) const {
    return {position[i],  geometric_normal[i], shading_normal[i], tangent[i],
            {u[i], v[i]}, distance[i],         surface[i]};
  }
};

class World {
 public:
  World();
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  // Adds a geometry in world coordinates; `surface` is copied, its address as stored is returned.
  const Surface* add(Geometry geometry, const Surface& surface);

  // Adds one copy of a group for every transform; geometry and memory are shared.
  struct Placed {
    Geometry geometry;
    Surface surface;
  };
  void add_instances(std::vector<Placed> group, const std::vector<Transform>& transforms);

  void commit();  // nothing can be hit before

  bool intersect(const Ray& ray, SurfaceHit& hit) const {
    return intersect(ray.origin, ray.direction, hit);
  }
  bool intersect(const Vec3& origin, const Vec3& direction, SurfaceHit& hit) const;

  // Whether anything lies between the two ends of a segment along `direction`, whose length is the
  // unit of `distance` (infinite for the environment). `origin` is already offset (see
  // offset_origin).
  bool occluded(const Vec3& origin, const Vec3& direction, float distance) const;

  // The same for the rays in `active`; returns those that hit something, or that are occluded.
  BatchMask intersect(const BatchRay& rays, BatchMask active, Coherence coherence,
                      BatchHit& hits) const;
  BatchMask occluded(const BatchRay& rays, const BatchFloat& distance, BatchMask active) const;

  // What traces the rays, for measurements.
  RayScene& rays();

  // Center and radius of a sphere around everything; radius 0 for an empty world.
  void bounding_sphere(Vec3& center, float& radius) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// A ray origin moved off a surface to the side of `direction` by a few units in the last place
// (Wächter and Binder, "A fast and robust method for avoiding self-intersection", Ray Tracing Gems,
// 2019, ch. 6).
inline float offset_coordinate(float x, float n) {
  constexpr float kOrigin = 1.0f / 32.0f, kFloatScale = 1.0f / 65536.0f, kIntScale = 256.0f;
  const auto steps = static_cast<std::int32_t>(kIntScale * n);
  const auto bits = std::bit_cast<std::int32_t>(x);
  const float far = std::bit_cast<float>(bits + (x < 0.0f ? -steps : steps));
  const float near = x + kFloatScale * n;
  return std::abs(x) < kOrigin ? near : far;
}
inline Vec3 offset_origin(const Vec3& position, const Vec3& geometric_normal,
                          const Vec3& direction) {
  const float side = dot(direction, geometric_normal) < 0.0f ? -1.0f : 1.0f;
  return {offset_coordinate(position.x, side * geometric_normal.x),
          offset_coordinate(position.y, side * geometric_normal.y),
          offset_coordinate(position.z, side * geometric_normal.z)};
}

}  // namespace karat
