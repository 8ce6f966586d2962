// Integrators estimate the radiance that a camera ray receives.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

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

// Camera samples of a batch: what an integrator is given, and what it returns.
struct CameraBatch {
  CameraBatch(SamplerKind kind, std::uint32_t seed) : sampler(kind, seed) {}

  BatchSampler sampler;  // started
  BatchRay rays;
  SampledWavelengths wavelengths[kBatch];

  // The radiance that is received, per lane. Where a path followed the hero lane alone, the other
  // lanes are zero and the hero's is kLanes times its radiance.
  SampledSpectrum radiance[kBatch];

  // Filled where they are wanted; then there are kBatch of them, reset by the caller.
  std::vector<FirstHit> first_hits;
};

// Stateless and shared; registered by name: KARAT_REGISTER(Integrator, "path", PathIntegrator);
class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual std::string description() const = 0;

  // Fills `radiance` (and `first_hits`) of all samples of a batch.
  virtual void trace(const Scene& scene, CameraBatch& batch, PathCounters& counters) const = 0;
};

}  // namespace karat
