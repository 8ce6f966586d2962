// Reflection at rough surfaces without its Fresnel factor: what every wavelength shares.
#pragma once

#include <algorithm>
#include <optional>

#include "materials/roughness.h"

namespace karat {

struct FacetReflection {
  float value;      // D G2 / (4 cos_o): the cosine of wi is in
  float pdf;        // per solid angle of wi; 0 where nothing is reflected
  float cos_facet;  // of either direction against the half vector
};

struct FacetReflectionSample {
  Vec3 wi;
  float weight;  // value / pdf = G2 / G1
  float pdf;
  float cos_facet;
};

// Walter et al. 2007, equation 20; height-correlated Smith masking, Heitz 2014, equation 99;
// visible normals, Heitz 2018, equations 2 and 17. Directions need z > kGrazing: below it a float
// holds the slope of the direction no longer, and the projected area is nothing.
class MicrofacetReflection {
 public:
  static constexpr float kGrazing = 1e-6f;

  explicit MicrofacetReflection(Roughness roughness) : roughness_(roughness) {}

  FacetReflection evaluate(const Vec3& wo, const Vec3& wi) const {
    if (!(wo.z > kGrazing && wi.z > kGrazing)) return {0.0f, 0.0f, 0.0f};
    const Vec3 h = normalize(wo + wi);
    const auto& [distribution, alpha] = roughness_;
    const float quarter = distribution->d(h, alpha) / (4.0f * wo.z);
    const float lambda_o = distribution->lambda(wo, alpha);
    const float lambda_i = distribution->lambda(wi, alpha);
    return {quarter / (1.0f + lambda_o + lambda_i), quarter / (1.0f + lambda_o),
            std::clamp(dot(wo, h), 0.0f, 1.0f)};
  }

  std::optional<FacetReflectionSample> sample(const Vec3& wo, const Vec2& u) const {
    if (!(wo.z > kGrazing)) return std::nullopt;
    const auto& [distribution, alpha] = roughness_;
    const Vec3 m = distribution->sample_visible(wo, alpha, u);
    const float cos_facet = std::clamp(dot(wo, m), 0.0f, 1.0f);
    const Vec3 wi = m * (2.0f * cos_facet) - wo;
    if (!(wi.z > kGrazing)) return std::nullopt;
    const float lambda_o = distribution->lambda(wo, alpha);
    const float lambda_i = distribution->lambda(wi, alpha);
    const float pdf = distribution->d(m, alpha) / (4.0f * wo.z * (1.0f + lambda_o));
    if (!(pdf > 0.0f)) return std::nullopt;
    return FacetReflectionSample{wi, (1.0f + lambda_o) / (1.0f + lambda_o + lambda_i), pdf,
                                 cos_facet};
  }

 private:
  Roughness roughness_;
};

}  // namespace karat
