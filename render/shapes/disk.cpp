// A flat disk in the xy plane around the origin; its outward side looks along +z.
#include "render/shape.h"

namespace karat {
namespace {

class DiskShape final : public ShapeType {
 public:
  std::string description() const override {
    return "A flat disk in the xy plane around the origin, outward side +z.";
  }

  std::vector<ParameterInfo> parameters() const override {
    return {{.name = "radius",
             .description = "Radius, in scene units.",
             .default_json = "1",
             .min = 0,
             .exclusive_min = true}};
  }

  Geometry create(const Parameters& parameters) const override {
    return DiskGeometry{{0, 0, 0}, {0, 0, 1}, static_cast<float>(parameters.number("radius"))};
  }
};

KARAT_REGISTER(ShapeType, "disk", DiskShape);

}  // namespace
}  // namespace karat
