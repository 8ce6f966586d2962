// An exact sphere: no facets at any distance.
#include "render/shape.h"

namespace karat {
namespace {

class SphereShape final : public ShapeType {
 public:
  std::string description() const override { return "A sphere."; }

  std::vector<ParameterInfo> parameters() const override {
    return {{.name = "center",
             .type = ParameterType::kVector3,
             .description = "Center, in scene units.",
             .default_json = "[0, 0, 0]"},
            {.name = "radius",
             .description = "Radius, in scene units.",
             .default_json = "1",
             .min = 0,
             .exclusive_min = true}};
  }

  Geometry create(const Parameters& parameters) const override {
    return SphereGeometry{parameters.vector3("center"),
                          static_cast<float>(parameters.number("radius"))};
  }
};

KARAT_REGISTER(ShapeType, "sphere", SphereShape);

}  // namespace
}  // namespace karat
