// A path vertex: the surface point with its frame turned to the viewer and its Bsdf prepared.
#pragma once

#include "materials/material.h"
#include "render/scene.h"

namespace karat {

struct Vertex {
  Vec3 position;
  Vec3 geometric_normal;
  Frame frame;
  Vec3 wo;  // local, towards where the path came from
  const Bsdf* bsdf;
  bool transmits;
  bool only_delta;

  // `direction` is the ray's, towards the surface. Opaque surfaces look the same from both sides:
  // their frame is turned to the viewer. For the others the inside is where wo.z < 0.
  void set(const SurfaceHit& hit, Vec3 direction, SampledWavelengths wavelengths,
           BsdfStorage& storage) {
    transmits = hit.surface->transmits;
    only_delta = hit.surface->only_delta;
    position = hit.position;
    const bool turn = !transmits && dot(direction, hit.geometric_normal) > 0.0f;
    geometric_normal = turn ? -hit.geometric_normal : hit.geometric_normal;
    frame = Frame::around(turn ? -hit.shading_normal : hit.shading_normal, hit.tangent);
    wo = frame.to_local(-direction);
    bsdf = hit.surface->material->prepare({hit.position, hit.uv}, wavelengths, Transport::kRadiance,
                                          storage);
  }

  // Whether a world direction leaves on the side that the local one is on: an interpolated normal
  // may put a reflected direction below the actual surface.
  bool consistent(const Vec3& world, const Vec3& local) const {
    return dot(world, geometric_normal) * local.z > 0.0f;
  }

  Ray spawn(const Vec3& direction) const {
    return {offset_origin(position, geometric_normal, direction), direction};
  }

  // Whether the segment to a light's sample is free. It is aimed anew from the offset origin: kept
  // parallel, and as long as from the vertex itself, it would reach into a light near by.
  bool sees(const World& world, const Vec3& direction, float distance) const {
    const Vec3 origin = offset_origin(position, geometric_normal, direction);
    if (std::isinf(distance)) return !world.occluded(origin, direction, distance);
    return !world.occluded(origin, direction * distance + (position - origin), 1.0f);
  }
};

}  // namespace karat
