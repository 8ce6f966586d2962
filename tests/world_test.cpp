#include "render/world.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "tests/default_parameters.h"

using namespace karat;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

World world_of(Geometry geometry) {
  World world;
  world.add(std::move(geometry), {});
  world.commit();
  return world;
}

Mesh shape_mesh(const std::string& name) {
  const ShapeType* type = Registry<ShapeType>::instance().find(name);
  REQUIRE(type);
  return tessellated(type->create(default_parameters(type->parameters())));
}

// A counter-clockwise square around the origin, seen from above.
Mesh square(int face_vertices) {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.face_vertices = face_vertices;
  mesh.indices = {0, 1, 2, 3};
  if (face_vertices == 3) mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  float uniform(float from = 0.0f, float to = 1.0f) {
    return std::uniform_real_distribution<float>(from, to)(engine_);
  }
  Vec3 direction() {
    const float z = uniform(-1.0f, 1.0f), phi = uniform(0.0f, 2.0f * kPi);
    const float r = std::sqrt(1.0f - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }
  Vec3 point(float extent) {
    const float x = uniform(-extent, extent), y = uniform(-extent, extent);
    return {x, y, uniform(-extent, extent)};
  }
  // From around the scene towards a point within `extent` of its middle.
  Ray ray(float far, float extent) {
    const Vec3 origin = direction() * far;
    return {origin, normalize(point(extent) - origin)};
  }

 private:
  std::mt19937 engine_;
};

double distance(Vec3 a, Vec3 b) { return length(a - b); }

}  // namespace

TEST_CASE("geometric normals look outward from whichever side a surface is hit", "[world]") {
  struct Case {
    std::string name;
    Geometry geometry;
  };
  const std::vector<Case> flat{{"rectangle", RectangleGeometry{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}},
                               {"disk", DiskGeometry{{0, 0, 0}, {0, 0, 1}, 1.0f}},
                               {"triangles", square(3)},
                               {"quads", square(4)}};
  for (const Case& c : flat) {
    const World world = world_of(c.geometry);
    for (const Vec2 at : {Vec2{0.3f, 0.2f}, Vec2{-0.3f, 0.4f}, Vec2{-0.1f, -0.6f}}) {
      for (const float side : {1.0f, -1.0f}) {
        CAPTURE(c.name, at.x, at.y, side);
        SurfaceHit hit;
        REQUIRE(world.intersect({{at.x, at.y, 2.0f * side}, {0, 0, -side}}, hit));
        CHECK(hit.geometric_normal == Vec3{0, 0, 1});
        CHECK(hit.shading_normal == Vec3{0, 0, 1});
        CHECK(hit.distance == Approx(2.0f));
        CHECK(distance(hit.position, {at.x, at.y, 0}) < 1e-6);
        CHECK(std::abs(dot(hit.tangent, hit.geometric_normal)) < 1e-6f);
      }
    }
  }
  const World ball = world_of(SphereGeometry{{1, 2, 3}, 0.5f});
  for (const float from : {0.0f, 2.0f}) {  // from the middle, from outside
    SurfaceHit hit;
    REQUIRE(ball.intersect({{1 + from, 2, 3}, {from > 0.0f ? -1.0f : 1.0f, 0, 0}}, hit));
    CHECK(distance(hit.geometric_normal, {1, 0, 0}) < 1e-6);
  }
}

TEST_CASE("a mirrored geometry keeps its outward side", "[world]") {
  const Transform mirror = Transform::scale({-1, 1, 1});
  for (const Geometry& geometry :
       {Geometry(RectangleGeometry{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}), Geometry(square(3)),
        Geometry(square(4)), Geometry(DiskGeometry{})}) {
    World instance;
    instance.add_instances({{geometry, {}}}, {mirror});
    instance.commit();
    const World baked = world_of(transformed(geometry, mirror));
    for (const World* world : {static_cast<const World*>(&instance), &baked}) {
      SurfaceHit hit;
      REQUIRE(world->intersect({{0.3f, 0.2f, 2}, {0, 0, -1}}, hit));
      CHECK(hit.geometric_normal.z == Approx(1.0f));
    }
  }
}

