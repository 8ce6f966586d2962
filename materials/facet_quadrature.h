// How much of the light from one direction leaves a rough dielectric interface after one
// scattering, and how much does not: by quadrature over the microfacets.
#pragma once

#include <vector>

#include "materials/roughness.h"

namespace karat {

// Shares of the energy that arrives from one direction; they add to 1.
struct FacetShares {
  double reflected = 0.0, refracted = 0.0;  // leaves on the near and on the far side
  double shadowed = 0.0;                    // reflected, but onto the surface
  double trapped = 0.0;                     // refracted, but onto the surface from below

  double lost() const { return shadowed + trapped; }
};

// A facet m shows w the area D(m) <w.m> / cos_w, of which F is reflected and 1 - F refracted
// (Walter et al. 2007); what leaves is not shadowed with probability G2 / G1(w) in reflection
// (Heitz 2014, equation 99) and G1(wi) in refraction: what RoughDielectricBsdf integrates to.
//
// Distributions are taken to be invariant under stretching (Heitz 2014, section 5.3), as GGX and
// Beckmann are: one table of G1 at alpha = 1 then serves every alpha and azimuth. For load time;
// 0.01 ms a direction.
class FacetQuadrature {
 public:
  explicit FacetQuadrature(const Roughness& roughness);

  // `w` is unit, w.z > 0; eta is the index of the far side over that of w's side.
  FacetShares shares(const Vec3& w, float eta) const;

 private:
  float g1(float x, float y, float z) const;

  Vec2 alpha_;
  std::vector<float> g1_;
  std::vector<float> slope_x_, slope_y_, weight_;
};

}  // namespace karat
