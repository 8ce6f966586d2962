#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "default_parameters.h"
#include "render/shape.h"
#include "spectral/support/error.h"
#include "tests/temporary_folder.h"

using namespace karat;

namespace {

struct Folder : test::TemporaryFolder {
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
    return file(name);
  }
};

// A tetrahedron with corners at the origin and at 1 on each axis: volume 1/6, area 3/2 + sqrt(3)/2.
const char* const kObj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
const char* const kPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
const char* const kStl =
    "solid t\n"
    "facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
    "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "facet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\n"
    "facet normal 1 1 1\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "endsolid t\n";

// The same corners in a glTF buffer (48 bytes of positions, 24 of indices), placed by a node.
std::string gltf(const std::string& node) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)" +
         node +
         R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"buffers":[{"byteLength":72,"uri":"t.bin"}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},
{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}]})";
}
std::string gltf_buffer() {
  const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::uint16_t indices[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  return std::string(reinterpret_cast<const char*>(positions), sizeof positions) +
         std::string(reinterpret_cast<const char*>(indices), sizeof indices);
}

double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]];
    sum += double{dot(a, cross(b, mesh.positions[mesh.indices[i + 2]]))} / 6.0;
  }
  return sum;
}

void check_tetrahedron(const Mesh& mesh, double scale_cubed = 1.0) {
  CHECK(mesh.face_vertices == 3);
  CHECK(mesh.indices.size() == 12);
  CHECK(volume(mesh) == Approx(scale_cubed / 6.0).epsilon(1e-6));
  CHECK(surface_area(mesh) ==
        Approx(std::cbrt(scale_cubed * scale_cubed) * (1.5 + std::sqrt(3.0) / 2)).epsilon(1e-6));
}

}  // namespace

TEST_CASE("the four mesh formats give the same solid", "[mesh_file]") {
  const Folder folder;
  folder.write("t.bin", gltf_buffer());
  for (const std::string& path : {folder.write("t.obj", kObj), folder.write("t.ply", kPly),
                                  folder.write("t.stl", kStl), folder.write("t.gltf", gltf(""))}) {
    INFO(path);
    const Mesh mesh = read_mesh_file(path);
    check_tetrahedron(mesh);
    CHECK(mesh.positions.size() == 4);  // joined, also in STL, which repeats every corner
    CHECK(mesh.normals.empty());
    CHECK(mesh.uvs.empty());
  }
}

TEST_CASE("node transforms are applied, mirrors keep the outside out", "[mesh_file]") {
  const Folder folder;
  folder.write("t.bin", gltf_buffer());
  const Mesh moved =
      read_mesh_file(folder.write("m.gltf", gltf(R"(,"translation":[5,0,0],"scale":[2,2,2])")));
  check_tetrahedron(moved, 8.0);
  for (const Vec3 p : moved.positions) CHECK(p.x >= 5.0f);
  check_tetrahedron(read_mesh_file(folder.write("n.gltf", gltf(R"(,"scale":[1,1,-1])"))));
}

TEST_CASE("normals and texture coordinates are kept", "[mesh_file]") {
  const Folder folder;
  const Mesh mesh = read_mesh_file(
      folder.write("n.obj",
                   "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 0.5 0\nvt 0.5 0.25\nvt 0 0.25\n"
                   "vn 0 0 2\nvn 0.6 0 0.8\nf 1/1/1 2/2/2 3/3/2 4/4/1\n"));
  REQUIRE(mesh.positions.size() == 4);
  REQUIRE(mesh.normals.size() == 4);
  REQUIRE(mesh.uvs.size() == 4);
  CHECK(mesh.indices.size() == 6);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 p = mesh.positions[i];
    CHECK(mesh.normals[i].x == Approx(p.x == 1.0f ? 0.6f : 0.0f).margin(1e-6));
    CHECK(length(mesh.normals[i]) == Approx(1.0f));
    CHECK(mesh.uvs[i].x == Approx(0.5f * p.x).margin(1e-6));
    CHECK(mesh.uvs[i].y == Approx(0.25f * p.y).margin(1e-6));
  }
}

TEST_CASE("triangles without an area are left out", "[mesh_file]") {
  const Folder folder;
  const Mesh mesh = read_mesh_file(
      folder.write("d.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\nf 1 2 4\n"));
  CHECK(mesh.indices.size() == 3);
}

TEST_CASE("the mesh shape smooths on request only", "[mesh_file]") {
  const Folder folder;
  const ShapeType* type = Registry<ShapeType>::instance().find("mesh");
  REQUIRE(type);
  Parameters parameters = default_parameters(type->parameters());
  parameters.set("file", folder.write("t.obj", kObj));
  CHECK(std::get<Mesh>(type->create(parameters)).normals.empty());
  parameters.set("smooth", true);
  const Mesh smooth = std::get<Mesh>(type->create(parameters));
  REQUIRE(smooth.normals.size() == 4);
  // At the origin three right angles meet: the mean of the three axes, outward.
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(smooth.positions[i] == Vec3{0, 0, 0})) continue;
    const Vec3 expected = normalize({-1, -1, -1});
    CHECK(length(smooth.normals[i] - expected) < 1e-6f);
  }
}

TEST_CASE("mesh errors say what is wrong where", "[mesh_file]") {
  const Folder folder;
  const auto error_of = [](const std::string& path) -> std::string {
    try {
      read_mesh_file(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  using Catch::Contains;
  CHECK_THAT(error_of(folder.file("none.obj")), Contains("none.obj") && Contains("no such file"));
  CHECK_THAT(error_of(folder.write("a.objj", kObj)),
             Contains(".objj") && Contains("did you mean \".obj\""));
  CHECK_THAT(error_of(folder.write("broken.gltf", "{\"asset\":")), Contains("cannot be read"));
  CHECK_THAT(error_of(folder.write("broken.ply", "ply\nformat ascii 1.0\nelement vertex 4\n")),
             Contains("broken.ply"));
  CHECK_THAT(error_of(folder.write("empty.obj", "")),
             Contains("empty.obj") && Contains("no triangles"));
  CHECK_THAT(error_of(folder.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\np 1 2 3\n")),
             Contains("points.obj") && Contains("no triangles"));
  CHECK_THAT(error_of(folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")),
             Contains("no triangles"));
  CHECK_THAT(error_of(folder.write("nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n")),
             Contains("vertex 1") && Contains("finite"));
  CHECK_THAT(error_of(folder.write("inf.ply", std::string(kPly).replace(
                                                  std::string(kPly).find("1 0 0"), 5, "inf 0 0"))),
             Contains("inf.ply"));
  CHECK_THAT(error_of(folder.write("far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")),
             Contains("far.obj"));
  CHECK_THAT(
      error_of(folder.write(
          "far.ply", std::string(kPly).replace(std::string(kPly).find("3 1 2 3"), 7, "3 1 2 7"))),
      Contains("far.ply"));
}
