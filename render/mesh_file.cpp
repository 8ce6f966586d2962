// Reading meshes with Assimp, and checking what comes out before anything relies on it.
#include <assimp/config.h>
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <new>

#include "render/shape.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{8} << 30;
constexpr std::size_t kMostIndices = std::size_t{1} << 31;
constexpr std::size_t kMostNodes = 1 << 20;  // placed meshes: a file can repeat one without end

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

void check_file(const std::string& path) {
  const std::vector<std::string> known{".obj", ".ply", ".stl", ".gltf", ".glb"};
  if (const std::string extension = extension_of(path);
      std::find(known.begin(), known.end(), extension) == known.end()) {
    throw InputError(path, "", unknown_name_message("mesh format", extension, known));
  }
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw InputError(path, "", "no such file");
  if (!std::filesystem::is_regular_file(path, error)) throw InputError(path, "", "not a file");
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (error) throw InputError(path, "", "cannot be read: " + error.message());
  if (bytes > kMostBytes) {
    throw InputError(path, "",
                     "the file has " + std::to_string(bytes) + " bytes, more than " +
                         std::to_string(kMostBytes));
  }
}

// Assimp 5.2 searches for the end of a PLY file's header without end.
void check_ply_header(const std::string& path) {
  constexpr std::size_t kLongestHeader = 1 << 20;
  std::ifstream file(path, std::ios::binary);
  std::string head(kLongestHeader, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  if (head.find("end_header") != std::string::npos) return;
  throw InputError(path, "", "the header of this PLY file has no end (\"end_header\")");
}

Transform to_transform(const aiMatrix4x4& m) {
  return {{m.a1, m.b1, m.c1}, {m.a2, m.b2, m.c2}, {m.a3, m.b3, m.c3}, {m.a4, m.b4, m.c4}};
}

bool is_finite(const aiVector3D& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Vec3 to_vec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }

std::string describe(const aiVector3D& v) {
  return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
}

// Not one point and not one line: Embree could never hit it, and it has no normal.
bool has_area(Vec3 a, Vec3 b, Vec3 c) {
  const double ux = double{b.x} - a.x, uy = double{b.y} - a.y, uz = double{b.z} - a.z;
  const double vx = double{c.x} - a.x, vy = double{c.y} - a.y, vz = double{c.z} - a.z;
  return uy * vz != uz * vy || uz * vx != ux * vz || ux * vy != uy * vx;
}

std::string place_of(const aiMesh& mesh) {
  return mesh.mName.length > 0 ? "mesh \"" + std::string(mesh.mName.C_Str()) + "\"" : "mesh";
}

// Checks a mesh as the file has it: Assimp's own steps would move or repair what is wrong.
void check_mesh(const std::string& path, const aiMesh& mesh) {
  const auto check = [&](const aiVector3D* values, const char* what) {
    for (unsigned i = 0; values && i < mesh.mNumVertices; ++i) {
      if (is_finite(values[i])) continue;
      throw InputError(path, place_of(mesh),
                       std::string(what) + " " + std::to_string(i) + " is " + describe(values[i]) +
                           "; it must be finite");
    }
  };
  check(mesh.mVertices, "vertex");
  check(mesh.mNormals, "the normal of vertex");
  check(mesh.mTextureCoords[0], "the texture coordinate of vertex");
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      if (face.mIndices[i] < mesh.mNumVertices) continue;
      throw InputError(path, place_of(mesh),
                       "face " + std::to_string(f) + " names vertex " +
                           std::to_string(face.mIndices[i]) + "; there are " +
                           std::to_string(mesh.mNumVertices));
    }
  }
}

// Gathers the meshes of a file into one.
class Collector {
 public:
  explicit Collector(const std::string& path) : path_(path) {}

  void add_node(const aiScene& scene, const aiNode& root) {
    std::vector<std::pair<const aiNode*, Transform>> open{
        {&root, to_transform(root.mTransformation)}};
    while (!open.empty()) {
      const auto [node, to_world] = open.back();
      open.pop_back();
      for (unsigned i = 0; i < node->mNumMeshes; ++i) {
        if (++placed_ > kMostNodes) throw InputError(path_, "", "more than 2^20 placed meshes");
        add_mesh(*scene.mMeshes[node->mMeshes[i]], to_world);
      }
      for (unsigned i = node->mNumChildren; i-- > 0;) {
        const aiNode* child = node->mChildren[i];
        open.emplace_back(child, to_world * to_transform(child->mTransformation));
      }
    }
  }

