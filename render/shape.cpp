#include "render/shape.h"

#include <cmath>

#include "render/shapes/revolution.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr double kTwoPi = 6.28318530717958647692;
// Segments around the axis of a round geometry that must become a mesh, and from pole to pole.
constexpr int kFineSegments = 512;
constexpr int kFineRows = 256;

template <typename... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <typename... F>
Overloaded(F...) -> Overloaded<F...>;

// Whether two vectors are as long as each other and perpendicular, within a few float roundings.
bool same_length_and_perpendicular(Vec3 a, Vec3 b) {
  constexpr float kTolerance = 1e-5f;
  const float aa = dot(a, a), bb = dot(b, b);
  return std::abs(aa - bb) <= kTolerance * aa && std::abs(dot(a, b)) <= kTolerance * aa;
}

bool is_similarity(const Transform& t) {
  return same_length_and_perpendicular(t.x, t.y) && same_length_and_perpendicular(t.y, t.z) &&
         same_length_and_perpendicular(t.z, t.x);
}

void check_invertible(const Transform& t) {
  const float determinant = t.determinant();
  if (std::isfinite(determinant) && determinant != 0.0f && std::isfinite(length(t.origin))) return;
  throw InputError("the transform is not invertible (its determinant is " +
                   std::to_string(determinant) + "); every axis must keep an extent");
}

Mesh moved(Mesh mesh, const Transform& transform) {
  for (Vec3& p : mesh.positions) p = transform.point(p);
  for (Vec3& n : mesh.normals) n = normalize(transform.normal(n));
  if (transform.determinant() < 0.0f) {
    const auto step = static_cast<std::size_t>(mesh.face_vertices);
    for (std::size_t face = 0; face + step <= mesh.indices.size(); face += step) {
      std::swap(mesh.indices[face + 1], mesh.indices[face + step - 1]);
    }
  }
  return mesh;
}

Geometry moved(const SphereGeometry& sphere, const Transform& transform) {
  if (!is_similarity(transform)) return moved(tessellated(sphere), transform);
  return SphereGeometry{transform.point(sphere.center), sphere.radius * length(transform.x),
                        normalize(transform.vector(sphere.pole)),
                        normalize(transform.vector(sphere.meridian))};
}

// A disk needs the similarity in its own plane only.
Geometry moved(const DiskGeometry& disk, const Transform& transform) {
  const Vec3 s = transform.vector(disk.tangent);
  const Vec3 t = transform.vector(cross(disk.normal, disk.tangent));
  if (!same_length_and_perpendicular(s, t)) return moved(tessellated(disk), transform);
  return DiskGeometry{transform.point(disk.center), normalize(transform.normal(disk.normal)),
                      disk.radius * length(s), normalize(s)};
}

// A mirrored rectangle runs along its first edge the other way, which keeps its outward side.
Geometry moved(const RectangleGeometry& r, const Transform& transform) {
  const Vec3 edge_u = transform.vector(r.edge_u), edge_v = transform.vector(r.edge_v);
  const Vec3 origin = transform.point(r.origin);
  if (transform.determinant() < 0.0f) return RectangleGeometry{origin + edge_u, -edge_u, edge_v};
  return RectangleGeometry{origin, edge_u, edge_v};
}

Mesh mesh_of(const SphereGeometry& sphere) {
  std::vector<ProfilePoint> profile;
  for (int j = 0; j <= kFineRows; ++j) {
    const double v = static_cast<double>(j) / kFineRows, angle = 0.5 * kTwoPi * (v - 0.5);
    const bool pole = j == 0 || j == kFineRows;
    const double c = pole ? 0.0 : std::cos(angle), s = std::sin(angle);
    profile.push_back({sphere.radius * c, sphere.radius * s, c, s, v});
  }
  const Vec3 east = cross(sphere.pole, sphere.meridian);
  return moved(revolved(profile, kFineSegments),
               {sphere.meridian, east, sphere.pole, sphere.center});
}

Mesh mesh_of(const DiskGeometry& disk) {
  const std::vector<ProfilePoint> profile{{disk.radius, 0, 0, 1, 0}, {0, 0, 0, 1, 1}};
  return moved(revolved(profile, kFineSegments),
               {disk.tangent, cross(disk.normal, disk.tangent), disk.normal, disk.center});
}

Mesh mesh_of(const RectangleGeometry& r) {
  Mesh mesh;
  mesh.face_vertices = 4;
  mesh.positions = {r.origin, r.origin + r.edge_u, r.origin + r.edge_u + r.edge_v,
                    r.origin + r.edge_v};
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.indices = {0, 1, 2, 3};
  return mesh;
}

double triangle_area(Vec3 a, Vec3 b, Vec3 c) {
  const double ux = double{b.x} - a.x, uy = double{b.y} - a.y, uz = double{b.z} - a.z;
  const double vx = double{c.x} - a.x, vy = double{c.y} - a.y, vz = double{c.z} - a.z;
  const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
  return 0.5 * std::sqrt(x * x + y * y + z * z);
}

// A quad is the two triangles that Embree makes of it: 0 1 3 and 2 3 1.
double area_of(const Mesh& mesh) {
  const auto corner = [&](std::size_t i) { return mesh.positions[mesh.indices[i]]; };
  const auto step = static_cast<std::size_t>(mesh.face_vertices);
  double area = 0.0;
  for (std::size_t i = 0; i + step <= mesh.indices.size(); i += step) {
    area += triangle_area(corner(i), corner(i + 1), corner(i + step - 1));
    if (step == 4) area += triangle_area(corner(i + 2), corner(i + 3), corner(i + 1));
  }
  return area;
}

}  // namespace

Geometry transformed(const Geometry& geometry, const Transform& transform) {
  check_invertible(transform);
  return std::visit([&](const auto& g) -> Geometry { return moved(g, transform); }, geometry);
}

Mesh tessellated(const Geometry& geometry) {
  return std::visit(
      Overloaded{[](const Mesh& mesh) { return mesh; }, [](const auto& g) { return mesh_of(g); }},
      geometry);
}

double surface_area(const Geometry& geometry) {
  return std::visit(
      Overloaded{
          [](const Mesh& mesh) { return area_of(mesh); },
          [](const SphereGeometry& s) { return 2.0 * kTwoPi * s.radius * s.radius; },
          [](const DiskGeometry& d) { return 0.5 * kTwoPi * d.radius * d.radius; },
          [](const RectangleGeometry& r) { return double{length(cross(r.edge_u, r.edge_v))}; }},
      geometry);
}

std::vector<Vec3> vertex_normals(const Mesh& mesh, std::size_t first_index) {
  std::vector<Vec3> normals(mesh.positions.size());
  const auto step = static_cast<std::size_t>(mesh.face_vertices);
  for (std::size_t face = first_index; face + step <= mesh.indices.size(); face += step) {
    for (std::size_t i = 0; i < step; ++i) {
      const std::uint32_t here = mesh.indices[face + i];
      const Vec3 to_next =
          mesh.positions[mesh.indices[face + (i + 1) % step]] - mesh.positions[here];
      const Vec3 to_last =
          mesh.positions[mesh.indices[face + (i + step - 1) % step]] - mesh.positions[here];
      const Vec3 n = cross(to_next, to_last);
      const float twice_area = length(n);
      if (!(twice_area > 0.0f)) continue;
      const float angle = std::atan2(twice_area, dot(to_next, to_last));
      normals[here] += n * (angle / twice_area);
    }
  }
  for (Vec3& n : normals) {
    const float l = length(n);
    n = l > 0.0f ? n / l : Vec3{0, 0, 1};
  }
  return normals;
}

}  // namespace karat
