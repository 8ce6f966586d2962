// A pinhole or thin-lens camera with square pixels.
//
// Importance: film positions drawn uniformly over the whole image leave a lens point with the
// density 1 / (A cos^3 theta) per solid angle, where A is the image's area on the plane at distance
// 1 and theta the angle to the optical axis. receive() returns this density; its integral over the
// directions that the image covers is 1. It is W_e cos(theta) times the lens area in the notation
// of Pharr, Jakob and Humphreys, "Physically Based Rendering", 3rd ed. 2016, sec. 16.1.1. A path
// that arrives from `point` therefore adds (radiance leaving the point) x cos(point) / distance^2 x
// importance x (number of pixels) to the mean radiance of the pixel where it lands.
#include <fmt/format.h>

#include <cmath>

#include "materials/sampling.h"
#include "render/camera.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

class PerspectiveCamera final : public Camera {
 public:
  struct Setup {
    Vec3 position;
    Frame frame;  // s: right in the image, t: down in the image, n: the viewing direction
    float half_width, half_height;  // of the image at distance 1
    float aperture_radius, focus_distance;
    int width, height;  // pixels
  };
  explicit PerspectiveCamera(const Setup& setup)
      : setup_(setup),
        per_pixel_{2.0f * setup.half_width / static_cast<float>(setup.width),
                   2.0f * setup.half_height / static_cast<float>(setup.height)},
        inverse_area_(0.25f / (setup.half_width * setup.half_height)) {}

  Ray ray(const Vec2& film, const Vec2& lens) const override {
    const Vec3 at_one{film.x * per_pixel_.x - setup_.half_width,
                      film.y * per_pixel_.y - setup_.half_height, 1.0f};
    if (setup_.aperture_radius == 0.0f) {
      return {setup_.position, normalize(setup_.frame.to_world(at_one))};
    }
    const Vec3 on_lens = lens_point(lens);
    const Vec3 direction = at_one * setup_.focus_distance - on_lens;
    return {setup_.position + setup_.frame.to_world(on_lens),
            normalize(setup_.frame.to_world(direction))};
  }

  void rays(const BatchFloat film[2], const BatchFloat lens[2], BatchRay& result) const override {
    if (setup_.aperture_radius != 0.0f) return Camera::rays(film, lens, result);
    const Vec3 s = setup_.frame.s, t = setup_.frame.t, n = setup_.frame.n;
    for_whole_batch([&](int i) {
      const float x = film[0][i] * per_pixel_.x - setup_.half_width;
      const float y = film[1][i] * per_pixel_.y - setup_.half_height;
      result.origin.set(i, setup_.position);
      result.direction.set(i, normalize(s * x + t * y + n));
    });
  }

  bool receive(const Vec3& point, const Vec2& lens, Receive& result) const override {
    const Vec3 on_lens = setup_.aperture_radius == 0.0f ? Vec3{} : lens_point(lens);
    const Vec3 from_lens = setup_.frame.to_local(point - setup_.position) - on_lens;
    if (!(from_lens.z > 0.0f)) return false;
    // Where the ray crosses the plane in focus, divided by the focus distance.
    const float per_depth = 1.0f / from_lens.z, per_focus = 1.0f / setup_.focus_distance;
    const Vec2 at_one{from_lens.x * per_depth + on_lens.x * per_focus,
                      from_lens.y * per_depth + on_lens.y * per_focus};
    if (!(std::abs(at_one.x) < setup_.half_width && std::abs(at_one.y) < setup_.half_height)) {
      return false;
    }
    result.film = {(at_one.x + setup_.half_width) / per_pixel_.x,
                   (at_one.y + setup_.half_height) / per_pixel_.y};
    result.distance = length(from_lens);
    const float inverse_cos = result.distance * per_depth;
    result.direction = setup_.frame.to_world(from_lens) * (-1.0f / result.distance);
    result.importance = inverse_area_ * inverse_cos * inverse_cos * inverse_cos;
    return true;
  }

 private:
  Vec3 lens_point(Vec2 u) const {
    const Vec2 p = square_to_disk(u);
    return {setup_.aperture_radius * p.x, setup_.aperture_radius * p.y, 0.0f};
  }

  Setup setup_;
  Vec2 per_pixel_;
  float inverse_area_;
};

std::string text_of(const Vec3& v) { return fmt::format("[{:g}, {:g}, {:g}]", v.x, v.y, v.z); }

