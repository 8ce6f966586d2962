#include "render/light_selection.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace karat {

LightSelection::LightSelection(const std::vector<std::unique_ptr<const Light>>& lights,
                               float scene_radius) {
  const float radius = std::max(scene_radius, 1e-6f);
  for (const auto& light : lights) {
    const Light::Bounds bounds = light->bounds();
    const float power = light->power(radius) * kInvPi;
    if (std::isinf(bounds.radius)) {
      entries_.push_back({light.get(), {}, 0.0f, 1.0f, power / (4.0f * radius * radius)});
    } else {
      const float least = std::max(bounds.radius * bounds.radius, 1e-12f);
      entries_.push_back({light.get(), bounds.center, 1.0f, least, power});
    }
  }
}

// Everything in the loops is a local copy: nothing that is written may be what is read.
void LightSelection::choose(const BatchVec3& points, const BatchFloat& u, Choice& choice) const {
  const BatchVec3 at = points;
  BatchFloat total, left, probability;
  for (const Entry& stored : entries_) {
    const Entry entry = stored;
    for_whole_batch([&](int i) { total[i] += importance(entry, at[i]); });
  }
  alignas(64) std::int32_t chosen[kBatch];
  for (int i = 0; i < kBatch; ++i) left[i] = u[i] * total[i], chosen[i] = -1;
  for (std::int32_t e = 0; const Entry& stored : entries_) {
    const Entry entry = stored;
    for_whole_batch([&](int i) {
      const float weight = importance(entry, at[i]);
      const bool taken = left[i] >= 0.0f && weight > 0.0f;
      chosen[i] = taken ? e : chosen[i];
      probability[i] = taken ? weight / total[i] : probability[i];
      left[i] -= weight;
    });
    ++e;
  }
  choice.total = total;
  choice.probability = probability;
  for (int i = 0; i < kBatch; ++i) {
    const std::int32_t e = chosen[i];
    choice.light[i] = e >= 0 ? entries_[static_cast<std::size_t>(e)].light : nullptr;
  }
}

float LightSelection::probability(const Vec3& point, const Light* light, float total) const {
  if (!(total > 0.0f)) return 0.0f;
  for (const Entry& entry : entries_) {
    if (entry.light == light) return importance(entry, point) / total;
  }
  return 0.0f;
}

}  // namespace karat
