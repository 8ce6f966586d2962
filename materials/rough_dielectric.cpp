#include "materials/rough_dielectric.h"

#include <cmath>

#include "materials/fresnel_dielectric.h"
#include "materials/microfacet_reflection.h"

namespace karat {
namespace {

Vec3 mirrored(Vec3 w) { return {w.x, w.y, -w.z}; }

}  // namespace

// A facet's own side does not matter to distributions and Lambda: everything is done with wo above.
RoughDielectricBsdf::Densities RoughDielectricBsdf::densities(Vec3 wo, Vec3 wi) const {
  constexpr float kGrazing = MicrofacetReflection::kGrazing;
  if (!(std::abs(wo.z) > kGrazing && std::abs(wi.z) > kGrazing)) {
    return {SampledSpectrum(0.0f), SampledSpectrum(0.0f)};
  }
  const bool crosses = wo.z * wi.z < 0.0f;
  Densities all = crosses ? refracted(wo, wi) : reflected(wo, wi);
  if (multiple_) {
    const Densities more =
        multiple_->densities(wo, wi, interface_.eta(wo.z), interface_.eta(wi.z), interface_.phase);
    all.value += more.value, all.pdf += more.pdf;
  }
  if (crosses && interface_.carries_radiance) {
    const SampledSpectrum& inverse = interface_.eta(wi.z);
    all.value *= inverse * inverse;
  }
  return all;
}

RoughDielectricBsdf::Densities RoughDielectricBsdf::reflected(Vec3 wo, Vec3 wi) const {
  const bool below = wo.z < 0.0f;
  const FacetReflection r = MicrofacetReflection(roughness_)
                                .evaluate(below ? mirrored(wo) : wo, below ? mirrored(wi) : wi);
  const SampledSpectrum f = dielectric_reflectance(r.cos_facet, interface_.eta(wo.z));
  return {f * r.value, f * (multiple_ ? r.value : r.pdf)};
}

// With h along wo + eta wi, on wo's side, the solid angles of normals and of wi relate as
// eta^2 |i.h| / (o.h + eta i.h)^2 (Walter et al., equation 17).
RoughDielectricBsdf::Densities RoughDielectricBsdf::refracted(Vec3 wo, Vec3 wi) const {
  const SampledSpectrum& etas = interface_.eta(wo.z);
  const MicrofacetDistribution* distribution = roughness_.distribution;
  const Vec2 alpha = roughness_.alpha;
  const float g1_o = distribution->g1(wo, alpha), g1_i = distribution->g1(wi, alpha);
  const float side = std::copysign(1.0f, wo.z);
  Densities all{SampledSpectrum(0.0f), SampledSpectrum(0.0f)};
  const auto lane = [&](int i) {
    const float eta = etas[i];
    Vec3 h = normalize(wo + wi * eta);
    h = h * std::copysign(1.0f, h.z * side);
    const float o_h = dot(wo, h), i_h = dot(wi, h);
    if (!(o_h > 0.0f && i_h < 0.0f)) return;  // a facet seen from behind
    const float transmittance = dielectric_transmittance(o_h, -i_h, eta);
    const Vec3 up{h.x, h.y, std::abs(h.z)};
    const float root = o_h + eta * i_h;
    const float jacobian = eta * eta * -i_h / (root * root);
    const float visible = distribution->d(up, alpha) * g1_o * o_h / std::abs(wo.z);
    const float chosen = transmittance * visible * jacobian;
    all.value[i] = chosen * g1_i;
    all.pdf[i] = multiple_ ? all.value[i] : chosen;
  };
  if (!interface_.dispersive) {
    lane(0);
    return {SampledSpectrum(all.value[0]), SampledSpectrum(all.pdf[0])};
  }
  for (int i = 0; i < kLanes; ++i) lane(i);
  return all;
}

BsdfValue RoughDielectricBsdf::evaluate(const Vec3& wo, const Vec3& wi) const {
  const Densities all = densities(wo, wi);
  return {all.value, all.pdf[interface_.hero]};
}

SampledSpectrum RoughDielectricBsdf::lane_pdfs(const Vec3& wo, const Vec3& wi) const {
  return densities(wo, wi).pdf;
}

float RoughDielectricBsdf::unshadowed(Vec3 wo, Vec3 wi) const {
  const auto& [distribution, alpha] = roughness_;
  const float lambda_i = distribution->lambda(wi, alpha);
  if (wo.z * wi.z < 0.0f) return 1.0f / (1.0f + lambda_i);
  const float lambda_o = distribution->lambda(wo, alpha);
  return (1.0f + lambda_o) / (1.0f + lambda_o + lambda_i);
}

std::optional<BsdfSample> RoughDielectricBsdf::sample(const Vec3& wo, const BsdfNumbers& u) const {
  if (!(std::abs(wo.z) > MicrofacetReflection::kGrazing)) return std::nullopt;
  const bool below = wo.z < 0.0f;
  const auto& [distribution, alpha] = roughness_;
  Vec3 m = distribution->sample_visible(below ? mirrored(wo) : wo, alpha, u.direction);
  if (below) m = mirrored(m);
  const float eta = interface_.eta(wo.z)[interface_.hero];
  const float cos_theta = std::clamp(dot(wo, m), 0.0f, 1.0f);
  const float f = dielectric_reflectance(cos_theta, eta);
  bool reflects = u.lobe < f;
  Vec3 wi = reflects ? m * (2.0f * cos_theta) - wo : refract(wo, m, eta);
  const bool out =
      (wi.z * wo.z > 0.0f) == reflects && std::abs(wi.z) > MicrofacetReflection::kGrazing;
  if (multiple_) {
    const float rest = reflects ? u.lobe / f : (u.lobe - f) / (1.0f - f);
    if (!out || !(rest < unshadowed(wo, wi))) {
      wi = multiple_->sample(wo, u, interface_.phase, interface_.hero);
      reflects = wi.z * wo.z > 0.0f;
    }
  } else if (!out) {
    return std::nullopt;
  }
  const Densities all = densities(wo, wi);
  const float pdf = all.pdf[interface_.hero];
  if (!(pdf > 0.0f)) return std::nullopt;
  return BsdfSample{
      wi,
      all.value * (1.0f / pdf),
      pdf,
      static_cast<Lobes>(lobe::kGlossy | (reflects ? lobe::kReflect : lobe::kTransmit)),
      interface_.dispersive,
      reflects ? 1.0f : eta};
}

}  // namespace karat
