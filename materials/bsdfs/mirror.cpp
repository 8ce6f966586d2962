// An ideal mirror that reflects everything: for white furnaces and geometry tests. A real mirror is
// a smooth conductor.
#include "materials/material.h"

namespace karat {
namespace {

class MirrorBsdf final : public Bsdf {
 public:
  Lobes lobes() const override { return lobe::kReflect | lobe::kDelta; }

  BsdfValue evaluate(const Vec3&, const Vec3&) const override {
    return {SampledSpectrum(0.0f), 0.0f};
  }

  std::optional<BsdfSample> sample(const Vec3& wo, const BsdfNumbers&) const override {
    if (!(wo.z > 0.0f)) return std::nullopt;
    return BsdfSample{{-wo.x, -wo.y, wo.z}, SampledSpectrum(1.0f), 1.0f, lobes()};
  }
};

class MirrorMaterial final : public Material {
 public:
  const Bsdf* prepare(const ShadingPoint&, SampledWavelengths, Transport,
                      BsdfStorage& storage) const override {
    return storage.make<MirrorBsdf>();
  }
  bool only_delta() const override { return true; }
};

class MirrorType final : public MaterialType {
 public:
  std::string description() const override {
    return "an ideal mirror that reflects everything; black seen from below";
  }
  std::vector<ParameterInfo> parameters() const override { return {}; }
  std::unique_ptr<const Material> create(const Parameters&, const MaterialContext&) const override {
    return std::make_unique<MirrorMaterial>();
  }
};

KARAT_REGISTER(MaterialType, "mirror", MirrorType);

}  // namespace
}  // namespace karat