// The direction that is up in the image along the viewing direction n: what was given, else z, or y
// where the camera looks along z.
Vec3 up_direction(const Parameters& parameters, const Vec3& n) {
  const auto across = [&](const Vec3& up) { return length(cross(n, up)) > 1e-6f * length(up); };
  if (!parameters.has("up")) return across({0, 0, 1}) ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  const Vec3 up = parameters.vector3("up");
  if (!(length(up) > 0.0f)) throw InputError("up: found [0, 0, 0], allowed: a direction, not zero");
  if (!across(up)) {
    throw InputError("up: found " + text_of(up) + ", which is the viewing direction " + text_of(n) +
                     " or its opposite; allowed: a direction across it, as " +
                     (std::abs(n.z) > 0.9f ? "[0, 1, 0]" : "[0, 0, 1]") +
                     ", or none: one is chosen then");
  }
  return up;
}

// The viewing frame; throws where position, look_at and up leave it undetermined.
Frame viewing_frame(const Parameters& parameters) {
  const Vec3 position = parameters.vector3("position");
  const Vec3 forward = parameters.vector3("look_at") - position;
  if (!(length(forward) > 0.0f)) {
    throw InputError("look_at: found " + text_of(position) +
                     ", which is the camera's position; allowed: another point");
  }
  const Vec3 n = normalize(forward);
  const Vec3 s = normalize(cross(n, up_direction(parameters, n)));
  return {s, cross(n, s), n};
}

// Whether the angle of view spans the image's width.
bool spans_width(const std::string& axis, int width, int height) {
  if (axis == "x") return true;
  if (axis == "y") return false;
  return (axis == "smaller") == (width <= height);
}

class PerspectiveType final : public CameraType {
 public:
  std::string description() const override {
    return "A pinhole camera, or a thin lens with depth of field.";
  }

  std::vector<ParameterInfo> parameters() const override {
    return {{.name = "position",
             .type = ParameterType::kVector3,
             .description = "Where the camera is, in scene units.",
             .required = true},
            {.name = "look_at",
             .type = ParameterType::kVector3,
             .description = "The point in the middle of the image, in scene units.",
             .required = true},
            {.name = "up",
             .type = ParameterType::kVector3,
             .description = "The direction that points up in the image; any length. Unless given, "
                            "z, or y where the camera looks along z."},
            {.name = "fov_deg",
             .description = "Full angle of view along fov_axis, in degrees.",
             .default_json = "40",
             .min = 0,
             .max = 179,
             .exclusive_min = true},
            {.name = "fov_axis",
             .type = ParameterType::kChoice,
             .description = "The side of the image that fov_deg spans.",
             .default_json = "\"smaller\"",
             .choices = {"x", "y", "smaller", "larger"}},
            {.name = "aperture_radius",
             .description = "Radius of the lens, in scene units; 0 is a pinhole.",
             .default_json = "0",
             .min = 0},
            {.name = "focus_distance",
             .description = "Distance of the plane in focus along the viewing direction, in scene "
                            "units; the distance to look_at unless given.",
             .min = 0,
             .exclusive_min = true}};
  }

  std::unique_ptr<const Camera> create(const Parameters& parameters, int width,
                                       int height) const override {
    const Vec3 position = parameters.vector3("position"), look_at = parameters.vector3("look_at");
    PerspectiveCamera::Setup setup;
    setup.position = position;
    setup.frame = viewing_frame(parameters);
    const auto half_angle = static_cast<float>(parameters.number("fov_deg")) * (kPi / 360.0f);
    const bool along_width = spans_width(parameters.string("fov_axis"), width, height);
    const float per_pixel = std::tan(half_angle) / static_cast<float>(along_width ? width : height);
    setup.half_width = per_pixel * static_cast<float>(width);
    setup.half_height = per_pixel * static_cast<float>(height);
    setup.aperture_radius = static_cast<float>(parameters.number("aperture_radius"));
    setup.focus_distance = parameters.has("focus_distance")
                               ? static_cast<float>(parameters.number("focus_distance"))
                               : length(look_at - position);
    setup.width = width;
    setup.height = height;
    return std::make_unique<PerspectiveCamera>(setup);
  }
};

KARAT_REGISTER(CameraType, "perspective", PerspectiveType);

}  // namespace
}  // namespace karat
