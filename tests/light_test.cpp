#include "render/light.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>

#include "default_parameters.h"

using namespace karat;

namespace {

constexpr double kPiD = 3.14159265358979323846;

struct Named {
  std::string name;
  Geometry geometry;
};

// The rectangle [-1, 1] x [-0.5, 0.5] at z = 0 that looks down -z, and other geometries there.
const RectangleGeometry kRectangle{{-1, 0.5f, 0}, {2, 0, 0}, {0, -1, 0}};

std::vector<Named> all_geometries() {
  const RectangleGeometry skew{{-1, 0.5f, 0}, {2, 0.3f, 0}, {0, -1, 0.2f}};
  return {{"rectangle", kRectangle},
          {"parallelogram", skew},
          {"sphere", SphereGeometry{{0.2f, -0.1f, 1}, 0.8f}},
          {"disk", DiskGeometry{{0.1f, 0, 0.2f}, normalize({0.2f, 0.1f, -1}), 0.7f}},
          {"mesh", tessellated(kRectangle)}};
}

std::unique_ptr<const Light> area_light(const Geometry& geometry, bool two_sided = false) {
  return make_area_light(geometry, LatticeSpectrum(2.0f), two_sided);
}

// Where the ray meets the geometry first, by the analytic intersection of the convex shapes here.
bool intersect(const Geometry& geometry, const Vec3& point, const Vec3& wi, SurfaceHit& hit) {
  const auto plane = [&](Vec3 origin, Vec3 normal) {
    const float t = dot(origin - point, normal) / dot(wi, normal);
    hit.position = point + wi * t;
    hit.geometric_normal = normal;
    hit.distance = t;
    return std::isfinite(t) && t > 0.0f;
  };
  if (const auto* s = std::get_if<SphereGeometry>(&geometry)) {
    const Vec3 d = s->center - point;
    const double b = dot(d, wi), c = double{length_squared(d)} - double{s->radius} * s->radius;
    const double root = b * b - c;
    if (root < 0.0) return false;
    const double t = c > 0.0 ? b - std::sqrt(root) : b + std::sqrt(root);
    hit.distance = static_cast<float>(t);
    hit.position = point + wi * hit.distance;
    hit.geometric_normal = normalize(hit.position - s->center);
    return t > 0.0;
  }
  if (const auto* d = std::get_if<DiskGeometry>(&geometry)) {
    return plane(d->center, d->normal) && length(hit.position - d->center) <= d->radius;
  }
  RectangleGeometry r = kRectangle;
  if (const auto* given = std::get_if<RectangleGeometry>(&geometry)) r = *given;
  const Vec3 n = cross(r.edge_u, r.edge_v);
  if (!plane(r.origin, normalize(n))) return false;
  const Vec3 p = hit.position - r.origin;
  const float u = dot(cross(p, r.edge_v), n) / dot(n, n),
              v = dot(cross(r.edge_u, p), n) / dot(n, n);
  return u >= 0.0f && u <= 1.0f && v >= 0.0f && v <= 1.0f;
}

// Independent uniform numbers with a fixed seed.
class Numbers {
 public:
  Vec2 next() {
    const float x = uniform_(engine_);
    return {std::min(x, 0.99999994f), std::min(uniform_(engine_), 0.99999994f)};
  }

 private:
  std::mt19937 engine_{7};
  std::uniform_real_distribution<float> uniform_{0.0f, 1.0f};
};

struct Estimate {
  double mean, standard_error;
};

// Irradiance on a surface at `point` with normal `n`, lane 0.
Estimate irradiance(const Light& light, Vec3 point, Vec3 n, int samples = 40000) {
  Numbers numbers;
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < samples; ++i) {
    const auto s = light.sample(point, numbers.next(), 0);
    const double value =
        s ? double{s->radiance[0]} * std::max(0.0f, dot(s->wi, n)) / double{s->pdf} : 0.0;
    sum += value, squares += value * value;
  }
  const double mean = sum / samples;
  return {mean, std::sqrt(std::max(0.0, squares / samples - mean * mean) / samples)};
}

