// Reflection and refraction at a rough interface between two media that do not absorb.
#pragma once

#include "materials/multiple_scattering.h"
#include "materials/roughness.h"

namespace karat {

// The two media at the wavelengths of one path, which outlives none of the pointers.
struct DielectricInterface {
  const SampledSpectrum* interior_over_exterior;
  const SampledSpectrum* exterior_over_interior;
  int hero;
  bool dispersive;
  bool carries_radiance;
  int phase;

  // Index of the far side over that of the side on which a direction with this z lies.
  const SampledSpectrum& eta(float z) const {
    return z > 0.0f ? *interior_over_exterior : *exterior_over_interior;
  }
  float radiance_scale(float eta) const { return carries_radiance ? 1.0f / (eta * eta) : 1.0f; }
};

// Walter, Marschner, Li and Torrance, "Microfacet models for refraction through rough surfaces",
// EGSR 2007, equations 20 (reflection) and 21 (refraction); visible normals, Heitz 2018. Masking
// and shadowing are height-correlated in reflection (Heitz 2014, equation 99) and independent in
// refraction (Walter et al., equation 23), where correlation works the other way.
//
// A facet reflects with the probability of its lane's reflectance. What it scatters is then
// shadowed or not: with multiple scattering that is a choice too, G2 / G1 against the lobe of
// multiple_scattering.h, so that no sample is lost and its weight in the hero lane is 1 (but for
// the other lobe's own sampling); the energy of the samples is 1 whatever the error of its tables.
// Without it (`multiple` null), G2 / G1 is the weight, and what is shadowed is lost.
//
// In a dispersive medium
// refraction depends on the wavelength: sample() follows the hero lane, values are those of every
// lane for the same wi, and lane_pdfs() gives every lane's density, so that the lanes can be
// weighted against each other (Wilkie et al., "Hero wavelength spectral sampling", EGSR 2014).
class RoughDielectricBsdf final : public Bsdf {
 public:
  RoughDielectricBsdf(const DielectricInterface& interface, Roughness roughness,
                      const MultipleScattering* multiple)
      : interface_(interface), roughness_(roughness), multiple_(multiple) {}

  Lobes lobes() const override { return lobe::kReflect | lobe::kTransmit | lobe::kGlossy; }
  bool dispersive() const override { return interface_.dispersive; }
  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const override;
  std::optional<BsdfSample> sample(const Vec3& wo, const BsdfNumbers& u) const override;
  SampledSpectrum lane_pdfs(const Vec3& wo, const Vec3& wi) const override;

 private:
  using Densities = MultipleScattering::Densities;
  Densities densities(Vec3 wo, Vec3 wi) const;
  Densities reflected(Vec3 wo, Vec3 wi) const;
  Densities refracted(Vec3 wo, Vec3 wi) const;
  // The share of a facet's light that is not shadowed on its way out.
  float unshadowed(Vec3 wo, Vec3 wi) const;

  DielectricInterface interface_;
  Roughness roughness_;
  const MultipleScattering* multiple_;
};

}  // namespace karat
