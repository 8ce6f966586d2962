#include "render/shape.h"

#include <catch2/catch.hpp>
#include <map>
#include <tuple>

#include "default_parameters.h"
#include "spectral/support/error.h"

using namespace karat;

namespace {

constexpr double kPiD = 3.14159265358979323846;

Geometry make(const std::string& type, const std::map<std::string, ParameterValue>& values = {}) {
  const ShapeType* shape = Registry<ShapeType>::instance().find(type);
  REQUIRE(shape);
  Parameters parameters = default_parameters(shape->parameters());
  for (const auto& [name, value] : values) parameters.set(name, value);
  return shape->create(parameters);
}

using Key = std::tuple<float, float, float>;
Key key(Vec3 p) { return {p.x, p.y, p.z}; }

// How many times each directed edge occurs, by position; edges without a length do not count.
std::map<std::pair<Key, Key>, int> directed_edges(const Mesh& mesh) {
  std::map<std::pair<Key, Key>, int> edges;
  const auto step = static_cast<std::size_t>(mesh.face_vertices);
  for (std::size_t f = 0; f < mesh.indices.size(); f += step) {
    for (std::size_t i = 0; i < step; ++i) {
      const Vec3 a = mesh.positions[mesh.indices[f + i]];
      const Vec3 b = mesh.positions[mesh.indices[f + (i + 1) % step]];
      if (!(a == b)) ++edges[{key(a), key(b)}];
    }
  }
  return edges;
}

// Every edge lies between exactly two faces, which run along it in opposite ways.
void check_watertight(const Mesh& mesh) {
  const auto edges = directed_edges(mesh);
  REQUIRE(!edges.empty());
  int wrong = 0;
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    wrong += count != 1 || back == edges.end() || back->second != 1;
  }
  CHECK(wrong == 0);
}

// Divergence theorem; positive where faces look outward.
double signed_volume(const Mesh& mesh) {
  double six_volumes = 0.0;
  const auto corner = [&](std::size_t i) { return mesh.positions[mesh.indices[i]]; };
  const auto add = [&](Vec3 a, Vec3 b, Vec3 c) {
    six_volumes += double{a.x} * (double{b.y} * c.z - double{b.z} * c.y) +
                   double{a.y} * (double{b.z} * c.x - double{b.x} * c.z) +
                   double{a.z} * (double{b.x} * c.y - double{b.y} * c.x);
  };
  const auto step = static_cast<std::size_t>(mesh.face_vertices);
  for (std::size_t i = 0; i < mesh.indices.size(); i += step) {
    add(corner(i), corner(i + 1), corner(i + step - 1));
    if (step == 4) add(corner(i + 2), corner(i + 3), corner(i + 1));
  }
  return six_volumes / 6.0;
}

// The largest angle between a face's own normal and its corners' normals, in radians.
double largest_normal_deviation(const Mesh& mesh) {
  double smallest_cosine = 1.0;
  const auto step = static_cast<std::size_t>(mesh.face_vertices);
  for (std::size_t f = 0; f < mesh.indices.size(); f += step) {
    const auto p = [&](std::size_t i) { return mesh.positions[mesh.indices[f + i]]; };
    const Vec3 n = step == 4 ? cross(p(2) - p(0), p(3) - p(1)) : cross(p(1) - p(0), p(2) - p(0));
    for (std::size_t i = 0; i < step; ++i) {
      const Vec3 vertex_normal = mesh.normals[mesh.indices[f + i]];
      CHECK(length(vertex_normal) == Approx(1.0).margin(1e-6));
      smallest_cosine = std::min(smallest_cosine, double{dot(normalize(n), vertex_normal)});
    }
  }
  return std::acos(std::min(smallest_cosine, 1.0));
}

// How much a regular n-gon falls short of its circle: area, and perimeter.
double polygon_area(int n) { return n / (2 * kPiD) * std::sin(2 * kPiD / n); }
double polygon_perimeter(int n) { return n / kPiD * std::sin(kPiD / n); }

}  // namespace

