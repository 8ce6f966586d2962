// A rectangle in the xy plane around the origin; its outward side looks along +z.
#include "render/shape.h"

namespace karat {
namespace {

class RectangleShape final : public ShapeType {
 public:
  std::string description() const override {
    return "A rectangle in the xy plane around the origin, outward side +z.";
  }

  std::vector<ParameterInfo> parameters() const override {
    return {{.name = "width",
             .description = "Length along x, in scene units.",
             .default_json = "1",
             .min = 0,
             .exclusive_min = true},
            {.name = "height",
             .description = "Length along y, in scene units.",
             .default_json = "1",
             .min = 0,
             .exclusive_min = true}};
  }

  Geometry create(const Parameters& parameters) const override {
    const auto width = static_cast<float>(parameters.number("width"));
    const auto height = static_cast<float>(parameters.number("height"));
    return RectangleGeometry{{-0.5f * width, -0.5f * height, 0}, {width, 0, 0}, {0, height, 0}};
  }
};

KARAT_REGISTER(ShapeType, "rectangle", RectangleShape);

}  // namespace
}  // namespace karat
