#include "render/area_light.h"

#include <cmath>

#include "materials/sampling.h"

namespace karat {
namespace {

std::unique_ptr<const Light> make(const Mesh& g, const LatticeSpectrum& radiance, bool two_sided) {
  return make_mesh_light(g, radiance, two_sided);
}
std::unique_ptr<const Light> make(const SphereGeometry& g, const LatticeSpectrum& radiance,
                                  bool two_sided) {
  return make_sphere_light(g, radiance, two_sided);
}
std::unique_ptr<const Light> make(const DiskGeometry& g, const LatticeSpectrum& radiance,
                                  bool two_sided) {
  return make_disk_light(g, radiance, two_sided);
}
std::unique_ptr<const Light> make(const RectangleGeometry& g, const LatticeSpectrum& radiance,
                                  bool two_sided) {
  return make_rectangle_light(g, radiance, two_sided);
}

}  // namespace

std::unique_ptr<const Light> make_area_light(const Geometry& geometry,
                                             const LatticeSpectrum& radiance, bool two_sided) {
  return std::visit([&](const auto& g) { return make(g, radiance, two_sided); }, geometry);
}

float lattice_mean(const LatticeSpectrum& spectrum) {
  double sum_of_means = 0.0;
  for (int phase = 0; phase < kPhases; ++phase) sum_of_means += double{mean(spectrum[phase])};
  return static_cast<float>(sum_of_means / kPhases);
}

AreaLight::AreaLight(const LatticeSpectrum& radiance, bool two_sided, double area, Bounds bounds)
    : radiance_(radiance),
      two_sided_(two_sided),
      area_(static_cast<float>(area)),
      inverse_area_(static_cast<float>(1.0 / area)),
      mean_radiance_(lattice_mean(radiance)),
      bounds_(bounds) {}

std::optional<LightSample> AreaLight::sample(const Vec3& point, const Vec2& u, int phase) const {
  return towards(point, surface_point(u), phase);
}

float AreaLight::pdf(const Vec3& point, const Vec3& wi, const SurfaceHit* hit) const {
  return area_pdf(point, wi, *hit);
}

SampledSpectrum AreaLight::radiance(const Vec3& wi, const SurfaceHit* hit, int phase) const {
  if (two_sided_ || dot(wi, hit->geometric_normal) < 0.0f) return radiance_[phase];
  return SampledSpectrum(0.0f);
}

float AreaLight::power(float) const {
  return (two_sided_ ? 2.0f : 1.0f) * kPi * area_ * mean_radiance_;
}

std::optional<LightSample> AreaLight::towards(const Vec3& point, SurfacePoint on_light,
                                              int phase) const {
  std::optional<LightSample> result;  // returned on every way: filled where the caller wants it
  const Vec3 to_light = on_light.position - point;
  const float distance_squared = length_squared(to_light);
  if (!(distance_squared > 0.0f)) return result;
  const float height = -dot(to_light, on_light.normal);  // of the point over the light's plane
  const float facing = two_sided_ ? std::abs(height) : height;
  if (!(facing > 0.0f)) return result;
  const float distance = std::sqrt(distance_squared);
  LightSample& sample = result.emplace();
  sample.wi = to_light * (1.0f / distance);
  sample.distance = distance;
  sample.pdf = distance * distance_squared * inverse_area_ / facing;
  sample.radiance = radiance_[phase];
  return result;
}

float AreaLight::area_pdf(const Vec3& point, const Vec3& wi, const SurfaceHit& hit) const {
  const float cosine = -dot(wi, hit.geometric_normal);
  const float facing = two_sided_ ? std::abs(cosine) : cosine;
  if (!(facing > 0.0f)) return 0.0f;
  return length_squared(hit.position - point) * inverse_area_ / facing;
}

std::optional<EmittedRay> AreaLight::emit(Vec2 u_position, Vec2 u_direction, int phase) const {
  SurfacePoint from = surface_point(u_position);
  float side_probability = 1.0f;
  if (two_sided_) {
    side_probability = 0.5f;
    const bool inward = u_direction.x >= 0.5f;
    u_direction.x = 2.0f * u_direction.x - (inward ? 1.0f : 0.0f);
    if (inward) from.normal = -from.normal;
  }
  const Vec3 local = square_to_cosine_hemisphere(u_direction);
  if (!(local.z > 0.0f)) return std::nullopt;
  const Vec3 direction = Frame::around(from.normal).to_world(local);
  return EmittedRay{{from.position, direction},
                    from.normal,
                    inverse_area_,
                    side_probability * local.z * kInvPi,
                    radiance_[phase]};
}

}  // namespace karat
