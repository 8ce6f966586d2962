// What the lights of all geometries share. One source file per geometry (area_light_*.cpp).
#pragma once

#include <memory>
#include <optional>

#include "render/light.h"

namespace karat {

// A point drawn on a surface.
struct SurfacePoint {
  Vec3 position;
  Vec3 normal;  // unit, outward
};

// Emits the same radiance from every point into every direction of its outward side, or of both.
// Where a geometry has no better way, a point drawn uniformly over the area serves as the sample.
class AreaLight : public Light {
 public:
  AreaLight(const LatticeSpectrum& radiance, bool two_sided, double area, Bounds bounds);

  std::optional<LightSample> sample(const Vec3& point, const Vec2& u, int phase) const override;
  float pdf(const Vec3& point, const Vec3& wi, const SurfaceHit* hit) const override;
  SampledSpectrum radiance(const Vec3& wi, const SurfaceHit* hit, int phase) const final;
  float power(float scene_radius) const final;  // pi x area x mean radiance, twice if two-sided
  Bounds bounds() const final { return bounds_; }
  // Uniform over the area, then cosine-weighted; a two-sided light picks its side with probability
  // one half. The ray starts on the surface itself.
  std::optional<EmittedRay> emit(Vec2 u_position, Vec2 u_direction, int phase) const final;

 protected:
  // A point drawn with density 1 / area.
  virtual SurfacePoint surface_point(const Vec2& u) const = 0;

  // The sample towards a point on the surface; nothing from the dark side or edge-on.
  std::optional<LightSample> towards(const Vec3& point, SurfacePoint on_light, int phase) const;
  // The density of that sample for the surface met at `hit`.
  float area_pdf(const Vec3& point, const Vec3& wi, const SurfaceHit& hit) const;

  const SampledSpectrum& emitted(int phase) const { return radiance_[phase]; }
  bool two_sided() const { return two_sided_; }
  float area() const { return area_; }

 private:
  LatticeSpectrum radiance_;
  bool two_sided_;
  float area_, inverse_area_, mean_radiance_;
  Bounds bounds_;
};

// The mean over the whole lattice.
float lattice_mean(const LatticeSpectrum& spectrum);

std::unique_ptr<const Light> make_rectangle_light(const RectangleGeometry& rectangle,
                                                  const LatticeSpectrum& radiance, bool two_sided);
std::unique_ptr<const Light> make_sphere_light(const SphereGeometry& sphere,
                                               const LatticeSpectrum& radiance, bool two_sided);
std::unique_ptr<const Light> make_disk_light(const DiskGeometry& disk,
                                             const LatticeSpectrum& radiance, bool two_sided);
std::unique_ptr<const Light> make_mesh_light(const Mesh& mesh, const LatticeSpectrum& radiance,
                                             bool two_sided);

}  // namespace karat
