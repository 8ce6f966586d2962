// A triangle mesh from a file.
#include "render/shape.h"

namespace karat {
namespace {

class MeshShape final : public ShapeType {
 public:
  std::string description() const override {
    return "A triangle mesh from an OBJ, PLY, STL or glTF file, in the file's own axes.";
  }

  std::vector<ParameterInfo> parameters() const override {
    return {{.name = "file",
             .type = ParameterType::kPath,
             .description = "The mesh file (.obj, .ply, .stl, .gltf, .glb).",
             .required = true},
            {.name = "smooth",
             .type = ParameterType::kBoolean,
             .description = "Compute vertex normals where the file has none; flat faces otherwise.",
             .default_json = "false"}};
  }

  Geometry create(const Parameters& parameters) const override {
    Mesh mesh = read_mesh_file(parameters.string("file"));
    if (mesh.normals.empty() && parameters.boolean("smooth")) mesh.normals = vertex_normals(mesh);
    return mesh;
  }
};

KARAT_REGISTER(ShapeType, "mesh", MeshShape);

}  // namespace
}  // namespace karat