// Within four standard errors (one in 16,000 fails by chance), or float noise where all samples
// agree.
void check_irradiance(const Light& light, Vec3 point, Vec3 n, double expected) {
  const Estimate e = irradiance(light, point, n);
  CHECK(std::abs(e.mean - expected) < 4.0 * e.standard_error + 2e-5 * expected);
}

// Configuration factor from a small surface to a parallel rectangle a x b at height c, the point
// below one corner (Howell, catalogue of configuration factors, B-3).
double corner_factor(double a, double b, double c) {
  const double x = a / c, y = b / c, sx = std::sqrt(1 + x * x), sy = std::sqrt(1 + y * y);
  return (x / sx * std::atan(y / sx) + y / sy * std::atan(x / sy)) / (2 * kPiD);
}
double signed_corner(double a, double b, double c) {
  return std::copysign(1.0, a) * std::copysign(1.0, b) * corner_factor(std::abs(a), std::abs(b), c);
}
// The factor of kRectangle from (x, y, -c), looking up.
double rectangle_factor(double x, double y, double c) {
  return signed_corner(1 - x, 0.5 - y, c) - signed_corner(-1 - x, 0.5 - y, c) -
         signed_corner(1 - x, -0.5 - y, c) + signed_corner(-1 - x, -0.5 - y, c);
}

// Chi-square of sampled directions against the density, on nz x na cells of (cos theta, phi) around
// the direction to the light's middle; the density is integrated on a finer grid.
template <typename Density>
double chi_square_z(const Light& light, Vec3 point, Vec3 axis, double least_cosine,
                    Density&& density) {
  const int nz = 12, na = 16, fine = 24, samples = 60000;
  const Frame frame = Frame::around(axis);
  std::vector<double> expected(nz * na), counted(nz * na);
  double integral = 0.0;
  for (int i = 0; i < nz * fine; ++i) {
    for (int j = 0; j < na * fine; ++j) {
      const double z = least_cosine + (1.0 - least_cosine) * (i + 0.5) / (nz * fine);
      const double phi = 2 * kPiD * (j + 0.5) / (na * fine), r = std::sqrt(1 - z * z);
      const Vec3 wi =
          frame.to_world({static_cast<float>(r * std::cos(phi)),
                          static_cast<float>(r * std::sin(phi)), static_cast<float>(z)});
      const double cell = (1.0 - least_cosine) * 2 * kPiD / (nz * fine) / (na * fine);
      const double mass = density(wi) * cell;
      integral += mass;
      expected[static_cast<std::size_t>(i / fine * na + j / fine)] += mass * samples;
    }
  }
  CHECK(integral == Approx(1.0).margin(0.01));
  Numbers numbers;
  for (int k = 0; k < samples; ++k) {
    const auto s = light.sample(point, numbers.next(), 0);
    if (!s) continue;
    const Vec3 local = frame.to_local(s->wi);
    const double z = (local.z - least_cosine) / (1.0 - least_cosine);
    const double phi = std::atan2(local.y, local.x) / (2 * kPiD);
    const int i = std::clamp(static_cast<int>(z * nz), 0, nz - 1);
    const int j = std::clamp(static_cast<int>((phi < 0 ? phi + 1 : phi) * na), 0, na - 1);
    ++counted[static_cast<std::size_t>(i * na + j)];
  }
  // Cells that the quadrature resolves badly (the light's border) are pooled with their ring.
  double chi2 = 0.0, pooled_expected = 0.0, pooled_counted = 0.0;
  int cells = -1;
  const auto flush = [&] {
    if (pooled_expected < 25.0) return;
    const double d = pooled_counted - pooled_expected;
    chi2 += d * d / pooled_expected;
    ++cells;
    pooled_expected = pooled_counted = 0.0;
  };
  for (std::size_t k = 0; k < expected.size(); ++k) {
    pooled_expected += expected[k], pooled_counted += counted[k];
    flush();
  }
  REQUIRE(cells > 5);
  // Wilson and Hilferty 1931: a standard normal variable.
  const double n = cells;
  return (std::cbrt(chi2 / n) - (1.0 - 2.0 / (9.0 * n))) / std::sqrt(2.0 / (9.0 * n));
}