TEST_CASE("instances are hit where the geometry moved by the same transform is", "[world]") {
  const Transform place =
      Transform::translate({0.4f, -0.3f, 0.2f}) * Transform::rotate({1, 2, 0.5f}, 0.9f);
  const std::vector<Transform> transforms{place, place * Transform::scale({0.7f, 0.7f, 0.7f}),
                                          place * Transform::scale({1.5f, 0.6f, 1}),
                                          place * Transform::scale({-1, 0.8f, 1.2f}),
                                          place * Transform::scale({-1, -1, -1})};
  const std::vector<Geometry> geometries{shape_mesh("torus"), square(3), square(4),
                                         RectangleGeometry{{-1, -1, 0}, {2, 0, 0}, {0.3f, 2, 0}},
                                         DiskGeometry{{0.1f, 0, 0}, {0, 0, 1}, 0.8f}};
  Random random(1);
  for (const Geometry& geometry : geometries) {
    for (const Transform& transform : transforms) {
      World instance;
      instance.add_instances({{geometry, {nullptr, nullptr, 7}}}, {transform});
      instance.commit();
      const World baked = world_of(transformed(geometry, transform));
      int both = 0, one = 0;
      double position = 0.0, normal = 0.0, shading = 0.0, uv = 0.0;
      for (int i = 0; i < 2000; ++i) {
        const Ray ray = random.ray(4.0f, 1.0f);
        SurfaceHit a, b;
        const bool hit_a = instance.intersect(ray, a), hit_b = baked.intersect(ray, b);
        one += hit_a != hit_b;
        if (!hit_a || !hit_b) continue;
        // A ray that grazes may meet the far side of one of the two.
        if (distance(a.position, b.position) > 1e-2) {
          ++one;
          continue;
        }
        ++both;
        position = std::max({position, distance(a.position, b.position),
                             distance(ray.origin + ray.direction * a.distance, a.position)});
        normal = std::max(normal, distance(a.geometric_normal, b.geometric_normal));
        shading = std::max(shading, distance(a.shading_normal, b.shading_normal));
        uv = std::max(uv, static_cast<double>(std::abs(a.uv.x - b.uv.x)));
        CHECK(a.surface->id == 7);
      }
      CAPTURE(geometry.index(), transform.determinant());
      CHECK(both > 100);
      CHECK(one <= 2);
      CHECK(position < 5e-5);
      // Rays that meet an edge may be given either face: the torus turns by 0.05 from face to face.
      CHECK(normal < (geometry.index() == 0 ? 0.06 : 1e-4));
      CHECK(shading < 1e-3);
      if (transform.determinant() > 0.0f && geometry.index() == 3) CHECK(uv < 1e-4);
    }
  }
}

TEST_CASE("an instance of a sphere is the exact ellipsoid, seen from outside and inside",
          "[world]") {
  const SphereGeometry sphere{{0.2f, 0.1f, -0.1f}, 0.8f};
  Random random(2);
  for (const Vec3 scale : {Vec3{1, 1, 1}, Vec3{2, 1, 0.5f}, Vec3{-1, 1.5f, 1}}) {
    const Transform t = Transform::translate({3, -2, 1}) * Transform::rotate({1, 1, 0}, 0.7f) *
                        Transform::scale(scale);
    World world;
    world.add_instances({{sphere, {}}}, {t});
    world.commit();
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
      Ray ray = random.ray(5.0f, 1.0f);
      if (i % 2 == 0) ray.origin = sphere.center + random.point(0.3f);
      ray = {t.point(ray.origin), normalize(t.vector(ray.direction))};
      SurfaceHit hit;
      if (!world.intersect(ray, hit)) continue;
      ++hits;
      const Vec3 local = t.inverse_point(hit.position) - sphere.center;
      CHECK(length(local) == Approx(sphere.radius).epsilon(1e-5));
      CHECK(distance(hit.position, ray.origin + ray.direction * hit.distance) < 1e-4);
      CHECK(distance(hit.geometric_normal, normalize(t.normal(local))) < 1e-4);
      CHECK(dot(hit.geometric_normal, t.vector(local)) > 0.0f);  // outward, mirrored or not
    }
    CHECK(hits > 1000);
  }
}

