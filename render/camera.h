// Cameras turn film positions into rays.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "materials/parameters.h"
#include "render/transform.h"
#include "render/world.h"
#include "spectral/support/registry.h"

namespace karat {

class Camera {
 public:
  virtual ~Camera() = default;

  // `film` in pixels from the upper left corner of the whole image, `lens` in [0, 1)^2. Every ray
  // carries radiance with weight 1 (no vignetting, no cos^4: an ideal sensor).
  virtual Ray ray(const Vec2& film, const Vec2& lens) const = 0;

  // The same for every path of a batch.
  virtual void rays(const BatchFloat film[2], const BatchFloat lens[2], BatchRay& result) const {
    for (int i = 0; i < kBatch; ++i) {
      const Ray one = ray({film[0][i], film[1][i]}, {lens[0][i], lens[1][i]});
      result.origin.set(i, one.origin);
      result.direction.set(i, one.direction);
    }
  }

  // Where a scene point lands on the film (pixels), through the given lens point, with the
  // importance per unit solid angle and the direction from `point` to the lens; false when outside.
  // For transport from the lights.
  struct Receive {
    Vec2 film;
    Vec3 direction;
    float distance;
    float importance;
  };
  virtual bool receive(const Vec3& point, const Vec2& lens, Receive& result) const = 0;
};

// One source file per camera (render/cameras/), ending in KARAT_REGISTER(CameraType, "perspective",
// ...).
class CameraType {
 public:
  virtual ~CameraType() = default;
  virtual std::string description() const = 0;
  virtual std::vector<ParameterInfo> parameters() const = 0;
  virtual std::unique_ptr<const Camera> create(const Parameters& parameters, int width,
                                               int height) const = 0;
};

}  // namespace karat
