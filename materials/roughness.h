// The roughness parameters that every microfacet model shares: how a scene names them, and what
// they come to.
#pragma once

#include <string>
#include <vector>

#include "materials/microfacet.h"
#include "materials/parameters.h"

namespace karat {

// Below this a lobe is narrower than the rounding of a float direction allows to sample and to
// evaluate consistently: the surface is treated as smooth.
inline constexpr float kSmoothBelowAlpha = 1e-3f;

struct Roughness {
  const MicrofacetDistribution* distribution;  // never null
  Vec2 alpha;

  bool anisotropic() const { return alpha.x != alpha.y; }
  bool smooth() const { return alpha.x == 0.0f; }  // then both are zero
};

// `distribution`, `alpha`, `alpha_x`, `alpha_y` and `roughness`.
std::vector<ParameterInfo> roughness_parameters();

// Smooth where the scene gives none of them. An alpha in (0, kSmoothBelowAlpha) along either axis
// makes the surface smooth and adds a warning. Throws InputError where `roughness` is given beside
// an alpha, `alpha` beside `alpha_x` or `alpha_y`, or one of these two without the other.
Roughness read_roughness(const Parameters& parameters, std::vector<std::string>& warnings);

}  // namespace karat