std::unique_ptr<const Light> make_light(const std::string& name,
                                        const std::map<std::string, ParameterValue>& values,
                                        const Transform& transform = {}) {
  const LightType* type = Registry<LightType>::instance().find(name);
  REQUIRE(type);
  Parameters parameters = default_parameters(type->parameters());
  for (const auto& [key, value] : values) parameters.set(key, value);
  std::vector<std::string> warnings;
  return type->create(parameters, {WavelengthLattice(), transform, &warnings});
}

}  // namespace

TEST_CASE("samples of area lights hit them, with the density that pdf() states", "[light]") {
  for (const Named& named : all_geometries()) {
    for (const bool two_sided : {false, true}) {
      for (const Vec3 point : {Vec3{0.3f, 0.1f, -1}, Vec3{3, -2, -0.5f}, Vec3{0.5f, 30, -20},
                               Vec3{0.7f, 0.2f, -0.05f}, Vec3{1, 2, 3}}) {
        INFO(named.name << " from " << point.x << " " << point.y << " " << point.z);
        const auto light = area_light(named.geometry, two_sided);
        Numbers numbers;
        int missed = 0, inconsistent = 0, samples = 0;
        for (int i = 0; i < 2000; ++i) {
          const auto s = light->sample(point, numbers.next(), 3);
          if (!s) continue;
          ++samples;
          SurfaceHit hit{};
          // Samples at the very border may miss by a rounding.
          if (!intersect(named.geometry, point, s->wi, hit)) {
            ++missed;
            continue;
          }
          CHECK(length(s->wi) == Approx(1.0f).epsilon(1e-5));
          inconsistent += std::abs(hit.distance / s->distance - 1.0f) > 2e-3f;
          // Where the sphere is met edge-on its distance is uncertain, its density is not.
          inconsistent += std::abs(light->pdf(point, s->wi, &hit) / s->pdf - 1.0f) > 2e-3f;
          inconsistent += !(light->radiance(s->wi, &hit, 3)[5] == s->radiance[5]);
        }
        CHECK(missed <= samples / 200);
        CHECK(inconsistent <= samples / 100);
      }
    }
  }
}

TEST_CASE("one-sided lights are dark from behind, two-sided ones are not", "[light]") {
  for (const Named& named : all_geometries()) {
    INFO(named.name);
    const Vec3 behind = named.name == "sphere" ? Vec3{0.2f, -0.1f, 0.9f} : Vec3{0.1f, 0.1f, 2};
    const auto one = area_light(named.geometry), both = area_light(named.geometry, true);
    CHECK_FALSE(one->sample(behind, {0.3f, 0.6f}, 0));
    const auto s = both->sample(behind, {0.3f, 0.6f}, 0);
    REQUIRE(s);
    SurfaceHit hit{};
    REQUIRE(intersect(named.geometry, behind, s->wi, hit));
    CHECK(one->pdf(behind, s->wi, &hit) == 0.0f);
    CHECK(is_black(one->radiance(s->wi, &hit, 0)));
    CHECK(both->radiance(s->wi, &hit, 0)[0] == 2.0f);
    CHECK(both->pdf(behind, s->wi, &hit) == Approx(s->pdf).epsilon(1e-3));
    CHECK(both->power(1) == Approx(2 * one->power(1)));
  }
}