TEST_CASE("several groups and placements: every hit names its own surface", "[world]") {
  World world;
  world.add(SphereGeometry{{0, 0, 0}, 0.5f}, {nullptr, nullptr, 1});
  world.add_instances({{SphereGeometry{{0, 0, 0}, 0.5f}, {nullptr, nullptr, 2}},
                       {SphereGeometry{{0, 2, 0}, 0.5f}, {nullptr, nullptr, 3}}},
                      {Transform::translate({4, 0, 0}), Transform::translate({8, 0, 0})});
  world.add_instances({{SphereGeometry{{0, 0, 0}, 0.5f}, {nullptr, nullptr, 4}}},
                      {Transform::translate({12, 0, 0})});
  world.add(SphereGeometry{{16, 0, 0}, 0.5f}, {nullptr, nullptr, 5});
  world.commit();
  const std::vector<std::pair<Vec3, std::uint32_t>> expected{
      {{0, 0, 0}, 1}, {{4, 0, 0}, 2},  {{4, 2, 0}, 3}, {{8, 0, 0}, 2},
      {{8, 2, 0}, 3}, {{12, 0, 0}, 4}, {{16, 0, 0}, 5}};
  for (const auto& [center, id] : expected) {
    SurfaceHit hit;
    REQUIRE(world.intersect({center + Vec3{0, 0, 5}, {0, 0, -1}}, hit));
    CHECK(hit.surface->id == id);
    CHECK(hit.position.z == Approx(0.5f));
  }
}

TEST_CASE("interpolated normals of a torus are the torus's own", "[world]") {
  const double major = 1.0;  // defaults of the shape: tube of radius 0.25
  const World world = world_of(shape_mesh("torus"));
  Random random(3);
  double worst = 0.0, worst_geometric = 0.0;
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    SurfaceHit hit;
    if (!world.intersect(random.ray(4.0f, 1.2f), hit)) continue;
    ++hits;
    const double x = hit.position.x, y = hit.position.y, z = hit.position.z;
    const double rho = std::hypot(x, y), tube = std::hypot(rho - major, z);
    const double n[3] = {x / rho * (rho - major) / tube, y / rho * (rho - major) / tube, z / tube};
    const auto off = [&](Vec3 v) { return std::hypot(v.x - n[0], v.y - n[1], v.z - n[2]); };
    worst = std::max(worst, off(hit.shading_normal));
    worst_geometric = std::max(worst_geometric, off(hit.geometric_normal));
  }
  CHECK(hits > 5000);
  // Rows around the axis are 2 pi / 512 apart; the tube bends the other way, so that interpolation
  // leaves about half the square of that, over the ratio of the radii.
  CHECK(worst < 1e-3);
  CHECK(worst_geometric < 2.0 * 3.14159265 / 128);  // facets of the tube; it may not be zero
  CHECK(worst_geometric > 5.0 * worst);
}

TEST_CASE("rectangles and meshes tell where they were hit in u and v", "[world]") {
  const World rectangle = world_of(RectangleGeometry{{1, 2, 3}, {2, 0, 0}, {0.5f, 4, 0}});
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const float u = random.uniform(0.01f, 0.99f), v = random.uniform(0.01f, 0.99f);
    SurfaceHit hit;
    REQUIRE(rectangle.intersect({{1 + 2 * u + 0.5f * v, 2 + 4 * v, 9}, {0, 0, -1}}, hit));
    CHECK(hit.uv.x == Approx(u).margin(1e-5));
    CHECK(hit.uv.y == Approx(v).margin(1e-5));
  }
  for (const int face_vertices : {3, 4}) {
    Mesh mesh = square(face_vertices);
    mesh.uvs = {{0, 0}, {3, 0}, {3, 5}, {0, 5}};
    const World world = world_of(mesh);
    for (int i = 0; i < 200; ++i) {
      const float x = random.uniform(-0.99f, 0.99f), y = random.uniform(-0.99f, 0.99f);
      SurfaceHit hit;
      REQUIRE(world.intersect({{x, y, -9}, {0, 0, 1}}, hit));
      CHECK(hit.uv.x == Approx(1.5 * (x + 1)).margin(1e-5));
      CHECK(hit.uv.y == Approx(2.5 * (y + 1)).margin(1e-5));
      CHECK(distance(normalize(hit.tangent), {1, 0, 0}) < 1e-6);
    }
  }
}

TEST_CASE("occluded() agrees with intersect(), up to the segment's end", "[world]") {
  World world;
  world.add(shape_mesh("torus"), {});
  world.add(SphereGeometry{{0, 0, 0}, 0.4f}, {});
  world.add(RectangleGeometry{{-2, -2, -1}, {4, 0, 0}, {0, 4, 0}}, {});
  world.add_instances({{DiskGeometry{}, {}}}, {Transform::translate({0, 0, 1.5f})});
  world.commit();
  Random random(5);
  int hits = 0, wrong = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ray ray = random.ray(4.0f, 2.0f);
    SurfaceHit hit;
    const bool found = world.intersect(ray, hit);
    wrong += found != world.occluded(ray.origin, ray.direction, kInfinity);
    if (!found) continue;
    ++hits;
    wrong += world.occluded(ray.origin, ray.direction, hit.distance);  // its own target
    wrong += world.occluded(ray.origin, ray.direction, 0.99f * hit.distance);
    wrong += !world.occluded(ray.origin, ray.direction, 1.01f * hit.distance);
  }
  CHECK(hits > 5000);
  CHECK(wrong == 0);
}