TEST_CASE("a torus has the volume and area of its polygons", "[shape]") {
  const int nu = 96, nv = 40;
  const double major = 2.0, minor = 0.5;
  const Geometry torus = make("torus", {{"major_radius", major},
                                        {"minor_radius", minor},
                                        {"segments_u", double{nu}},
                                        {"segments_v", double{nv}}});
  const Mesh& mesh = std::get<Mesh>(torus);
  check_watertight(mesh);
  // A regular nv-gon of centroid distance R turned in nu straight steps: exactly a Pappus volume
  // with both circles replaced by their polygons.
  const double volume =
      2 * kPiD * kPiD * major * minor * minor * polygon_area(nu) * polygon_area(nv);
  CHECK(signed_volume(mesh) == Approx(volume).epsilon(1e-5));
  CHECK(volume == Approx(2 * kPiD * kPiD * major * minor * minor).epsilon(6e-3));
  // The flat facets around the axis lie a little deeper than the circle, so the area is between the
  // product of perimeters and that of the circles.
  const double area = 4 * kPiD * kPiD * major * minor;
  CHECK(surface_area(torus) < area);
  CHECK(surface_area(torus) > area * polygon_perimeter(nu) * polygon_perimeter(nv) * 0.9995);
  // A corner's exact normal is half a step away from its facets in both directions.
  CHECK(largest_normal_deviation(mesh) < std::hypot(kPiD / nu, kPiD / nv) * 1.02);
}

TEST_CASE("a torus converges to its closed form with the square of the step", "[shape]") {
  const auto errors = [](int n) {
    const Geometry torus = make("torus", {{"major_radius", 1.0},
                                          {"minor_radius", 0.25},
                                          {"segments_u", static_cast<double>(n)},
                                          {"segments_v", static_cast<double>(n)}});
    return std::pair{2 * kPiD * kPiD / 16 - signed_volume(std::get<Mesh>(torus)),
                     kPiD * kPiD - surface_area(torus)};
  };
  const auto [coarse_volume, coarse_area] = errors(32);
  const auto [fine_volume, fine_area] = errors(64);
  CHECK(coarse_volume / fine_volume == Approx(4.0).epsilon(0.02));
  CHECK(coarse_area / fine_area == Approx(4.0).epsilon(0.02));
}

TEST_CASE("rings are watertight, look outward and keep their measures", "[shape]") {
  const std::string profile = GENERATE("flat", "court", "d-shape");
  const double inner = 8.0, width = 4.0, thickness = 1.8;
  INFO(profile);
  const Geometry ring = make(
      "ring",
      {{"inner_radius", inner}, {"width", width}, {"thickness", thickness}, {"profile", profile}});
  const Mesh& mesh = std::get<Mesh>(ring);
  check_watertight(mesh);

  double least_rho = 1e9, most_rho = 0.0, least_z = 1e9, most_z = -1e9;
  for (const Vec3 p : mesh.positions) {
    const double rho = std::hypot(double{p.x}, double{p.y});
    least_rho = std::min(least_rho, rho), most_rho = std::max(most_rho, rho);
    least_z = std::min(least_z, double{p.z}), most_z = std::max(most_z, double{p.z});
  }
  CHECK(least_rho == Approx(inner).epsilon(1e-6));
  CHECK(most_rho == Approx(inner + thickness).epsilon(1e-6));
  CHECK(least_z == Approx(-width / 2).epsilon(1e-6));
  CHECK(most_z == Approx(width / 2).epsilon(1e-6));

  // No more than the rectangular section's volume, no less than half of it.
  const double box = kPiD * ((inner + thickness) * (inner + thickness) - inner * inner) * width;
  CHECK(signed_volume(mesh) < box);
  CHECK(signed_volume(mesh) > 0.5 * box);

  // Half a step along the section (96 for the full turn, doubled at worst where a part gets a whole
  // number of them) and around the axis: no kink anywhere.
  CHECK(largest_normal_deviation(mesh) < 1.1 * std::hypot(kPiD / 96, kPiD / 512));
}

