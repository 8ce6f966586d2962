// Ideal diffuse reflection: f = reflectance / pi (Lambert, Photometria, 1760).
#include "materials/material.h"
#include "materials/sampling.h"

namespace karat {
namespace {

class DiffuseBsdf final : public Bsdf {
 public:
  explicit DiffuseBsdf(const SampledSpectrum* reflectance) : reflectance_(reflectance) {}

  Lobes lobes() const override { return lobe::kReflect | lobe::kDiffuse; }

  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const override {
    if (!(wo.z > 0.0f && wi.z > 0.0f)) return {SampledSpectrum(0.0f), 0.0f};
    const float pdf = wi.z * kInvPi;
    return {*reflectance_ * pdf, pdf};
  }

  // One variable, returned on every way, is filled where the caller wants it; anything else is
  // built apart and copied, 256 bytes of it.
  std::optional<BsdfSample> sample(const Vec3& wo, const BsdfNumbers& u) const override {
    std::optional<BsdfSample> result;
    if (!(wo.z > 0.0f)) return result;
    const Vec3 wi = square_to_cosine_hemisphere(u.direction);
    if (!(wi.z > 0.0f)) return result;
    BsdfSample& sample = result.emplace();
    sample.wi = wi;
    sample.weight = *reflectance_;
    sample.pdf = wi.z * kInvPi;
    sample.lobes = lobes();
    return result;
  }

 private:
  const SampledSpectrum* reflectance_;
};

class DiffuseMaterial final : public Material {
 public:
  explicit DiffuseMaterial(LatticeSpectrum reflectance) : reflectance_(reflectance) {}

  const Bsdf* prepare(const ShadingPoint&, SampledWavelengths wavelengths, Transport,
                      BsdfStorage& storage) const override {
    return storage.make<DiffuseBsdf>(&reflectance_[wavelengths.phase]);
  }

 private:
  LatticeSpectrum reflectance_;
};

class DiffuseType final : public MaterialType {
 public:
  std::string description() const override {
    return "ideal diffuse (Lambertian) reflection; black seen from below";
  }
  std::vector<ParameterInfo> parameters() const override {
    ParameterInfo reflectance;
    reflectance.name = "reflectance";
    reflectance.type = ParameterType::kReflectance;
    reflectance.description = "fraction of the light that is reflected, in [0, 1]";
    reflectance.default_json = "0.5";
    return {reflectance};
  }
  std::unique_ptr<const Material> create(const Parameters& parameters,
                                         const MaterialContext& context) const override {
    return std::make_unique<DiffuseMaterial>(
        bin_means(*parameters.spectrum("reflectance"), context.lattice));
  }
};

KARAT_REGISTER(MaterialType, "diffuse", DiffuseType);

}  // namespace
}  // namespace karat