TEST_CASE("a batch of rays meets what its rays meet one by one", "[world]") {
  World world;
  world.add(shape_mesh("torus"), {nullptr, nullptr, 1});
  world.add(SphereGeometry{{0, 0, 1}, 0.4f}, {nullptr, nullptr, 2});
  world.add(DiskGeometry{{1, 1, 0}, {0, 0, 1}, 0.7f}, {nullptr, nullptr, 3});
  world.add(RectangleGeometry{{-2, -2, -1}, {4, 0, 0}, {0, 4, 0}}, {nullptr, nullptr, 4});
  world.add_instances({{shape_mesh("ring"), {nullptr, nullptr, 5}}},
                      {Transform::translate({0, 1.5f, 0.5f})});
  world.commit();
  Random random(11);
  constexpr int kBatches = 4000;
  int tried = 0, met_twice = 0, different = 0, hidden_differently = 0;
  double farthest = 0.0, steepest = 0.0;
  for (int n = 0; n < kBatches; ++n) {
    BatchRay rays;
    BatchFloat distance;
    for (int i = 0; i < kBatch; ++i) {
      const Ray ray = random.ray(6.0f, 2.0f);
      rays.origin.set(i, ray.origin);
      rays.direction.set(i, ray.direction);
      distance[i] = random.uniform(1.0f, 12.0f);
    }
    // From one ray to all of them, so that both ways to trace a packet are taken.
    const BatchMask active = n % 4 == 0 ? kWholeBatch : 0x9248u >> (n % 13);
    BatchHit hits;
    const Coherence coherence = n % 2 == 0 ? Coherence::kCamera : Coherence::kNone;
    const BatchMask met = world.intersect(rays, active, coherence, hits);
    const BatchMask hidden = world.occluded(rays, distance, active);
    CHECK((met & ~active) == 0);
    CHECK((hidden & ~active) == 0);
    for_each(active, [&](int i) {
      ++tried;
      const Ray ray{rays.origin[i], rays.direction[i]};
      SurfaceHit one;
      const bool met_alone = world.intersect(ray, one);
      const bool hidden_alone = world.occluded(ray.origin, ray.direction, distance[i]);
      hidden_differently += hidden_alone != (((hidden >> i) & 1u) != 0);
      const bool same =
          met_alone == (((met >> i) & 1u) != 0) && (!met_alone || one.surface == hits.surface[i]);
      different += !same;
      if (!same || !met_alone) return;
      ++met_twice;
      farthest = std::max(farthest, ::distance(one.position, hits.position[i]));
      steepest = std::max(steepest, ::distance(one.geometric_normal, hits.geometric_normal[i]));
      CHECK(length(hits.shading_normal[i]) == Approx(1.0f));
      CHECK(dot(hits.shading_normal[i], hits.geometric_normal[i]) > 0.0f);
    });
  }
  CHECK(met_twice > tried / 4);
  // Rays through an edge may fall to either side of it.
  CHECK(different <= tried / 10000);
  CHECK(hidden_differently <= tried / 10000);
  CHECK(farthest < 1e-4);
  INFO("largest difference between unit normals " << steepest);
  CHECK(steepest < 0.2);  // neighbouring faces of the torus
}

TEST_CASE("a sphere bounds the world; nothing is in an empty one", "[world]") {
  World empty;
  empty.commit();
  SurfaceHit hit;
  CHECK_FALSE(empty.intersect({{0, 0, 0}, {0, 0, 1}}, hit));
  CHECK_FALSE(empty.occluded({0, 0, 0}, {0, 0, 1}, kInfinity));
  Vec3 center{9, 9, 9};
  float radius = 9.0f;
  empty.bounding_sphere(center, radius);
  CHECK(radius == 0.0f);
  CHECK(center == Vec3{0, 0, 0});

  World world;
  world.add(SphereGeometry{{1, 0, 0}, 1.0f}, {});
  world.add_instances({{DiskGeometry{{0, 0, 0}, {0, 0, 1}, 2.0f}, {}}},
                      {Transform::translate({-5, 1, 3})});
  world.commit();
  world.bounding_sphere(center, radius);
  for (const Vec3 p : {Vec3{2, 0, 0}, Vec3{1, -1, 0}, Vec3{-7, 1, 3}, Vec3{-5, 3, 3}}) {
    CHECK(distance(center, p) <= radius * 1.00001);
  }
  CHECK(radius < 8.0f);  // the box is [-7, 2] x [-1, 3] x [-1, 3]: half its diagonal is 5.3
}

