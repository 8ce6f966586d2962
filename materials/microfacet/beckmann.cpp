// Beckmann: Gaussian slopes, as a surface with many independent bumps has.
//
// D: Walter, Marschner, Li and Torrance, "Microfacet models for refraction through rough surfaces",
// EGSR 2007, equation 25; Lambda: Heitz, "Understanding the masking-shadowing function in
// microfacet-based BRDFs", JCGT 3(2), 2014, equation 66, exact (no rational fit). Visible normals:
// Heitz and d'Eon, "Importance sampling microfacet-based BSDFs using the distribution of visible
// normals", EGSR 2014, whose cumulative distribution is inverted by Newton's method.
#include <algorithm>
#include <cmath>

#include "materials/microfacet.h"

namespace karat {
namespace {

constexpr float kInvSqrtPi = 0.56418958354775628695f;
// The largest float below 1: its erfinv, 3.8, bounds the slopes.
constexpr float kBelowOne = 0.99999994f;

// Giles, "Approximating the erfinv function", GPU Computing Gems Jade, 2011: single precision,
// |x| < 1.
float erfinv(float x) {
  float w = -std::log((1.0f - x) * (1.0f + x));
  if (w < 5.0f) {
    w -= 2.5f;
    float p = 2.81022636e-08f;
    p = 3.43273939e-07f + p * w;
    p = -3.5233877e-06f + p * w;
    p = -4.39150654e-06f + p * w;
    p = 0.00021858087f + p * w;
    p = -0.00125372503f + p * w;
    p = -0.00417768164f + p * w;
    p = 0.246640727f + p * w;
    return (1.50140941f + p * w) * x;
  }
  w = std::sqrt(w) - 3.0f;
  float p = -0.000200214257f;
  p = 0.000100950558f + p * w;
  p = 0.00134934322f + p * w;
  p = -0.00367342844f + p * w;
  p = 0.00573950773f + p * w;
  p = -0.0076224613f + p * w;
  p = 0.00943887047f + p * w;
  p = 1.00167406f + p * w;
  return (2.83297682f + p * w) * x;
}

// The slope along the view direction of a normal visible at tan(theta), for alpha 1. Its cumulative
// distribution is proportional to F(s) = erfc(-s) + tan exp(-s^2) / sqrt(pi), up to the slope
// cot(theta), behind which a facet is not seen. Newton's method on log F: F is log-concave and the
// start, from erfc(x) <= exp(-x^2), lies below the root, so that steps never overshoot; and both
// terms keep their digits in the tail, where erf(s) has none left.
float visible_slope(float tan_theta, float u) {
  if (tan_theta < 1e-5f) return erfinv(std::clamp(2.0f * u - 1.0f, -kBelowOne, kBelowOne));
  const float cot_theta = 1.0f / tan_theta, tangent = kInvSqrtPi * tan_theta;
  const float whole = std::erfc(-cot_theta) + tangent * std::exp(-cot_theta * cot_theta);
  const float wanted = std::max(u, 0x1p-25f) * whole, at_zero = 1.0f + tangent;
  float slope = wanted < at_zero ? -std::sqrt(std::log(at_zero / wanted)) : 0.0f;
  for (int iteration = 0; iteration < 12; ++iteration) {
    const float gauss = std::exp(-slope * slope);
    const float below = std::erfc(-slope) + tangent * gauss;
    const float density = 2.0f * kInvSqrtPi * gauss * (1.0f - slope * tan_theta);
    if (!(density > 0.0f)) break;
    const float step = std::log(wanted / below) * below / density;
    slope = std::min(slope + step, cot_theta);
    if (!(step > 1e-5f)) break;
  }
  return slope;
}

class Beckmann final : public MicrofacetDistribution {
 public:
  std::string description() const override {
    return "Beckmann, Gaussian slopes (Walter et al. 2007)";
  }

  // Beyond 80 the exponential is below the smallest float, and at z = 0 it must not meet 0/0.
  float d(const Vec3& m, const Vec2& alpha) const override {
    const float x = m.x / alpha.x, y = m.y / alpha.y, z2 = m.z * m.z;
    const float exponent = (x * x + y * y) / z2;
    if (!(exponent < 80.0f)) return 0.0f;
    return std::exp(-exponent) * kInvPi / (alpha.x * alpha.y * z2 * z2);
  }

  float lambda(const Vec3& w, const Vec2& alpha) const override {
    const float x = w.x * alpha.x, y = w.y * alpha.y;
    const float a = std::abs(w.z) / std::sqrt(x * x + y * y);
    if (a > 9.0f) return 0.0f;
    return std::max(0.0f, 0.5f * (std::exp(-a * a) * kInvSqrtPi / a - std::erfc(a)));
  }

  Vec3 sample_visible(const Vec3& w, const Vec2& alpha, const Vec2& u) const override {
    const float x = w.x * alpha.x, y = w.y * alpha.y;
    const float radius = std::sqrt(x * x + y * y);
    const bool upright = !(radius > 0.0f);
    const float cos_phi = upright ? 1.0f : x / radius, sin_phi = upright ? 0.0f : y / radius;
    const float along = visible_slope(radius / w.z, u.x);
    const float across = erfinv(std::clamp(2.0f * u.y - 1.0f, -kBelowOne, kBelowOne));
    const float slope_x = alpha.x * (cos_phi * along - sin_phi * across);
    const float slope_y = alpha.y * (sin_phi * along + cos_phi * across);
    return normalize({-slope_x, -slope_y, 1.0f});
  }
};

KARAT_REGISTER(MicrofacetDistribution, "beckmann", Beckmann);

}  // namespace
}  // namespace karat
