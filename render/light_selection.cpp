#include "render/light_selection.h"

#include <algorithm>
#include <cmath>

namespace karat {

LightSelection::LightSelection(const std::vector<std::unique_ptr<const Light>>& lights,
                               float scene_radius)
    : scene_radius_(std::max(scene_radius, 1e-6f)) {
  for (const auto& light : lights) {
    entries_.push_back({light.get(), light->power(scene_radius_), light->bounds()});
  }
}

// About the irradiance on a surface that faces the light: power / (pi d^2), with the distance kept
// above the light's own radius; for an environment the power it sends through the scene's sphere.
float LightSelection::importance(const Entry& entry, const Vec3& point) const {
  if (std::isinf(entry.bounds.radius)) {
    return entry.power * kInvPi / (4.0f * scene_radius_ * scene_radius_);
  }
  const float r2 = entry.bounds.radius * entry.bounds.radius;
  const float d2 = std::max({length_squared(entry.bounds.center - point), r2, 1e-12f});
  return entry.power * kInvPi / d2;
}

LightSelection::Choice LightSelection::choose(const Vec3& point, float u) const {
  if (entries_.size() == 1) return {entries_[0].light, 1.0f};
  float total = 0.0f;
  for (const Entry& entry : entries_) total += importance(entry, point);
  if (!(total > 0.0f)) return {nullptr, 0.0f};
  float left = u * total;
  Choice choice{nullptr, 0.0f};
  for (const Entry& entry : entries_) {
    const float weight = importance(entry, point);
    if (weight > 0.0f) choice = {entry.light, weight / total};
    left -= weight;
    if (left < 0.0f) break;
  }
  return choice;
}

float LightSelection::probability(const Vec3& point, const Light* light) const {
  if (entries_.size() == 1) return 1.0f;
  float total = 0.0f, own = 0.0f;
  for (const Entry& entry : entries_) {
    const float weight = importance(entry, point);
    total += weight;
    if (entry.light == light) own = weight;
  }
  return total > 0.0f ? own / total : 0.0f;
}

}  // namespace karat
