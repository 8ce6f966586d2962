// Lights: they are sampled from a point, hit by rays, and can emit rays.
//
// Radiance is in W m^-2 sr^-1 nm^-1. Densities are per solid angle at the point that is lit.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "materials/parameters.h"
#include "materials/vector.h"
#include "render/shape.h"
#include "render/world.h"
#include "spectral/spectrum.h"
#include "spectral/support/registry.h"

namespace karat {

struct LightSample {
  Vec3 wi;                   // unit, from the point to the light
  float distance;            // infinite for an environment
  float pdf;                 // 1 for delta lights
  SampledSpectrum radiance;  // for delta lights: irradiance on a surface facing the light
};

// A ray that leaves the light, with its densities (for transport from the light).
struct EmittedRay {
  Ray ray;
  Vec3 normal;         // of the emitting surface
  float pdf_position;  // per area
  float pdf_direction;
  SampledSpectrum radiance;
};

class Light {
 public:
  virtual ~Light() = default;

  // A direction towards the light, or nothing where it cannot reach `point`.
  virtual std::optional<LightSample> sample(const Vec3& point, const Vec2& u, int phase) const = 0;

  // The density with which sample() returns the direction in which a ray from `point` met the light
  // at `hit` (area lights) or left the scene along `wi` (environments).
  virtual float pdf(const Vec3& point, const Vec3& wi, const SurfaceHit* hit) const = 0;

  // What such a ray receives: zero on the dark side of a one-sided light.
  virtual SampledSpectrum radiance(const Vec3& wi, const SurfaceHit* hit, int phase) const = 0;

  // Points and directions that no ray meets by chance.
  virtual bool is_delta() const { return false; }
  virtual bool is_environment() const { return false; }

  // The radiant power, mean over the lattice, in W nm^-1: lights are chosen in proportion to an
  // estimate built on it. `scene_radius` in scene units bounds what an environment lights.
  virtual float power(float scene_radius) const = 0;

  // Sphere around all emitting points; infinite radius for environments.
  struct Bounds {
    Vec3 center;
    float radius = std::numeric_limits<float>::infinity();
  };
  virtual Bounds bounds() const { return {}; }

  virtual std::optional<EmittedRay> emit(Vec2 u_position, Vec2 u_direction, int phase) const {
    (void)u_position, (void)u_direction, (void)phase;
    return std::nullopt;
  }
};

// What a light is built with beside its parameters.
struct LightContext {
  WavelengthLattice lattice;
  Transform transform;
  std::vector<std::string>* warnings;
};

// Lights that stand alone in the scene's "lights": point, constant, image. One source file each
// (render/lights/), ending in KARAT_REGISTER(LightType, "point", PointType);
class LightType {
 public:
  virtual ~LightType() = default;
  virtual std::string description() const = 0;
  virtual std::vector<ParameterInfo> parameters() const = 0;
  virtual std::unique_ptr<const Light> create(const Parameters& parameters,
                                              const LightContext& context) const = 0;
};

// A light that is a shape's surface: every geometry can emit. `radiance` leaves the outward side,
// and the inward side too when `two_sided`.
std::unique_ptr<const Light> make_area_light(const Geometry& geometry,
                                             const LatticeSpectrum& radiance, bool two_sided);

}  // namespace karat
