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
  return wo.z * wi.z > 0.0f ? reflected(wo, wi) : refracted(wo, wi);
}

RoughDielectricBsdf::Densities RoughDielectricBsdf::reflected(Vec3 wo, Vec3 wi) const {
  const bool below = wo.z < 0.0f;
  const FacetReflection r = MicrofacetReflection(roughness_)
                                .evaluate(below ? mirrored(wo) : wo, below ? mirrored(wi) : wi);
  const SampledSpectrum f = dielectric_reflectance(r.cos_facet, interface_.eta(wo.z));
  return {f * r.value, f * r.pdf};
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
    all.pdf[i] = transmittance * visible * jacobian;
    all.value[i] = all.pdf[i] * g1_i * interface_.radiance_scale(eta);
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

std::optional<BsdfSample> RoughDielectricBsdf::sample(const Vec3& wo, const BsdfNumbers& u) const {
  if (!(std::abs(wo.z) > MicrofacetReflection::kGrazing)) return std::nullopt;
  const bool below = wo.z < 0.0f;
  const auto& [distribution, alpha] = roughness_;
  Vec3 m = distribution->sample_visible(below ? mirrored(wo) : wo, alpha, u.direction);
  if (below) m = mirrored(m);
  const float eta = interface_.eta(wo.z)[interface_.hero];
  const float cos_theta = std::clamp(dot(wo, m), 0.0f, 1.0f);
  const bool reflects = u.lobe < dielectric_reflectance(cos_theta, eta);
  const Vec3 wi = reflects ? m * (2.0f * cos_theta) - wo : refract(wo, m, eta);
  if ((wi.z * wo.z > 0.0f) != reflects) return std::nullopt;
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
