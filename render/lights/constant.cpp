// The same radiance from every direction.
#include "materials/sampling.h"
#include "render/area_light.h"
#include "render/light.h"

namespace karat {
namespace {

constexpr float kUniformPdf = 0.25f * kInvPi;

class ConstantEnvironment final : public Light {
 public:
  explicit ConstantEnvironment(const LatticeSpectrum& radiance)
      : radiance_(radiance), mean_radiance_(lattice_mean(radiance)) {}

  std::optional<LightSample> sample(const Vec3&, const Vec2& u, int phase) const override {
    return LightSample{square_to_sphere(u), std::numeric_limits<float>::infinity(), kUniformPdf,
                       radiance_[phase]};
  }
  float pdf(const Vec3&, const Vec3&, const SurfaceHit*) const override { return kUniformPdf; }
  SampledSpectrum radiance(const Vec3&, const SurfaceHit*, int phase) const override {
    return radiance_[phase];
  }
  bool is_environment() const override { return true; }

  // Through a sphere around the scene: every direction's parallel light fills a disk, pi R^2.
  float power(float scene_radius) const override {
    return 4.0f * kPi * kPi * scene_radius * scene_radius * mean_radiance_;
  }

 private:
  LatticeSpectrum radiance_;
  float mean_radiance_;
};

class ConstantType final : public LightType {
 public:
  std::string description() const override {
    return "An environment with the same radiance from every direction.";
  }

  std::vector<ParameterInfo> parameters() const override {
    return {{.name = "radiance",
             .type = ParameterType::kEmission,
             .description = "Radiance, in W m^-2 sr^-1 nm^-1.",
             .default_json = "1"}};
  }

  std::unique_ptr<const Light> create(const Parameters& parameters,
                                      const LightContext& context) const override {
    return std::make_unique<ConstantEnvironment>(
        bin_means(*parameters.spectrum("radiance"), context.lattice));
  }
};

KARAT_REGISTER(LightType, "constant", ConstantType);

}  // namespace
}  // namespace karat
