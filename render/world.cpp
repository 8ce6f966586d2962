#include "render/world.h"

#include <cstring>
#include <deque>
#include <limits>

#include "materials/material.h"

namespace karat {
namespace {

constexpr float kTwoPi = 2.0f * kPi;

// A geometry as it is stored, with what shading needs of it.
struct Item {
  Geometry geometry;
  Surface surface;
  bool uses_uv;

  Item(Geometry g, const Surface& s)
      : geometry(std::move(g)), surface(s), uses_uv(!s.material || s.material->uses_uv()) {
    surface.transmits = s.material && s.material->transmits();
    surface.only_delta = s.material && s.material->only_delta();
  }
};

Vec3 to_vec3(const float v[3]) { return {v[0], v[1], v[2]}; }

std::uint32_t attach(RayScene& scene, const Geometry& geometry) {
  if (const auto* mesh = std::get_if<Mesh>(&geometry)) {
    const auto faces = mesh->indices.size() / static_cast<std::size_t>(mesh->face_vertices);
    const float* positions = &mesh->positions.data()->x;
    return mesh->face_vertices == 4
               ? scene.add_quads(positions, mesh->positions.size(), mesh->indices.data(), faces)
               : scene.add_triangles(positions, mesh->positions.size(), mesh->indices.data(),
                                     faces);
  }
  if (const auto* sphere = std::get_if<SphereGeometry>(&geometry)) {
    return scene.add_sphere(&sphere->center.x, sphere->radius);
  }
  if (const auto* disk = std::get_if<DiskGeometry>(&geometry)) {
    return scene.add_disk(&disk->center.x, &disk->normal.x, disk->radius);
  }
  const auto& r = std::get<RectangleGeometry>(geometry);
  const Vec3 corners[4] = {r.origin, r.origin + r.edge_u, r.origin + r.edge_u + r.edge_v,
                           r.origin + r.edge_v};
  const std::uint32_t indices[4] = {0, 1, 2, 3};
  return scene.add_quads(&corners[0].x, 4, indices, 1);
}

// The three vertices of the triangle that was hit, with barycentric weights. Embree splits a quad
// along its second and fourth vertex; beyond that diagonal (u + v > 1) the third one is the origin.
struct HitTriangle {
  std::uint32_t a, b, c;
  float wa, wb, wc;

  HitTriangle(const Mesh& mesh, const EmbreeHit& hit) {
    const auto first =
        static_cast<std::size_t>(hit.primitive) * static_cast<std::size_t>(mesh.face_vertices);
    const std::uint32_t* v = mesh.indices.data() + first;
    a = v[0], b = v[1], c = v[mesh.face_vertices - 1];
    wb = hit.u, wc = hit.v;
    if (mesh.face_vertices == 4 && hit.u + hit.v > 1.0f) {
      a = v[2], b = v[3], c = v[1];
      wb = 1.0f - hit.u, wc = 1.0f - hit.v;
    }
    wa = 1.0f - wb - wc;
  }