  Mesh take() {
    if (mesh_.indices.empty()) throw InputError(path_, "", "has no triangles with an area");
    if (!has_normals_) mesh_.normals.clear();
    if (!has_uvs_) mesh_.uvs.clear();
    return std::move(mesh_);
  }

 private:
  void add_mesh(const aiMesh& mesh, const Transform& to_world) {
    const std::string place = place_of(mesh);
    if (mesh_.indices.size() + 3 * std::size_t{mesh.mNumFaces} > kMostIndices) {
      throw InputError(path_, place, "more than 2^31 indices");
    }
    const std::size_t first = mesh_.positions.size(), first_index = mesh_.indices.size();
    const bool mirrored = to_world.determinant() < 0.0f;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const Vec3 p = to_world.point(to_vec3(mesh.mVertices[i]));
      if (!std::isfinite(p.x + p.y + p.z)) {
        throw InputError(path_, place,
                         "vertex " + std::to_string(i) + " is not finite once it is placed");
      }
      mesh_.positions.push_back(p);
    }
    add_faces(mesh, first, mirrored);
    add_normals(mesh, to_world, first, first_index);
    mesh_.uvs.resize(mesh_.positions.size());
    if (!mesh.HasTextureCoords(0)) return;
    has_uvs_ = true;
    for (std::size_t i = 0; i < mesh.mNumVertices; ++i) {
      mesh_.uvs[first + i] = {mesh.mTextureCoords[0][i].x, mesh.mTextureCoords[0][i].y};
    }
  }

  void add_faces(const aiMesh& mesh, std::size_t first, bool mirrored) {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines
      std::uint32_t corner[3];
      for (int i = 0; i < 3; ++i) corner[i] = static_cast<std::uint32_t>(first + face.mIndices[i]);
      if (mirrored) std::swap(corner[1], corner[2]);
      const auto& p = mesh_.positions;
      if (!has_area(p[corner[0]], p[corner[1]], p[corner[2]])) continue;
      mesh_.indices.insert(mesh_.indices.end(), corner, corner + 3);
    }
  }

  // A vertex without a normal, among others that have one, gets the mean of its faces' normals.
  void add_normals(const aiMesh& mesh, const Transform& to_world, std::size_t first,
                   std::size_t first_index) {
    mesh_.normals.resize(mesh_.positions.size());
    if (mesh.HasNormals()) {
      has_normals_ = true;
      for (std::size_t i = 0; i < mesh.mNumVertices; ++i) {
        const Vec3 n = to_world.normal(to_vec3(mesh.mNormals[i]));
        if (length_squared(n) > 0.0f) mesh_.normals[first + i] = normalize(n);
      }
    }
    const std::vector<Vec3> means = vertex_normals(mesh_, first_index);
    for (std::size_t i = first; i < mesh_.normals.size(); ++i) {
      if (!(length_squared(mesh_.normals[i]) > 0.0f)) mesh_.normals[i] = means[i];
    }
  }

  std::string path_;
  Mesh mesh_;
  bool has_normals_ = false, has_uvs_ = false;
  std::size_t placed_ = 0;
};

}  // namespace

Mesh read_mesh_file(const std::string& path) {
  check_file(path);
  if (extension_of(path) == ".ply") check_ply_header(path);
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const unsigned steps = aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                         aiProcess_SortByPType | aiProcess_RemoveComponent;
  // Colours keep equal vertices apart; an STL file's normals say no more than its faces do.
  int removed = aiComponent_COLORS | aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_MATERIALS |
                aiComponent_TEXTURES | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
                aiComponent_LIGHTS | aiComponent_CAMERAS;
  if (extension_of(path) == ".stl") removed |= aiComponent_NORMALS;
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, removed);
  try {
    const aiScene* scene = importer.ReadFile(path, 0);
    for (unsigned i = 0; scene && i < scene->mNumMeshes; ++i) check_mesh(path, *scene->mMeshes[i]);
    if (scene) scene = importer.ApplyPostProcessing(steps);
    if (!scene || !scene->mRootNode) {
      throw InputError(path, "",
                       fmt::format("cannot be read as a mesh, or has no triangles: {}",
                                   importer.GetErrorString()));
    }
    Collector collector(path);
    collector.add_node(*scene, *scene->mRootNode);
    return collector.take();
  } catch (const std::bad_alloc&) {
    throw InputError(path, "", "needs more memory than there is");
  }
}

}  // namespace karat