TEST_CASE("area light samples follow their density", "[light]") {
  for (const Named& named : all_geometries()) {
    for (const Vec3 point : {Vec3{0.3f, 0.1f, -1}, Vec3{2, 1, -0.7f}}) {
      INFO(named.name << " from " << point.x);
      const auto light = area_light(named.geometry);
      const auto bounds = light->bounds();
      const Vec3 axis = normalize(bounds.center - point);
      const double ratio = std::min(1.0, double{bounds.radius} / length(bounds.center - point));
      const double least_cosine = ratio < 1.0 ? std::sqrt(1 - ratio * ratio) - 0.01 : -1.0;
      const double z = chi_square_z(*light, point, axis, least_cosine, [&](Vec3 wi) {
        SurfaceHit hit{};
        return intersect(named.geometry, point, wi, hit) ? double{light->pdf(point, wi, &hit)}
                                                         : 0.0;
      });
      CHECK(z < 4.0);
    }
  }
}

TEST_CASE("a rectangle irradiates as its configuration factor says", "[light]") {
  const auto rectangle = area_light(kRectangle), mesh = area_light(tessellated(kRectangle));
  for (const Vec3 p : {Vec3{0, 0, -1}, Vec3{0.9f, 0.4f, -0.1f}, Vec3{4, 1, -2}, Vec3{0, 0, -60}}) {
    const double expected = 2.0 * kPiD * rectangle_factor(p.x, p.y, -p.z);
    INFO(p.x << " " << p.y << " " << p.z);
    check_irradiance(*rectangle, p, {0, 0, 1}, expected);
    check_irradiance(*mesh, p, {0, 0, 1}, expected);
  }
  // Uniform in solid angle is the better estimator.
  const Vec3 near{0.9f, 0.4f, -0.1f};
  CHECK(irradiance(*rectangle, near, {0, 0, 1}).standard_error <
        0.5 * irradiance(*mesh, near, {0, 0, 1}).standard_error);
}

TEST_CASE("a rectangle's solid angle is right far, near and from the side", "[light]") {
  const auto light = area_light(kRectangle);
  // The closed form for a point above the middle (half sides a = 1, b = 1/2), in double.
  for (const float z : {1e-5f, 0.001f, 0.1f, 1.0f, 3.0f}) {
    const double d = z, solid_angle = 4 * std::asin(0.5 / std::sqrt((1 + d * d) * (0.25 + d * d)));
    const auto s = light->sample({0, 0, -z}, {0.5f, 0.5f}, 0);
    REQUIRE(s);
    CHECK(double{s->pdf} * solid_angle == Approx(1.0).epsilon(1e-5));
  }
  // Far away (here beyond 3.2) points are uniform over the area of 2: the density is d^2 / (A cos).
  for (const float z : {10.0f, 30.0f}) {
    const auto s = light->sample({0, 0, -z}, {0.9f, 0.1f}, 0);
    REQUIRE(s);
    const double cosine = z / double{s->distance};
    CHECK(double{s->pdf} == Approx(double{s->distance} * s->distance / (2 * cosine)).epsilon(1e-5));
  }
  // A millionfold copy a millionfold away is the same light.
  const RectangleGeometry large{{-1e6f, 5e5f, 0}, {2e6f, 0, 0}, {0, -1e6f, 0}};
  const auto s = area_light(large)->sample({0, 0, -1e6f}, {0.3f, 0.3f}, 0);
  const auto t = light->sample({0, 0, -1}, {0.3f, 0.3f}, 0);
  REQUIRE((s && t));
  CHECK(s->pdf == Approx(t->pdf).epsilon(1e-5));
  // On the light's plane, and on the light itself: nothing, and no NaN.
  CHECK_FALSE(light->sample({5, 0, 0}, {0.3f, 0.3f}, 0));
  CHECK_FALSE(light->sample({0, 0, 0}, {0.3f, 0.3f}, 0));
  CHECK_FALSE(light->sample({-1, 0.5f, 0}, {0.3f, 0.3f}, 0));
}

