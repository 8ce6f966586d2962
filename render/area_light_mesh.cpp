// A luminous mesh: a triangle is drawn in proportion to its area, then a point uniformly in it.
#include <cmath>

#include "render/area_light.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

struct Triangle {
  Vec3 corner, edge1, edge2;
};

// A quad is the two triangles that Embree makes of it: 0 1 3 and 2 3 1.
std::vector<Triangle> triangles_of(const Mesh& mesh) {
  std::vector<Triangle> triangles;
  const auto corner = [&](std::size_t i) { return mesh.positions[mesh.indices[i]]; };
  const auto add = [&](Vec3 a, Vec3 b, Vec3 c) {
    const Triangle t{a, b - a, c - a};
    if (length_squared(cross(t.edge1, t.edge2)) > 0.0f) triangles.push_back(t);
  };
  const auto step = static_cast<std::size_t>(mesh.face_vertices);
  for (std::size_t i = 0; i + step <= mesh.indices.size(); i += step) {
    add(corner(i), corner(i + 1), corner(i + step - 1));
    if (step == 4) add(corner(i + 2), corner(i + 3), corner(i + 1));
  }
  if (triangles.empty()) throw InputError("a mesh without area cannot emit");
  return triangles;
}

Light::Bounds bounds_of(const std::vector<Triangle>& triangles) {
  Vec3 lower = triangles[0].corner, upper = lower;
  const auto include = [&](Vec3 p) {
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
  };
  for (const Triangle& t : triangles) {
    include(t.corner), include(t.corner + t.edge1), include(t.corner + t.edge2);
  }
  return {0.5f * (lower + upper), 0.5f * length(upper - lower)};
}

class MeshLight final : public AreaLight {
 public:
  MeshLight(std::vector<Triangle> triangles, double area, const LatticeSpectrum& spectrum,
            bool both)
      : AreaLight(spectrum, both, area, bounds_of(triangles)), triangles_(std::move(triangles)) {
    // Summed in double, each fraction rounded once.
    double sum = 0.0;
    std::vector<double> sums;
    for (const Triangle& t : triangles_) {
      sums.push_back(sum += double{length(cross(t.edge1, t.edge2))});
    }
    for (const double s : sums) upper_.push_back(static_cast<float>(s / sum));
    upper_.back() = 1.0f;
  }

 protected:
  SurfacePoint surface_point(const Vec2& u) const override {
    const auto chosen = std::upper_bound(upper_.begin(), upper_.end() - 1, u.x);
    const float lower = chosen == upper_.begin() ? 0.0f : *(chosen - 1);
    const float within = std::min((u.x - lower) / (*chosen - lower), 1.0f);
    const Triangle& t = triangles_[static_cast<std::size_t>(chosen - upper_.begin())];
    const Vec2 b = barycentric({within, u.y});
    return {t.corner + t.edge1 * b.x + t.edge2 * b.y, normalize(cross(t.edge1, t.edge2))};
  }

 private:
  // Uniform over a triangle without a square root (Heitz, "A low-distortion map between triangle
  // and square", 2019).
  static Vec2 barycentric(Vec2 u) {
    if (u.y > u.x) return {0.5f * u.x, u.y - 0.5f * u.x};
    return {u.x - 0.5f * u.y, 0.5f * u.y};
  }

  std::vector<Triangle> triangles_;
  std::vector<float> upper_;  // running sum of areas, as a fraction of the whole
};

}  // namespace

std::unique_ptr<const Light> make_mesh_light(const Mesh& mesh, const LatticeSpectrum& radiance,
                                             bool two_sided) {
  return std::make_unique<MeshLight>(triangles_of(mesh), surface_area(mesh), radiance, two_sided);
}

}  // namespace karat
