// Surfaces of revolution around the z axis as quad meshes.
#pragma once

#include <vector>

#include "render/shape.h"

namespace karat {

// A point of the profile in the half plane (rho, z) with its unit normal; `v` is the texture
// coordinate along the profile, in [0, 1].
struct ProfilePoint {
  double rho, z;
  double normal_rho, normal_z;
  double v;
};

// Turns a profile around z in `segments` steps. The profile runs counter-clockwise around the solid
// as seen in (rho right, z up); a closed one ends with a copy of its first point. Vertices at the
// seams are there twice, with equal positions, for the sake of the texture coordinates. Every quad
// is an isosceles trapezoid, hence flat; at rho = 0 two of its corners coincide.
Mesh revolved(const std::vector<ProfilePoint>& profile, int segments);

// The parameter "segments_u" of every such shape.
inline ParameterInfo segments_around_axis() {
  return {.name = "segments_u",
          .type = ParameterType::kInteger,
          .description = "Faces around the axis.",
          .default_json = "512",
          .min = 3,
          .max = 16384};
}

}  // namespace karat
