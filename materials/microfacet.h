// Distributions of microfacet normals with Smith masking.
//
// Local frame, z along the macroscopic normal. alpha = (alpha_x, alpha_y) is the width of the
// distribution along s and t, without any remapping. D is normalised: the integral of D(m) cos(m)
// over the hemisphere is 1.
#pragma once

#include <string>

#include "materials/vector.h"
#include "spectral/support/registry.h"

namespace karat {

// Stateless and shared. One source file per distribution, ending in
//   KARAT_REGISTER(MicrofacetDistribution, "ggx", Ggx);
class MicrofacetDistribution {
 public:
  virtual ~MicrofacetDistribution() = default;

  virtual std::string description() const = 0;

  // Density of normals per unit area and solid angle, at a unit normal m with m.z > 0.
  virtual float d(const Vec3& m, const Vec2& alpha) const = 0;

  // Smith's Lambda at a unit direction w (either side).
  virtual float lambda(const Vec3& w, const Vec2& alpha) const = 0;

  // A normal visible from w (w.z > 0), with density D(m) G1(w) max(0, w.m) / w.z.
  virtual Vec3 sample_visible(const Vec3& w, const Vec2& alpha, const Vec2& u) const = 0;

  float g1(const Vec3& w, const Vec2& alpha) const { return 1.0f / (1.0f + lambda(w, alpha)); }
};

}  // namespace karat
