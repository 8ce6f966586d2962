// GGX (Trowbridge-Reitz): long tails, as most rough metals and ground glasses have.
//
// Walter, Marschner, Li and Torrance, "Microfacet models for refraction through rough surfaces",
// EGSR 2007, equations 33 and 34; anisotropic form and Lambda: Heitz, "Understanding the
// masking-shadowing function in microfacet-based BRDFs", JCGT 3(2), 2014, equations 85 and 86, 72.
// Visible normals: Dupuy and Benyoub, "Sampling visible GGX normals with spherical caps", CGF
// 42(8), 2023, listing 3.
#include <algorithm>
#include <cmath>

#include "materials/microfacet.h"
#include "materials/sampling.h"

namespace karat {
namespace {

class Ggx final : public MicrofacetDistribution {
 public:
  std::string description() const override {
    return "GGX (Trowbridge-Reitz), long tails (Walter et al. 2007)";
  }

  // Written without tan(theta): finite at grazing normals.
  float d(const Vec3& m, const Vec2& alpha) const override {
    const float x = m.x / alpha.x, y = m.y / alpha.y;
    const float e = x * x + y * y + m.z * m.z;
    return kInvPi / (alpha.x * alpha.y * e * e);
  }

  // (sqrt(1 + t) - 1) / 2 with t = alpha^2 tan^2, in the form that does not cancel at small t.
  float lambda(const Vec3& w, const Vec2& alpha) const override {
    const float x = w.x * alpha.x, y = w.y * alpha.y;
    const float t = (x * x + y * y) / (w.z * w.z);
    return 0.5f * t / (1.0f + std::sqrt(1.0f + t));
  }

  // In the space where alpha is 1 the visible normals are those halfway between w and a direction
  // uniform on a spherical cap around z: 1 - z is u.y (1 + w.z).
  Vec3 sample_visible(const Vec3& w, const Vec2& alpha, const Vec2& u) const override {
    const Vec3 stretched = normalize({w.x * alpha.x, w.y * alpha.y, w.z});
    const float below = u.y * (1.0f + stretched.z);
    const float radius = std::sqrt(std::max(0.0f, below * (2.0f - below)));
    const auto [sine, cosine] = sin_cos_turns(u.x);
    const Vec3 h{stretched.x + radius * cosine, stretched.y + radius * sine,
                 (1.0f - u.y) * (1.0f + stretched.z)};
    // Opposite to w the sum is rounding alone; any visible normal will do where the density is
    // zero.
    if (!(dot(stretched, h) > 0.0f)) return {0.0f, 0.0f, 1.0f};
    return normalize({h.x * alpha.x, h.y * alpha.y, h.z});
  }
};

KARAT_REGISTER(MicrofacetDistribution, "ggx", Ggx);

}  // namespace
}  // namespace karat
