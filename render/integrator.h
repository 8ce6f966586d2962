// Integrators estimate the radiance that a camera ray receives.
#pragma once

#include <cstdint>
#include <span>
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
  bool wanted = false;  // set by the caller
  bool valid = false;
  Vec3 normal{0, 0, 0};  // shading normal, world
  float depth = 0.0f;    // distance along the camera ray
  std::uint32_t shape = 0;
  SampledSpectrum albedo{0.0f};  // directional-hemispherical, estimated with one sample
};

// One camera sample: what an integrator is given, and the radiance that it returns per lane. Where
// the path followed the hero lane alone, the other lanes are zero and the hero's is kLanes times
// its radiance.
struct CameraSample {
  CameraSample(int pixel_x, int pixel_y, const Sampler& started)
      : x(pixel_x), y(pixel_y), sampler(started) {}

  int x, y;         // pixel
  Sampler sampler;  // started for this pixel and sample
  Ray ray;
  SampledWavelengths wavelengths;
  SampledSpectrum radiance;
  FirstHit first_hit;
};

// Camera samples come in batches: their paths are independent, and an integrator may take them
// through its steps together. Sizes of 4 to 32 are equally fast.
inline constexpr int kBatch = 8;

// Stateless and shared; registered by name: KARAT_REGISTER(Integrator, "path", PathIntegrator);
class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual std::string description() const = 0;

  // Fills `radiance` (and `first_hit` where wanted) of up to kBatch samples. The result for a
  // sample does not depend on the others.
  virtual void trace(const Scene& scene, std::span<CameraSample> samples,
                     PathCounters& counters) const = 0;
};

}  // namespace karat
