#include "materials/facet_quadrature.h"

#include <algorithm>
#include <cmath>

#include "materials/fresnel_dielectric.h"

namespace karat {
namespace {

constexpr int kRings = 64, kSpokes = 128;
constexpr double kGoldenRatio = 0.61803398874989485;
constexpr int kMasking = 1024;  // steps of the table of G1

// Gauss and Legendre's rule on [0, 1]: roots of the polynomial by Newton's method from Chebyshev's
// (Abramowitz and Stegun 25.4.29 and 22.16.6).
struct GaussLegendre {
  std::vector<double> x, weight;

  explicit GaussLegendre(int n) {
    for (int i = 0; i < n; ++i) {
      double t = std::cos(M_PI * (i + 0.75) / (n + 0.5)), slope = 1.0;
      for (int step = 0; step < 100; ++step) {
        double p = 1.0, before = 0.0;
        for (int k = 1; k <= n; ++k) {
          const double next = ((2 * k - 1) * t * p - (k - 1) * before) / k;
          before = p, p = next;
        }
        slope = n * (t * p - before) / (t * t - 1.0);
        const double change = p / slope;
        t -= change;
        if (std::abs(change) < 1e-15) break;
      }
      x.push_back(0.5 * (1.0 - t));
      weight.push_back(1.0 / ((1.0 - t * t) * slope * slope));
    }
  }
};

}  // namespace

// Slopes are alpha tan(beta) (cos psi, sin psi): even steps in beta leave no singularity for GGX,
// whose slopes have no finite variance. Each ring's spokes are turned against the last one's, so
// that the edges of total reflection and of the horizon cross them evenly.
FacetQuadrature::FacetQuadrature(const Roughness& roughness) : alpha_(roughness.alpha) {
  constexpr Vec2 kUnit{1.0f, 1.0f};
  const MicrofacetDistribution& distribution = *roughness.distribution;
  for (int i = 0; i <= kMasking; ++i) {
    const float z = static_cast<float>(i) / kMasking;
    g1_.push_back(i == 0 ? 0.0f : distribution.g1({std::sqrt(1.0f - z * z), 0.0f, z}, kUnit));
  }
  g1_.push_back(g1_.back());
  const GaussLegendre rule(kRings);
  for (int i = 0; i < kRings; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double beta = 0.5 * M_PI * rule.x[at], z = std::cos(beta), r = std::tan(beta);
    const auto sine = static_cast<float>(std::sin(beta)), cosine = static_cast<float>(z);
    // Slopes have the density D cos^4; d(slopes) = r dr dpsi, dr = dbeta / cos^2.
    const double weight =
        double{distribution.d({sine, 0.0f, cosine}, kUnit)} * z * z * r * rule.weight[at];
    for (int j = 0; j < kSpokes; ++j) {
      const double psi = (j + kGoldenRatio * i) * 2.0 * M_PI / kSpokes;
      slope_x_.push_back(alpha_.x * static_cast<float>(r * std::cos(psi)));
      slope_y_.push_back(alpha_.y * static_cast<float>(r * std::sin(psi)));
      weight_.push_back(static_cast<float>(weight));
    }
  }
}

// Of a direction of any length, z > 0.
inline float FacetQuadrature::g1(float x, float y, float z) const {
  const float sx = x * alpha_.x, sy = y * alpha_.y;
  const float t = kMasking * (z / std::sqrt(sx * sx + sy * sy + z * z));
  const int i = static_cast<int>(t);
  const float* table = g1_.data();
  return table[i] + (t - static_cast<float>(i)) * (table[i + 1] - table[i]);
}

FacetShares FacetQuadrature::shares(const Vec3& w, float eta) const {
  const float g_w = g1(w.x, w.y, w.z);
  double whole = 0.0;
  FacetShares sum;
  for (std::size_t ring = 0; ring < kRings; ++ring) {
    const float *sx = &slope_x_[ring * kSpokes], *sy = &slope_y_[ring * kSpokes];
    const float* weight = &weight_[ring * kSpokes];
    float all = 0.0f, reflected = 0.0f, refracted = 0.0f, up = 0.0f;
#pragma omp simd reduction(+ : all, reflected, refracted, up)
    for (int j = 0; j < kSpokes; ++j) {
      const float mz = 1.0f / std::sqrt(1.0f + sx[j] * sx[j] + sy[j] * sy[j]);
      const float mx = -sx[j] * mz, my = -sy[j] * mz;
      const float c = std::clamp(w.x * mx + w.y * my + w.z * mz, 0.0f, 1.0f);
      const float shown = weight[j] * c / mz;
      const float f = dielectric_reflectance(c, eta);
      const float rx = 2.0f * c * mx - w.x, ry = 2.0f * c * my - w.y, rz = 2.0f * c * mz - w.z;
      const float g_r = g1(rx, ry, std::max(rz, 0.0f));
      const float along = c - refracted_cosine_eta(c, eta);
      const float tx = along * mx - w.x, ty = along * my - w.y, tz = w.z - along * mz;
      const float g_t = g1(tx, ty, std::max(tz, 0.0f));
      all += shown;
      up += shown * f;
      // G2 / G1(w) with Lambda = 1 / G1 - 1.
      reflected += shown * f * g_r / std::max(g_r + g_w - g_r * g_w, 1e-20f);
      refracted += shown * (1.0f - f) * g_t;
    }
    whole += double{all};
    sum.reflected += double{reflected}, sum.refracted += double{refracted};
    sum.shadowed += double{up};
  }
  sum.reflected /= whole, sum.refracted /= whole;
  const double reflectance = sum.shadowed / whole;
  sum.shadowed = std::max(0.0, reflectance - sum.reflected);
  sum.trapped = std::max(0.0, 1.0 - reflectance - sum.refracted);
  return sum;
}

}  // namespace karat
