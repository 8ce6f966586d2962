// A reflection model at one point of a surface, for the wavelengths of one path.
//
// Conventions, for every model: local frame, z along the shading normal; `wo` and `wi` are unit and
// both point away from the surface. A value includes the cosine of wi: value = f(wo, wi) |wi.z|.
// Densities are per solid angle of wi. The camera's side is wo when radiance is transported.
#pragma once

#include <cstdint>
#include <optional>

#include "materials/vector.h"
#include "spectral/sampled_spectrum.h"

namespace karat {

// Bits: what scattering a model can do, or what a sample did.
using Lobes = std::uint8_t;
namespace lobe {
inline constexpr Lobes kReflect = 1, kTransmit = 2;
inline constexpr Lobes kDiffuse = 4, kGlossy = 8, kDelta = 16;
}  // namespace lobe

// Which quantity a path carries: refraction scales radiance by the squared relative index.
enum class Transport : std::uint8_t { kRadiance, kImportance };

struct BsdfValue {
  SampledSpectrum value;  // f |cos wi|; zero where the model does not scatter, and for delta lobes
  float pdf;  // density with which sample() of this path's hero lane returns wi; 0 where
              // the value is zero in every lane
};

struct BsdfSample {
  Vec3 wi;
  SampledSpectrum weight;  // f |cos wi| / pdf per lane; for delta lobes the reflectance
  float pdf;               // density of the hero lane; 1 for delta lobes
  Lobes lobes;             // one of reflect, transmit and one of diffuse, glossy, delta
  // The direction depends on wavelength. For a finite density lane_pdfs() then gives every lane's
  // own; for a delta lobe only the hero lane can have taken it and `weight` is zero elsewhere.
  bool dispersive = false;
  float relative_eta = 1.0f;  // index on wi's side over index on wo's side; 1 for reflection
};

// Random numbers in [0, 1) for one sample.
struct BsdfNumbers {
  float lobe;
  Vec2 direction;
};

class Bsdf {
 public:
  virtual ~Bsdf() = default;

  // All lobes this model can return.
  virtual Lobes lobes() const = 0;

  // Value and density together: next-event estimation needs both, and they share most terms.
  virtual BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const = 0;

  // No sample means that the path ends here (absorbed, or the direction fell below the surface).
  virtual std::optional<BsdfSample> sample(const Vec3& wo, const BsdfNumbers& u) const = 0;

  // Density of wi for every lane as hero; models whose directions do not depend on wavelength (all
  // but dispersive ones) keep this: the same density in every lane.
  virtual SampledSpectrum lane_pdfs(const Vec3& wo, const Vec3& wi) const {
    return SampledSpectrum(evaluate(wo, wi).pdf);
  }
  virtual bool dispersive() const { return false; }
};

}  // namespace karat
