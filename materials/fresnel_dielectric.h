// The interface between two media that do not absorb, one wavelength or all lanes of a path.
//
// `eta` is the index on the far side over the index on the side that light comes from; angles are
// against the (micro)facet normal. Fresnel 1823; Born and Wolf, "Principles of Optics",
// section 1.5.
#pragma once

#include <algorithm>
#include <cmath>

#include "materials/vector.h"
#include "spectral/sampled_spectrum.h"

namespace karat {

// eta times the cosine on the far side, 0 in total reflection: sqrt(eta^2 - sin^2).
inline float refracted_cosine_eta(float cos_theta, float eta) {
  return std::sqrt(std::max(0.0f, (eta - 1.0f) * (eta + 1.0f) + cos_theta * cos_theta));
}

// Power reflectance of unpolarised light, in [0, 1] for cos_theta in [0, 1] and eta > 0; 1 in total
// reflection, which needs no case of its own: there the root is 0 and both amplitudes are +-1.
inline float dielectric_reflectance(float cos_theta, float eta) {
  constexpr float kTiny = 1e-18f;  // a matched index at exactly 90 degrees reflects nothing
  const float q = refracted_cosine_eta(cos_theta, eta);
  const float s = (cos_theta - q) / std::max(cos_theta + q, kTiny);
  const float eta2_cos = eta * eta * cos_theta;
  const float p = (eta2_cos - q) / std::max(eta2_cos + q, kTiny);
  return 0.5f * (s * s + p * p);
}

inline SampledSpectrum dielectric_reflectance(float cos_theta, const SampledSpectrum& eta) {
  SampledSpectrum r;
  for (int i = 0; i < kLanes; ++i) r[i] = dielectric_reflectance(cos_theta, eta[i]);
  return r;
}

// Power transmittance where the cosines on both sides, both positive, are known to obey Snell's
// law: the same function, with no difference of nearly equal numbers near total reflection.
inline float dielectric_transmittance(float cos_theta, float cos_far, float eta) {
  const float s = cos_theta + eta * cos_far, p = eta * cos_theta + cos_far;
  return 2.0f * eta * cos_theta * cos_far * (1.0f / (s * s) + 1.0f / (p * p));
}

// The direction into which light from `w` (unit, away from the surface) is refracted at a facet `m`
// with dot(w, m) >= 0; meaningless in total reflection.
inline Vec3 refract(Vec3 w, Vec3 m, float eta) {
  const float cos_theta = dot(w, m);
  const float along = cos_theta - refracted_cosine_eta(cos_theta, eta);
  return normalize(m * along - w);
}

}  // namespace karat
