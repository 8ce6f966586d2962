// A luminous sphere: its visible cap is sampled uniformly in solid angle.
#include <cmath>

#include "materials/sampling.h"
#include "render/area_light.h"

namespace karat {
namespace {

// What a point sees: a cone around the center, or every direction from inside.
struct View {
  Vec3 to_center;
  float distance_squared;  // to the center
  float one_minus_cos;     // of the cone's half angle; 2 inside; 0 where the light is dark
};

class SphereLight final : public AreaLight {
 public:
  SphereLight(const SphereGeometry& s, const LatticeSpectrum& spectrum, bool both)
      : AreaLight(spectrum, both, 4.0 * kPi * s.radius * s.radius, {s.center, s.radius}),
        center_(s.center),
        radius_(s.radius) {}

  std::optional<LightSample> sample(const Vec3& point, const Vec2& u, int phase) const override {
    const View v = view(point);
    if (v.one_minus_cos == 0.0f) return std::nullopt;
    const float one_minus_cos = u.x * v.one_minus_cos;
    const float cosine = 1.0f - one_minus_cos;
    const float sin2 = one_minus_cos * (1.0f + cosine);
    const float sine = std::sqrt(std::max(0.0f, sin2)), angle = 2.0f * kPi * u.y;
    const float d = std::sqrt(v.distance_squared);
    const Vec3 axis = d > 0.0f ? v.to_center * (1.0f / d) : Vec3{0, 0, 1};
    const Vec3 wi =
        Frame::around(axis).to_world({sine * std::cos(angle), sine * std::sin(angle), cosine});
    // The near intersection from outside, the only one from inside.
    const float half_chord =
        std::sqrt(std::max(0.0f, radius_ * radius_ - v.distance_squared * sin2));
    const bool inside = v.one_minus_cos == 2.0f;
    const float distance = d * cosine + (inside ? half_chord : -half_chord);
    if (!(distance > 0.0f)) return std::nullopt;
    return LightSample{wi, distance, density(v), emitted(phase)};
  }

  float pdf(const Vec3& point, const Vec3&, const SurfaceHit*) const override {
    const View v = view(point);
    return v.one_minus_cos == 0.0f ? 0.0f : density(v);
  }

 protected:
  SurfacePoint surface_point(const Vec2& u) const override {
    const Vec3 n = square_to_sphere(u);
    return {center_ + n * radius_, n};
  }

 private:
  View view(const Vec3& point) const {
    const Vec3 to_center = center_ - point;
    const float dd = length_squared(to_center), rr = radius_ * radius_;
    if (dd <= rr) return {to_center, dd, two_sided() ? 2.0f : 0.0f};
    // 1 - cos = sin^2 / (1 + cos) keeps its digits for far points, where cos is nearly 1.
    const float sin2 = rr / dd;
    return {to_center, dd, sin2 / (1.0f + std::sqrt(1.0f - sin2))};
  }
  static float density(const View& v) { return 0.5f * kInvPi / v.one_minus_cos; }

  Vec3 center_;
  float radius_;
};

}  // namespace

std::unique_ptr<const Light> make_sphere_light(const SphereGeometry& sphere,
                                               const LatticeSpectrum& radiance, bool two_sided) {
  return std::make_unique<SphereLight>(sphere, radiance, two_sided);
}

}  // namespace karat
