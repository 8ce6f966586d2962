// Shapes: what a scene names, and the geometry that they turn into.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "materials/parameters.h"
#include "materials/vector.h"
#include "render/transform.h"
#include "spectral/support/registry.h"

namespace karat {

// Triangles or quads. `normals` and `uvs` are empty or one per position. Counter-clockwise faces
// look along their outward normal.
struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
  std::vector<Vec2> uvs;
  std::vector<std::uint32_t> indices;  // `face_vertices` for each face
  int face_vertices = 3;               // 3 or 4
};

// `pole` and `meridian`, unit and perpendicular, say how it is turned: v runs from the pole, u around
// it from the meridian.
struct SphereGeometry {
  Vec3 center;
  float radius = 1.0f;
  Vec3 pole{0, 0, 1}, meridian{1, 0, 0};
};

// A flat disk seen from both sides; `normal` is unit, and so is `tangent`, in the disk's plane.
struct DiskGeometry {
  Vec3 center;
  Vec3 normal{0, 0, 1};
  float radius = 1.0f;
  Vec3 tangent{1, 0, 0};
};

// A parallelogram: origin + u * edge_u + v * edge_v for u, v in [0, 1]; normal along edge_u x
// edge_v.
struct RectangleGeometry {
  Vec3 origin, edge_u, edge_v;
};

using Geometry = std::variant<Mesh, SphereGeometry, DiskGeometry, RectangleGeometry>;

// One source file per shape (render/shapes/), ending in KARAT_REGISTER(ShapeType, "torus", Torus);
class ShapeType {
 public:
  virtual ~ShapeType() = default;
  virtual std::string description() const = 0;
  virtual std::vector<ParameterInfo> parameters() const = 0;
  // In the shape's own coordinates; throws InputError.
  virtual Geometry create(const Parameters& parameters) const = 0;
};

// The geometry moved by a transform. A sphere or disk stays what it is under a similarity and
// becomes a fine mesh otherwise.
Geometry transformed(const Geometry& geometry, const Transform& transform);

// A quad or triangle mesh of any geometry (meshes are returned as they are).
Mesh tessellated(const Geometry& geometry);

// Area in scene units squared.
double surface_area(const Geometry& geometry);

// Reads OBJ, PLY, STL, glTF with Assimp: one mesh, all nodes' transforms applied. Throws
// InputError: no such file, no triangles, vertices that are not finite, more than 2^31 indices.
// Triangles without an area are left out.
Mesh read_mesh_file(const std::string& path);

// One unit normal per position: the mean over the faces from `first_index` in `indices` on,
// weighted by their angle at the vertex; +z where no face meets the vertex.
std::vector<Vec3> vertex_normals(const Mesh& mesh, std::size_t first_index = 0);

}  // namespace karat
