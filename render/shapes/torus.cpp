// A torus around the z axis.
#include <cmath>

#include "render/shape.h"
#include "render/shapes/revolution.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

class TorusShape final : public ShapeType {
 public:
  std::string description() const override {
    return "A torus around the z axis, with exact normals at its vertices.";
  }

  std::vector<ParameterInfo> parameters() const override {
    return {{.name = "major_radius",
             .description = "From the center to the middle of the tube, in scene units.",
             .default_json = "1",
             .min = 0,
             .exclusive_min = true},
            {.name = "minor_radius",
             .description = "Radius of the tube, less than major_radius, in scene units.",
             .default_json = "0.25",
             .min = 0,
             .exclusive_min = true},
            segments_around_axis(),
            {.name = "segments_v",
             .type = ParameterType::kInteger,
             .description = "Faces around the tube.",
             .default_json = "128",
             .min = 3,
             .max = 16384}};
  }

  Geometry create(const Parameters& parameters) const override {
    const double major = parameters.number("major_radius");
    const double minor = parameters.number("minor_radius");
    if (!(minor < major)) {
      throw InputError("minor_radius " + std::to_string(minor) +
                       " must be less than major_radius " + std::to_string(major) +
                       ": the torus would pass through itself");
    }
    const int segments = parameters.integer("segments_v");
    std::vector<ProfilePoint> profile;
    for (int j = 0; j < segments; ++j) {
      const double v = static_cast<double>(j) / segments, angle = 6.28318530717958647692 * v;
      const double c = std::cos(angle), s = std::sin(angle);
      profile.push_back({major + minor * c, minor * s, c, s, v});
    }
    profile.push_back(profile.front());
    profile.back().v = 1.0;
    return revolved(profile, parameters.integer("segments_u"));
  }
};

KARAT_REGISTER(ShapeType, "torus", TorusShape);

}  // namespace
}  // namespace karat