namespace {

// Directions all around the normal, of which every second one grazes.
Vec3 leaving(Random& random, Vec3 n, int i) {
  const Vec3 d = random.direction();
  if (i % 2 == 0) return d;
  const Vec3 tangent = d - n * dot(d, n);
  const float angle = std::pow(10.0f, random.uniform(-6.0f, -1.0f));
  return normalize(normalize(tangent) + n * ((i & 2) != 0 ? angle : -angle));
}

// Rays that leave a convex surface outward, or a flat one anywhere, and meet it again.
int self_intersections(const Geometry& geometry, Vec3 center, float size, bool flat) {
  const World world = world_of(geometry);
  Random random(6);
  int found = 0, wrong = 0;
  for (int i = 0; i < 20000; ++i) {
    Ray ray = random.ray(size * std::pow(10.0f, random.uniform(0.5f, 2.0f)), 0.7f * size);
    ray.origin += center;
    SurfaceHit hit;
    if (!world.intersect(ray, hit)) continue;
    ++found;
    const Vec3 d = leaving(random, hit.geometric_normal, i);
    if (!flat && dot(d, hit.geometric_normal) <= 0.0f) continue;
    const Vec3 origin = offset_origin(hit.position, hit.geometric_normal, d);
    SurfaceHit again;
    wrong += world.intersect({origin, d}, again) || world.occluded(origin, d, kInfinity);
  }
  CHECK(found > 2000);
  return wrong;
}

}  // namespace

TEST_CASE("rays that leave a surface do not meet it again, at any scale and place", "[world]") {
  for (const float size : {1e-3f, 0.03f, 1.0f, 30.0f, 1e4f}) {
    for (const float away : {0.0f, 0.3f, 3.0f, 100.0f}) {
      const Vec3 center = Vec3{0.6f, -0.3f, 0.8f} * (away * size);
      const Transform place = Transform::translate(center) * Transform::rotate({1, 2, 3}, 1.1f) *
                              Transform::scale({size, size, size});
      CAPTURE(size, away);
      CHECK(self_intersections(SphereGeometry{center, size}, center, size, false) == 0);
      // A hit's position is rounded in proportion to the geometry's extent, its offset grows with
      // its own coordinates: where large tilted planes pass the origin, a few fall short.
      const int allowed = size > 10.0f && away == 0.0f ? 10 : 0;
      for (const Geometry& geometry :
           {Geometry(RectangleGeometry{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}),
            Geometry(DiskGeometry{}), Geometry(square(3)), Geometry(square(4))}) {
        CAPTURE(geometry.index());
        CHECK(self_intersections(transformed(geometry, place), center, size, true) <= allowed);
      }
      CHECK(self_intersections(transformed(tessellated(SphereGeometry{}), place), center, size,
                               false) == 0);
    }
  }
}

// A brushed face turns with its shape: uv and tangent stay where they are on it.
TEST_CASE("a transform turns the tangents of spheres and disks", "[world]") {
  Random random(5);
  for (const Geometry& geometry : {Geometry(SphereGeometry{{0, 0, 0}, 2.0f}),
                                   Geometry(DiskGeometry{{0, 0, 0}, {0, 0, 1}, 2.0f})}) {
    for (int i = 0; i < 50; ++i) {
      const Transform turn = Transform::translate({3, -1, 2}) *
                             Transform::rotate(random.direction(), random.uniform(0.1f, 6.0f));
      const World at_rest = world_of(geometry), turned = world_of(transformed(geometry, turn));
      const Vec3 origin{random.uniform(-1, 1), random.uniform(-1, 1), 9.0f};
      SurfaceHit before, after;
      REQUIRE(at_rest.intersect({origin, {0, 0, -1}}, before));
      REQUIRE(turned.intersect({turn.point(origin), turn.vector({0, 0, -1})}, after));
      CAPTURE(i, geometry.index());
      CHECK(distance(normalize(after.tangent), normalize(turn.vector(before.tangent))) < 1e-4);
      CHECK(after.uv.x == Approx(before.uv.x).margin(1e-4));
      CHECK(after.uv.y == Approx(before.uv.y).margin(1e-4));
    }
  }
}
