#include "render/shapes/revolution.h"

#include <cmath>

namespace karat {
namespace {

// The unit circle at step i of n; i = n repeats i = 0 exactly, so that seams close.
Vec2 circle_point(int i, int n) {
  const double angle = 2.0 * 3.14159265358979323846 * (i % n) / n;
  return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

}  // namespace

Mesh revolved(const std::vector<ProfilePoint>& profile, int segments) {
  Mesh mesh;
  mesh.face_vertices = 4;
  const auto row = static_cast<std::uint32_t>(profile.size());
  const std::size_t vertices = profile.size() * static_cast<std::size_t>(segments + 1);
  mesh.positions.reserve(vertices);
  mesh.normals.reserve(vertices);
  mesh.uvs.reserve(vertices);
  for (int i = 0; i <= segments; ++i) {
    const Vec2 c = circle_point(i, segments);
    for (const ProfilePoint& p : profile) {
      const auto rho = static_cast<float>(p.rho), normal_rho = static_cast<float>(p.normal_rho);
      mesh.positions.push_back({rho * c.x, rho * c.y, static_cast<float>(p.z)});
      mesh.normals.push_back({normal_rho * c.x, normal_rho * c.y, static_cast<float>(p.normal_z)});
      mesh.uvs.push_back(
          {static_cast<float>(i) / static_cast<float>(segments), static_cast<float>(p.v)});
    }
  }
  mesh.indices.reserve(4 * static_cast<std::size_t>(segments) * (profile.size() - 1));
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(segments); ++i) {
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
      const std::uint32_t here = i * row + j, next = here + row;
      mesh.indices.insert(mesh.indices.end(), {here, next, next + 1, here + 1});
    }
  }
  return mesh;
}

}  // namespace karat
