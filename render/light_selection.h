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
    const Light* light[kBatch];  // null where no light shines
    BatchFloat probability;
    BatchFloat total;  // kept for probability()
  };
  // One light for each point of a batch; `u` in [0, 1). The probabilities depend on the point
  // alone.
  void choose(const BatchVec3& points, const BatchFloat& u, Choice& choice) const;

  // The probability with which choose() returns `light` at a point where its total was `total`.
  float probability(const Vec3& point, const Light* light, float total) const;

 private:
  // An environment is as near to every point: its distance counts 0, and at least 1.
  struct Entry {
    const Light* light;
    Vec3 center;
    float squared_scale;  // of the squared distance: 0 or 1
    float least_squared;  // squared distances count as at least this
    float power;          // over pi
  };

  // About the irradiance on a surface that faces the light: power / (pi d^2), with the distance
  // kept above the light's own radius; for an environment the power it sends through the scene's
  // sphere. Free of branches, for loops over many points.
  float importance(const Entry& entry, const Vec3& point) const {
    const float squared = entry.squared_scale * length_squared(entry.center - point);
    return entry.power / std::max(squared, entry.least_squared);
  }

  std::vector<Entry> entries_;
};

}  // namespace karat
