// A luminous rectangle, sampled uniformly over the solid angle that it fills: Ureña, Fajardo and
// King, "An area-preserving parametrization for spherical rectangles", EGSR 2013.
//
// Two changes make it cheap and safe. The angles of the spherical rectangle enter only through
// their cosines and sines, so no arc cosine is taken. The solid angle comes from its two triangles
// by van Oosterom and Strackee, "The solid angle of a plane triangle", IEEE Trans. Biomed. Eng.
// 30(2), 1983, which loses no digits where it is small. Very small ones, and parallelograms that
// are no rectangles, are sampled uniformly over the area.
#include <cmath>

#include "render/area_light.h"

namespace karat {
namespace {

// Below, float noise in the angles of the spherical rectangle would show in the sampled positions,
// and uniform points serve as well.
constexpr float kSmallestSolidAngle = 1e-3f;
// Above, the corners' sum is accurate to a few units in the last place.
constexpr float kLargeSolidAngle = 0.1f;
// Beyond this many diagonals' squares the density of an area sample is so even (to about a tenth
// over the rectangle) that spherical sampling gains nothing that could be seen, and costs five
// times more.
constexpr float kFarDiagonals = 2.0f;
// Points nearer to the light's plane, relative to its size, see it edge-on.
constexpr float kNearPlane = 1e-6f;

// The rectangle seen from a point: it spans [x0, x1] x [y0, y1] at height z < 0 in its own axes.
struct View {
  float x0, x1, y0, y1, z;
  float solid_angle;  // 0: cannot be seen
};

// Complex numbers as (real, imaginary): their arguments add up in a product.
Vec2 product(Vec2 a, Vec2 b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
float argument(Vec2 a) { return std::atan2(a.y, a.x); }

// A number whose argument is half the solid angle of a triangle of unit vectors, given their triple
// product: van Oosterom and Strackee, "The solid angle of a plane triangle", IEEE Trans. Biomed.
// Eng. 30(2), 1983, eq. 8.
Vec2 half_triangle(float triple, float ab, float bc, float ca) {
  return {1.0f + ab + bc + ca, triple};
}

class RectangleLight final : public AreaLight {
 public:
  RectangleLight(const RectangleGeometry& r, const LatticeSpectrum& spectrum, bool both)
      : AreaLight(spectrum, both, length(cross(r.edge_u, r.edge_v)),
                  {r.origin + 0.5f * (r.edge_u + r.edge_v),
                   0.5f * std::max(length(r.edge_u + r.edge_v), length(r.edge_u - r.edge_v))}),
        rectangle_(r),
        normal_(normalize(cross(r.edge_u, r.edge_v))),
        x_(normalize(r.edge_u)),
        y_(normalize(r.edge_v)),
        width_(length(r.edge_u)),
        height_(length(r.edge_v)),
        far_squared_(kFarDiagonals * length_squared(r.edge_u + r.edge_v)),
        near_plane_(kNearPlane * (width_ + height_)),
        perpendicular_(std::abs(dot(x_, y_)) < 1e-5f) {}

  std::optional<LightSample> sample(const Vec3& point, const Vec2& u, int phase) const override {
    if (is_far(point)) return towards(point, surface_point(u), phase);
    const View v = view(point);
    if (v.solid_angle == 0.0f) return std::nullopt;
    if (v.solid_angle < kSmallestSolidAngle || !perpendicular_) {
      return towards(point, surface_point(u), phase);
    }
    const Vec3 local = spherical_point(v, u);
    const Vec3 away = dot(rectangle_.origin - point, normal_) > 0.0f ? -normal_ : normal_;
    const float distance = length(local);
    const Vec3 wi = (x_ * local.x + y_ * local.y + away * local.z) * (1.0f / distance);
    return LightSample{wi, distance, 1.0f / v.solid_angle, emitted(phase)};
  }

  float pdf(const Vec3& point, const Vec3& wi, const SurfaceHit* hit) const override {
    if (is_far(point)) return area_pdf(point, wi, *hit);
    const View v = view(point);
    if (v.solid_angle == 0.0f) return 0.0f;
    if (v.solid_angle < kSmallestSolidAngle || !perpendicular_) return area_pdf(point, wi, *hit);
    return 1.0f / v.solid_angle;
  }

 protected:
  SurfacePoint surface_point(const Vec2& u) const override {
    return {rectangle_.origin + rectangle_.edge_u * u.x + rectangle_.edge_v * u.y, normal_};
  }

 private:
  bool is_far(const Vec3& point) const {
    return length_squared(bounds().center - point) > far_squared_;
  }

  View view(const Vec3& point) const {
    const Vec3 d = rectangle_.origin - point;
    const float height = dot(d, normal_);  // negative on the outward side
    if (std::abs(height) < near_plane_ || (height > 0.0f && !two_sided())) return {};
    const float x0 = dot(d, x_), y0 = dot(d, y_);
    View v{x0, x0 + width_, y0, y0 + height_, -std::abs(height), 1.0f};
    if (perpendicular_) v.solid_angle = solid_angle(v);
    return v;
  }

  float solid_angle(const View& v) const {
    const float z = -v.z, zz = z * z;
    const float xx0 = v.x0 * v.x0, xx1 = v.x1 * v.x1, yy0 = v.y0 * v.y0, yy1 = v.y1 * v.y1;
    const float i00 = 1.0f / std::sqrt(xx0 + yy0 + zz), i10 = 1.0f / std::sqrt(xx1 + yy0 + zz);
    const float i01 = 1.0f / std::sqrt(xx0 + yy1 + zz), i11 = 1.0f / std::sqrt(xx1 + yy1 + zz);
    // The rectangle between the foot of the perpendicular and a corner (x, y) fills the solid angle
    // atan(x y / (z r)), r the corner's distance.
    const Vec2 corners =
        product(product({z * i00, v.x0 * v.y0 * i00 * i00}, {z * i11, v.x1 * v.y1 * i11 * i11}),
                product({z * i10, -v.x1 * v.y0 * i10 * i10}, {z * i01, -v.x0 * v.y1 * i01 * i01}));
    const float large = argument(corners);
    if (large > kLargeSolidAngle) return large;
    // Between pi and 2 pi; nearly 2 pi comes back as nearly 0, but only right above the rectangle.
    const bool above = v.x0 < 0.0f && v.x1 > 0.0f && v.y0 < 0.0f && v.y1 > 0.0f;
    const bool close = above && z < 0.1f * std::min(width_, height_);
    if (large < -kLargeSolidAngle || close) return large + 2.0f * kPi;

    const float xx = v.x0 * v.x1 + zz, yy = v.y0 * v.y1 + zz;
    const float diagonal = (xx + v.y0 * v.y1) * i00 * i11;
    const float volume = z * width_ * height_ * i00 * i11;
    const Vec2 a =
        half_triangle(volume * i10, (xx + yy0) * i00 * i10, (yy + xx1) * i10 * i11, diagonal);
    const Vec2 b =
        half_triangle(volume * i01, (xx + yy1) * i01 * i11, (yy + xx0) * i00 * i01, diagonal);
    const float half = argument(product(a, b));
    return 2.0f * (half < 0.0f ? half + kPi : half);
  }

  // A point of the rectangle in its axes. Ureña et al., sec. 3: n_i is the z component of the
  // normal of the plane through the point and edge i; the angles are gamma_i = acos(-n_i n_i+1).
  static Vec3 spherical_point(const View& v, Vec2 u) {
    const float zz = v.z * v.z;
    const float q0 = 1.0f / (zz + v.y0 * v.y0), q2 = 1.0f / (zz + v.y1 * v.y1);
    const float q3 = 1.0f / (zz + v.x0 * v.x0);
    const float n0 = -v.y0 * std::sqrt(q0), n2 = v.y1 * std::sqrt(q2), n3 = -v.x0 * std::sqrt(q3);
    // 1 - n_i^2 without cancellation.
    const float m0 = zz * q0, m2 = zz * q2, m3 = zz * q3;
    // phi = u S - gamma_2 - gamma_3, by the cosines and sines of its parts.
    const float c2 = -n2 * n3, s2 = std::sqrt(m2 + n2 * n2 * m3);
    const float c3 = -n3 * n0, s3 = std::sqrt(m3 + n3 * n3 * m0);
    const float c23 = c2 * c3 - s2 * s3, s23 = s2 * c3 + c2 * s3;
    const float angle = u.x * v.solid_angle;
    const float c = std::cos(angle), s = std::sin(angle);
    const float cos_phi = c * c23 + s * s23, sin_phi = s * c23 - c * s23;
    // f = (cos phi n0 - n2) / sin phi, cu = sign(f) / sqrt(f^2 + n0^2), x = -cu z / sqrt(1 - cu^2).
    const float f = cos_phi * n0 - n2;
    const float rest = f * f - sin_phi * sin_phi * m0;
    const float sign = (f < 0.0f) != (sin_phi < 0.0f) ? -1.0f : 1.0f;
    const float x_free = -sign * v.z * std::abs(sin_phi) / std::sqrt(std::max(rest, 1e-20f));
    const float x = std::min(std::max(x_free, v.x0), v.x1);
    const float dd = x * x + zz;
    const float h0 = v.y0 / std::sqrt(dd + v.y0 * v.y0), h1 = v.y1 / std::sqrt(dd + v.y1 * v.y1);
    const float h = h0 + u.y * (h1 - h0);
    const float y_free = h * std::sqrt(dd / std::max(1.0f - h * h, 1e-12f));
    return {x, std::min(std::max(y_free, v.y0), v.y1), v.z};
  }

  RectangleGeometry rectangle_;
  Vec3 normal_, x_, y_;
  float width_, height_, far_squared_, near_plane_;
  bool perpendicular_;
};

}  // namespace

std::unique_ptr<const Light> make_rectangle_light(const RectangleGeometry& rectangle,
                                                  const LatticeSpectrum& radiance, bool two_sided) {
  return std::make_unique<RectangleLight>(rectangle, radiance, two_sided);
}

}  // namespace karat
