// A point that shines equally in every direction.
#include <cmath>

#include "materials/sampling.h"
#include "render/area_light.h"
#include "render/light.h"

namespace karat {
namespace {

class PointLight final : public Light {
 public:
  PointLight(Vec3 position, const LatticeSpectrum& intensity)
      : position_(position), intensity_(intensity), mean_intensity_(lattice_mean(intensity)) {}

  std::optional<LightSample> sample(const Vec3& point, const Vec2&, int phase) const override {
    const Vec3 to_light = position_ - point;
    const float squared = length_squared(to_light);
    const float distance = std::sqrt(squared);
    const float inverse_squared = 1.0f / squared;
    if (!std::isfinite(inverse_squared)) return std::nullopt;
    return LightSample{to_light * (1.0f / distance), distance, 1.0f,
                       intensity_[phase] * inverse_squared};
  }
  float pdf(const Vec3&, const Vec3&, const SurfaceHit*) const override { return 0.0f; }
  SampledSpectrum radiance(const Vec3&, const SurfaceHit*, int) const override {
    return SampledSpectrum(0.0f);
  }
  bool is_delta() const override { return true; }
  float power(float) const override { return 4.0f * kPi * mean_intensity_; }
  Bounds bounds() const override { return {position_, 0.0f}; }

  // `radiance` holds the intensity; the position has density 1.
  std::optional<EmittedRay> emit(Vec2, Vec2 u_direction, int phase) const override {
    const Vec3 direction = square_to_sphere(u_direction);
    return EmittedRay{{position_, direction}, direction, 1.0f, 0.25f * kInvPi, intensity_[phase]};
  }

 private:
  Vec3 position_;
  LatticeSpectrum intensity_;
  float mean_intensity_;
};

class PointType final : public LightType {
 public:
  std::string description() const override {
    return "A point that shines equally in every direction.";
  }

  std::vector<ParameterInfo> parameters() const override {
    return {{.name = "position",
             .type = ParameterType::kVector3,
             .description = "Where the light is, in scene units.",
             .default_json = "[0, 0, 0]"},
            {.name = "intensity",
             .type = ParameterType::kEmission,
             .description = "Radiant intensity, in W sr^-1 nm^-1.",
             .default_json = "1"}};
  }

  std::unique_ptr<const Light> create(const Parameters& parameters,
                                      const LightContext& context) const override {
    return std::make_unique<PointLight>(
        context.transform.point(parameters.vector3("position")),
        bin_means(*parameters.spectrum("intensity"), context.lattice));
  }
};

KARAT_REGISTER(LightType, "point", PointType);

}  // namespace
}  // namespace karat