TEST_CASE("a sphere irradiates with pi L sin^2 from any distance", "[light]") {
  const auto light = area_light(SphereGeometry{{0, 0, 0}, 0.5f});
  for (const float d : {0.50001f, 0.6f, 1.0f, 10.0f, 5000.0f}) {
    INFO(d);
    check_irradiance(*light, {0, 0, -d}, {0, 0, 1}, 2.0 * kPiD * 0.25 / (double{d} * d));
  }
  // From inside a two-sided one: a furnace.
  const auto shell = area_light(SphereGeometry{{0, 0, 0}, 0.5f}, true);
  check_irradiance(*shell, {0.1f, 0.2f, 0.3f}, normalize({1, 2, 3}), 2.0 * kPiD);
  check_irradiance(*shell, {0, 0, 0}, {0, 0, 1}, 2.0 * kPiD);
}

TEST_CASE("a disk irradiates as its closed form says", "[light]") {
  const auto light = area_light(DiskGeometry{{0, 0, 0}, {0, 0, -1}, 0.7f});
  for (const float d : {0.2f, 1.0f, 20.0f}) {
    const double expected = 2.0 * kPiD * 0.49 / (0.49 + double{d} * d);
    check_irradiance(*light, {0, 0, -d}, {0, 0, 1}, expected);
  }
}

TEST_CASE("power is what leaves, emitted rays carry it", "[light]") {
  for (const Named& named : all_geometries()) {
    for (const bool two_sided : {false, true}) {
      INFO(named.name << two_sided);
      const auto light = area_light(named.geometry, two_sided);
      CHECK(light->power(1) ==
            Approx((two_sided ? 2 : 1) * 2 * kPiD * surface_area(named.geometry)).epsilon(1e-5));
      Numbers numbers;
      double sum = 0.0;
      const int n = 5000;
      for (int i = 0; i < n; ++i) {
        const Vec2 u = numbers.next();
        const auto ray = light->emit(u, numbers.next(), 0);
        if (!ray) continue;
        const float cosine = dot(ray->ray.direction, ray->normal);
        CHECK(cosine > 0.0f);
        const auto bounds = light->bounds();
        CHECK(length(ray->ray.origin - bounds.center) <= bounds.radius * 1.00001f);
        sum += double{ray->radiance[0]} * cosine / (double{ray->pdf_position} * ray->pdf_direction);
      }
      CHECK(sum / n == Approx(light->power(1)).epsilon(1e-3));  // the cosine cancels: no noise
    }
  }
}

TEST_CASE("a point light falls off with the square of the distance", "[light]") {
  const auto light =
      make_light("point", {{"intensity", constant_spectrum(3.0)}}, Transform::translate({0, 0, 4}));
  const auto s = light->sample({0, 0, 1}, {0.2f, 0.3f}, 0);
  REQUIRE(s);
  CHECK(light->is_delta());
  CHECK(s->wi == Vec3{0, 0, 1});
  CHECK(s->distance == Approx(3.0f));
  CHECK(s->pdf == 1.0f);
  CHECK(s->radiance[7] == Approx(3.0f / 9.0f));
  CHECK(light->power(1) == Approx(12 * kPiD));
  CHECK_FALSE(light->sample({0, 0, 4}, {0.2f, 0.3f}, 0));
  const auto ray = light->emit({0.1f, 0.2f}, {0.3f, 0.4f}, 0);
  REQUIRE(ray);
  CHECK(ray->radiance[0] / (ray->pdf_position * ray->pdf_direction) == Approx(light->power(1)));
}

TEST_CASE("a constant environment irradiates with pi L", "[light]") {
  const auto light = make_light("constant", {{"radiance", constant_spectrum(2.0)}});
  CHECK(light->is_environment());
  check_irradiance(*light, {0, 0, 0}, normalize({1, 2, 3}), 2 * kPiD);
  CHECK(light->power(3) == Approx(4 * kPiD * kPiD * 9 * 2));
  const double z = chi_square_z(*light, {0, 0, 0}, {0, 0, 1}, -1.0,
                                [&](Vec3 wi) { return double{light->pdf({}, wi, nullptr)}; });
  CHECK(z < 4.0);
}
