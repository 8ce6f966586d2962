// Which light a vertex samples: one of all, with a probability that depends on where the vertex is.
#pragma once

#include <memory>
#include <vector>

#include "materials/vector.h"
#include "render/light.h"

namespace karat {

class LightSelection {
 public:
  LightSelection() = default;
  LightSelection(const std::vector<std::unique_ptr<const Light>>& lights, float scene_radius);

  struct Choice {
    const Light* light;  // null when there is no light
    float probability;
  };
  // `u` in [0, 1). The probability depends on the point alone.
  Choice choose(const Vec3& point, float u) const;

  // The probability with which choose() returns `light` at that point.
  float probability(const Vec3& point, const Light* light) const;

 private:
  struct Entry {
    const Light* light;
    float power;
    Light::Bounds bounds;
  };
  float importance(const Entry& entry, const Vec3& point) const;

  std::vector<Entry> entries_;
  float scene_radius_ = 0.0f;
};

}  // namespace karat
