#include "render/ray_scene.h"

#include <catch2/catch.hpp>
#include <vector>

using namespace karat;

namespace {

const float kSquare[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const std::uint32_t kQuad[] = {0, 1, 2, 3};
const std::uint32_t kTriangles[] = {0, 1, 2, 0, 2, 3};

EmbreeRay down(float x, float y, float from = 2.0f) { return {{x, y, from}, {0, 0, -1}}; }

}  // namespace

TEST_CASE("geometries are numbered from 0 and hits name them and their faces", "[ray_scene]") {
  RayScene scene;
  CHECK(scene.add_triangles(kSquare, 4, kTriangles, 2) == 0);
  const float center[] = {5, 0, 0}, normal[] = {0, 0, 1};
  CHECK(scene.add_sphere(center, 1.0f) == 1);
  const float aside[] = {-5, 0, 0};
  CHECK(scene.add_disk(aside, normal, 1.0f) == 2);
  CHECK(scene.add_quads(kSquare, 4, kQuad, 1) == 3);
  scene.commit();

  EmbreeHit hit;
  REQUIRE(scene.intersect(down(5.0f, 0.5f), hit));
  CHECK(hit.geometry == 1);
  CHECK(hit.instance == kNoInstance);
  REQUIRE(scene.intersect(down(-5.5f, 0.0f), hit));
  CHECK(hit.geometry == 2);
  CHECK(hit.distance == Approx(2.0f));
  CHECK(hit.normal[2] > 0.0f);
  CHECK_FALSE(scene.intersect(down(-6.5f, 0.0f), hit));
  REQUIRE(scene.intersect(down(0.25f, 0.75f), hit));
  CHECK((hit.geometry == 0 || hit.geometry == 3));  // they coincide
  if (hit.geometry == 0) CHECK(hit.primitive == 1);
}

TEST_CASE("quads report u and v along their edges, beyond the diagonal too", "[ray_scene]") {
  RayScene scene;
  scene.add_quads(kSquare, 4, kQuad, 1);
  scene.commit();
  for (const float x : {0.125f, 0.5f, 0.875f}) {
    for (const float y : {0.25f, 0.75f}) {
      EmbreeHit hit;
      REQUIRE(scene.intersect(down(x, y), hit));
      CHECK(hit.u == Approx(x));
      CHECK(hit.v == Approx(y));
      CHECK(hit.normal[2] > 0.0f);  // counter-clockwise from above
    }
  }
}

TEST_CASE("a ray meets what lies between its ends only", "[ray_scene]") {
  RayScene scene;
  scene.add_quads(kSquare, 4, kQuad, 1);
  scene.commit();
  EmbreeRay ray = down(0.5f, 0.5f);
  CHECK(scene.occluded(ray));
  ray.tfar = 1.9f;
  CHECK_FALSE(scene.occluded(ray));
  ray = down(0.5f, 0.5f);
  ray.tnear = 2.1f;
  EmbreeHit hit;
  CHECK_FALSE(scene.intersect(ray, hit));
  CHECK_FALSE(scene.occluded(ray));
}

TEST_CASE("instances: distances in the world, normals in the instance's own coordinates",
          "[ray_scene]") {
  RayScene part;
  part.add_quads(kSquare, 4, kQuad, 1);
  part.commit();
  RayScene scene;
  scene.add_quads(kSquare, 4, kQuad, 1);
  // x to y, y to z, z to x, twice as large, moved by (3, 0, 0): the square stands at x = 3.
  const float transform[12] = {0, 2, 0, 0, 0, 2, 2, 0, 0, 3, 0, 0};
  CHECK(scene.add_instance(part, transform) == 1);
  scene.commit();
  EmbreeHit hit;
  REQUIRE(scene.intersect({{10, 0.5f, 1.5f}, {-1, 0, 0}}, hit));
  CHECK(hit.instance == 1);
  CHECK(hit.geometry == 0);
  CHECK(hit.distance == Approx(7.0f));
  CHECK(hit.u == Approx(0.25f));
  CHECK(hit.v == Approx(0.75f));
  CHECK(hit.normal[2] > 0.0f);
  CHECK(hit.normal[0] == Approx(0.0f).margin(1e-6));
  float lower[3], upper[3];
  scene.bounds(lower, upper);
  CHECK(lower[0] <= 0.0f);
  CHECK((upper[0] >= 3.0f && upper[0] < 3.01f));
  CHECK((upper[1] >= 2.0f && upper[1] < 2.01f));
}

TEST_CASE("rays are recorded while somebody listens", "[ray_scene]") {
  RayScene scene;
  scene.add_quads(kSquare, 4, kQuad, 1);
  scene.commit();
  std::vector<RecordedRay> rays;
  EmbreeHit hit;
  scene.record_to(&rays);
  scene.intersect(down(0.5f, 0.5f), hit);
  scene.occluded(down(0.25f, 0.5f));
  scene.record_to(nullptr);
  scene.intersect(down(0.5f, 0.5f), hit);
  REQUIRE(rays.size() == 2);
  CHECK_FALSE(rays[0].occlusion);
  CHECK(rays[1].occlusion);
  CHECK(rays[1].ray.origin[0] == 0.25f);
}