  template <typename T>
  T interpolate(const std::vector<T>& values) const {
    return values[a] * wa + values[b] * wb + values[c] * wc;
  }
};

// locate() fills position and normals, parameterise() uv and tangent, both in the geometry's own
// coordinates. Positions are computed from the geometry, not from origin + t * direction, which is
// far less accurate.
void locate(const Mesh& mesh, const EmbreeHit& hit, SurfaceHit& out) {
  const HitTriangle triangle(mesh, hit);
  out.position = triangle.interpolate(mesh.positions);
  out.geometric_normal = to_vec3(hit.normal);
  out.shading_normal =
      mesh.normals.empty() ? out.geometric_normal : triangle.interpolate(mesh.normals);
}

void locate(const SphereGeometry& sphere, const EmbreeHit&, SurfaceHit& out) {
  const Vec3 n = normalize(out.position - sphere.center);
  out.position = sphere.center + n * sphere.radius;
  out.geometric_normal = out.shading_normal = n;
}

void locate(const DiskGeometry& disk, const EmbreeHit&, SurfaceHit& out) {
  out.position = out.position - disk.normal * dot(out.position - disk.center, disk.normal);
  out.geometric_normal = out.shading_normal = disk.normal;
}

void locate(const RectangleGeometry& rectangle, const EmbreeHit& hit, SurfaceHit& out) {
  out.position = rectangle.origin + rectangle.edge_u * hit.u + rectangle.edge_v * hit.v;
  out.geometric_normal = out.shading_normal = to_vec3(hit.normal);
}

void parameterise(const Mesh& mesh, const EmbreeHit& hit, SurfaceHit& out) {
  const HitTriangle triangle(mesh, hit);
  const Vec3 pa = mesh.positions[triangle.a];
  const Vec3 ab = mesh.positions[triangle.b] - pa, ac = mesh.positions[triangle.c] - pa;
  out.uv = {hit.u, hit.v};
  out.tangent = ab;
  if (!mesh.uvs.empty()) {
    out.uv = triangle.interpolate(mesh.uvs);
    const Vec2 ta = mesh.uvs[triangle.a], tb = mesh.uvs[triangle.b], tc = mesh.uvs[triangle.c];
    const float du_b = tb.x - ta.x, dv_b = tb.y - ta.y, du_c = tc.x - ta.x, dv_c = tc.y - ta.y;
    const Vec3 tangent = ab * dv_c - ac * dv_b;  // dp/du times the determinant
    out.tangent = du_b * dv_c - dv_b * du_c < 0.0f ? -tangent : tangent;
  }
}

void parameterise(const SphereGeometry& sphere, const EmbreeHit&, SurfaceHit& out) {
  const Frame frame{sphere.meridian, cross(sphere.pole, sphere.meridian), sphere.pole};
  const Vec3 n = frame.to_local(out.geometric_normal);
  out.tangent = cross(sphere.pole, out.geometric_normal);
  const float azimuth = std::atan2(n.y, n.x);
  out.uv = {(azimuth < 0.0f ? azimuth + kTwoPi : azimuth) / kTwoPi,
            std::acos(std::clamp(n.z, -1.0f, 1.0f)) * kInvPi};
}

void parameterise(const DiskGeometry& disk, const EmbreeHit&, SurfaceHit& out) {
  const Frame frame{disk.tangent, cross(disk.normal, disk.tangent), disk.normal};
  const Vec3 local = frame.to_local(out.position - disk.center);
  out.tangent = disk.tangent;
  out.uv = {local.x / disk.radius, local.y / disk.radius};
}

void parameterise(const RectangleGeometry& rectangle, const EmbreeHit& hit, SurfaceHit& out) {
  out.tangent = rectangle.edge_u;
  out.uv = {hit.u, hit.v};
}

// A segment ends just short of its target, so that the target does not shadow itself.
constexpr float kShortened = 1.0f - 1e-4f;

// At unit length and on the side of the geometric normal. The shading normal is zero where opposite
// ones meet: the geometric one then stands in.
inline Vec3 unit_shading_normal(const Vec3& shading, const Vec3& unit_geometric) {
  const float length2 = length_squared(shading);
  const float side = dot(shading, unit_geometric) < 0.0f ? -1.0f : 1.0f;
  const float own = length2 > 0.0f ? side / std::sqrt(length2) : 0.0f;
  const float other = length2 > 0.0f ? 0.0f : 1.0f;
  return shading * own + unit_geometric * other;
}

EmbreePacket to_embree(const BatchRay& rays) {
  static_assert(kPacket == kBatch);
  EmbreePacket packet;
  const BatchVec3* from[2] = {&rays.origin, &rays.direction};
  float(*to[2])[kPacket] = {packet.origin, packet.direction};
  for (int end = 0; end < 2; ++end) {
    std::memcpy(to[end][0], from[end]->x.values, sizeof to[end][0]);
    std::memcpy(to[end][1], from[end]->y.values, sizeof to[end][1]);
    std::memcpy(to[end][2], from[end]->z.values, sizeof to[end][2]);
  }
  return packet;
}

EmbreeRay to_embree(Vec3 origin, Vec3 direction) {
  return {{origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z}};
}

}  // namespace

struct World::Impl {
  struct Group {
    RayScene scene;
    std::vector<const Item*> items;  // by geometry number in the group's scene
  };
  struct Instance {
    const Group* group;
    Transform transform;
  };

  RayScene scene;
  std::deque<Item> items;  // addresses of surfaces stay valid
  std::deque<Group> groups;
  std::vector<const Item*> top;      // by geometry number; null for instances
  std::vector<Instance> instances;   // by geometry number minus first_instance
  std::uint32_t first_instance = 0;  // instances are attached at commit, after everything else

  // Position (given approximately), normals of any length, and where the surface's material wants
  // them uv and tangent.
  void locate_hit(const EmbreeHit& found, SurfaceHit& hit) const {
    const Transform* transform = nullptr;
    const Item* item;
    if (found.instance == kNoInstance) {
      item = top[found.geometry];
    } else {
      const Instance& instance = instances[found.instance - first_instance];
      transform = &instance.transform;
      item = instance.group->items[found.geometry];
      hit.position = transform->inverse_point(hit.position);
    }
    hit.tangent = {};
    hit.uv = {};
    std::visit(
        [&](const auto& geometry) {
          locate(geometry, found, hit);
          if (item->uses_uv) parameterise(geometry, found, hit);
        },
        item->geometry);
    if (transform) place(*transform, hit);
    hit.surface = &item->surface;
  }

