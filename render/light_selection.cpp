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
      entries_.push_back({light.get(), {}, 0.0f, power / (4.0f * radius * radius), true});
    } else {
      entries_.push_back({light.get(), bounds.center,
                          std::max(bounds.radius * bounds.radius, 1e-12f), power, false});
    }
  }
}

void LightSelection::choose(const BatchVec3& points, const BatchFloat& u, Choice& choice) const {
  std::fill_n(choice.light, kBatch, nullptr);
  choice.total = {};
  choice.probability = {};
  for (const Entry& entry : entries_) {
    for_whole_batch([&](int i) { choice.total[i] += importance(entry, points[i]); });
  }
  BatchFloat left;
  alignas(64) std::int32_t chosen[kBatch];
  for (int i = 0; i < kBatch; ++i) left[i] = u[i] * choice.total[i], chosen[i] = -1;
  for (std::int32_t e = 0; const Entry& entry : entries_) {
    for_whole_batch([&](int i) {
      const float weight = importance(entry, points[i]);
      const bool taken = left[i] >= 0.0f && weight > 0.0f;
      chosen[i] = taken ? e : chosen[i];
      choice.probability[i] = taken ? weight / choice.total[i] : choice.probability[i];
      left[i] -= weight;
    });
    ++e;
  }
  for (int i = 0; i < kBatch; ++i) {
    if (chosen[i] >= 0) choice.light[i] = entries_[static_cast<std::size_t>(chosen[i])].light;
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
