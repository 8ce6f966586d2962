// A luminous disk, sampled uniformly over its area.
#include "materials/sampling.h"
#include "render/area_light.h"

namespace karat {
namespace {

class DiskLight final : public AreaLight {
 public:
  DiskLight(const DiskGeometry& disk, const LatticeSpectrum& spectrum, bool both)
      : AreaLight(spectrum, both, surface_area(disk), {disk.center, disk.radius}),
        center_(disk.center),
        radius_(disk.radius),
        frame_(Frame::around(disk.normal)) {}

 protected:
  SurfacePoint surface_point(const Vec2& u) const override {
    const Vec2 p = square_to_disk(u);
    return {center_ + (frame_.s * p.x + frame_.t * p.y) * radius_, frame_.n};
  }

 private:
  Vec3 center_;
  float radius_;
  Frame frame_;
};

}  // namespace

std::unique_ptr<const Light> make_disk_light(const DiskGeometry& disk,
                                             const LatticeSpectrum& radiance, bool two_sided) {
  return std::make_unique<DiskLight>(disk, radiance, two_sided);
}

}  // namespace karat