  // A mirrored transform turns faces inside out; Transform::normal() keeps normals outward, so a
  // normal computed from the faces themselves needs no further flip.
  static void place(const Transform& transform, SurfaceHit& hit) {
    hit.position = transform.point(hit.position);
    hit.geometric_normal = transform.normal(hit.geometric_normal);
    hit.shading_normal = transform.normal(hit.shading_normal);
    hit.tangent = transform.vector(hit.tangent);
  }
};

World::World() : impl_(std::make_unique<Impl>()) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

const Surface* World::add(Geometry geometry, const Surface& surface) {
  const Item& item = impl_->items.emplace_back(std::move(geometry), surface);
  attach(impl_->scene, item.geometry);
  impl_->top.push_back(&item);
  return &item.surface;
}

void World::add_instances(std::vector<Placed> group, const std::vector<Transform>& transforms) {
  Impl::Group& stored = impl_->groups.emplace_back();
  for (Placed& placed : group) {
    const Item& item = impl_->items.emplace_back(std::move(placed.geometry), placed.surface);
    attach(stored.scene, item.geometry);
    stored.items.push_back(&item);
  }
  stored.scene.commit();
  for (const Transform& transform : transforms) impl_->instances.push_back({&stored, transform});
}

void World::commit() {
  impl_->first_instance = static_cast<std::uint32_t>(impl_->top.size());
  for (const Impl::Instance& instance : impl_->instances) {
    const Transform& t = instance.transform;
    const float columns[12] = {t.x.x, t.x.y, t.x.z, t.y.x,      t.y.y,      t.y.z,
                               t.z.x, t.z.y, t.z.z, t.origin.x, t.origin.y, t.origin.z};
    impl_->scene.add_instance(instance.group->scene, columns);
  }
  impl_->scene.commit();
}

bool World::intersect(const Vec3& origin, const Vec3& direction, SurfaceHit& hit) const {
  EmbreeHit found;
  if (!impl_->scene.intersect(to_embree(origin, direction), found)) return false;
  hit.distance = found.distance;
  hit.position = origin + direction * found.distance;
  impl_->locate_hit(found, hit);
  hit.geometric_normal = normalize(hit.geometric_normal);
  hit.shading_normal = unit_shading_normal(hit.shading_normal, hit.geometric_normal);
  return true;
}

bool World::occluded(const Vec3& origin, const Vec3& direction, float distance) const {
  EmbreeRay ray = to_embree(origin, direction);
  ray.tfar = distance * kShortened;
  return impl_->scene.occluded(ray);
}

BatchMask World::intersect(const BatchRay& rays, BatchMask active, Coherence coherence,
                           BatchHit& hits) const {
  EmbreePacket packet = to_embree(rays);
  std::fill_n(packet.tfar, kBatch, std::numeric_limits<float>::infinity());
  EmbreePacketHits found;
  const BatchMask met = impl_->scene.intersect(packet, active, coherence, found);
  for_each(met, [&](int i) {
    SurfaceHit hit;
    hit.position = rays.origin[i] + rays.direction[i] * found.distance[i];
    impl_->locate_hit(found[i], hit);
    hits.position.set(i, hit.position);
    hits.geometric_normal.set(i, hit.geometric_normal);
    hits.shading_normal.set(i, hit.shading_normal);
    hits.tangent.set(i, hit.tangent);
    hits.u[i] = hit.uv.x, hits.v[i] = hit.uv.y;
    hits.distance[i] = found.distance[i];
    hits.surface[i] = hit.surface;
  });
  for_whole_batch([&](int i) {
    const Vec3 geometric = normalize(hits.geometric_normal[i]);
    const Vec3 shading = unit_shading_normal(hits.shading_normal[i], geometric);
    hits.geometric_normal.set(i, geometric);
    hits.shading_normal.set(i, shading);
  });
  return met;
}

BatchMask World::occluded(const BatchRay& rays, const BatchFloat& distance,
                          BatchMask active) const {
  EmbreePacket packet = to_embree(rays);
  for (int i = 0; i < kBatch; ++i) packet.tfar[i] = distance[i] * kShortened;
  return impl_->scene.occluded(packet, active);
}

RayScene& World::rays() { return impl_->scene; }

void World::bounding_sphere(Vec3& center, float& radius) const {
  float lower[3], upper[3];
  impl_->scene.bounds(lower, upper);
  const Vec3 a = to_vec3(lower), b = to_vec3(upper);
  if (!(a.x <= b.x)) {
    center = {};
    radius = 0.0f;
    return;
  }
  center = (a + b) * 0.5f;
  radius = length(b - a) * 0.5f;
}

}  // namespace karat