TEST_CASE("a flat ring has its closed-form volume", "[shape]") {
  const double inner = 8.0, width = 4.0, thickness = 2.0, edge = 0.5;
  const Geometry ring = make("ring", {{"inner_radius", inner},
                                      {"width", width},
                                      {"thickness", thickness},
                                      {"profile", std::string("flat")},
                                      {"edge_radius", edge}});
  // Pappus: the section is symmetric about its middle radius.
  const double section = width * thickness - (4.0 - kPiD) * edge * edge;
  const double volume = 2 * kPiD * (inner + thickness / 2) * section;
  CHECK(signed_volume(std::get<Mesh>(ring)) == Approx(volume).epsilon(1e-4));
}

TEST_CASE("rings that cannot be are refused", "[shape]") {
  CHECK_THROWS_WITH(make("ring", {{"edge_radius", 0.2}}), Catch::Contains("edge_radius"));
  CHECK_THROWS_WITH(make("torus", {{"minor_radius", 1.5}}), Catch::Contains("minor_radius"));
  CHECK_THROWS_AS(make("ring", {{"edge_radius", 0.2}}), InputError);
  // So narrow that the dome is a half circle.
  const Geometry wire = make("ring", {{"width", 0.1}, {"profile", std::string("d-shape")}});
  check_watertight(std::get<Mesh>(wire));
}

TEST_CASE("exact geometries and their meshes have equal areas", "[shape]") {
  for (const std::string type : {"sphere", "disk"}) {
    const Geometry geometry = make(type, {{"radius", 2.0}});
    const double exact = type == "sphere" ? 16 * kPiD : 4 * kPiD;
    CHECK(surface_area(geometry) == Approx(exact).epsilon(1e-7));
    CHECK(surface_area(tessellated(geometry)) == Approx(exact).epsilon(1e-4));
  }
  const Geometry rectangle = make("rectangle", {{"width", 2.0}, {"height", 3.0}});
  CHECK(surface_area(rectangle) == Approx(6.0));
  CHECK(surface_area(tessellated(rectangle)) == Approx(6.0));
  const Mesh sphere = tessellated(make("sphere"));
  check_watertight(sphere);
  CHECK(signed_volume(sphere) == Approx(4 * kPiD / 3).epsilon(1e-4));
}

TEST_CASE("transforms keep what they can", "[shape]") {
  const Transform turn = Transform::translate({1, 2, 3}) * Transform::rotate({1, 1, 0}, 0.7f) *
                         Transform::scale({2, 2, 2});
  const Transform squash = Transform::scale({1, 1, 0.5f});
  const Transform mirror = Transform::scale({1, 1, -1});

  const auto sphere = std::get<SphereGeometry>(transformed(make("sphere"), turn));
  CHECK(sphere.radius == Approx(2.0f));
  CHECK(length(sphere.center - Vec3{1, 2, 3}) < 1e-6f);
  CHECK(std::holds_alternative<Mesh>(transformed(make("sphere"), squash)));
  CHECK(signed_volume(tessellated(transformed(make("sphere"), squash))) ==
        Approx(2 * kPiD / 3).epsilon(1e-4));

  // Squashing along its normal leaves a disk a disk; along its plane it does not.
  CHECK(std::holds_alternative<DiskGeometry>(transformed(make("disk"), squash)));
  const Geometry ellipse = transformed(make("disk"), Transform::scale({2, 1, 1}));
  CHECK(std::holds_alternative<Mesh>(ellipse));
  CHECK(surface_area(ellipse) == Approx(2 * kPiD).epsilon(1e-4));

  // Outward sides stay outward in a mirror.
  const auto rectangle = std::get<RectangleGeometry>(transformed(make("rectangle"), mirror));
  CHECK(cross(rectangle.edge_u, rectangle.edge_v).z == Approx(-1.0f));
  const auto disk = std::get<DiskGeometry>(transformed(make("disk"), mirror));
  CHECK(disk.normal.z == Approx(-1.0f));
  const Geometry torus = transformed(make("torus"), mirror);
  CHECK(signed_volume(std::get<Mesh>(torus)) > 0.0);
  check_watertight(std::get<Mesh>(torus));
  CHECK(largest_normal_deviation(std::get<Mesh>(torus)) < 0.05);

  CHECK_THROWS_AS(transformed(make("sphere"), Transform::scale({1, 1, 0})), InputError);
}
