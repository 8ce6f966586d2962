// Integrators estimate the radiance that a camera ray receives.
#pragma once

#include <cstdint>
#include <string>

#include "render/sampler.h"
#include "render/scene.h"
#include "spectral/sampled_spectrum.h"

namespace karat {

// Counts of one thread; added up at the end.
struct PathCounters {
  std::uint64_t rays = 0;      // nearest-hit and occlusion rays
  std::uint64_t vertices = 0;  // surface points at which a path scattered
  std::uint64_t paths = 0;

  PathCounters& operator+=(const PathCounters& o) {
    rays += o.rays, vertices += o.vertices, paths += o.paths;
    return *this;
  }
};

// What the first surface is: the feature channels of the image.
struct FirstHit {
  bool valid = false;
  Vec3 normal{0, 0, 0};  // shading normal, world
  float depth = 0.0f;    // distance along the camera ray
  std::uint32_t shape = 0;
  SampledSpectrum albedo{0.0f};  // directional-hemispherical, estimated with one sample
};

// Stateless and shared; registered by name: KARAT_REGISTER(Integrator, "path", PathIntegrator);
class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual std::string description() const = 0;

  // Radiance per lane; where the path followed the hero lane alone, the other lanes are zero and
  // the hero's is kLanes times its radiance. `first_hit` may be null.
  virtual SampledSpectrum radiance(const Scene& scene, const Ray& ray,
                                   SampledWavelengths wavelengths, Sampler& sampler,
                                   PathCounters& counters, FirstHit* first_hit) const = 0;
};

}  // namespace karat
