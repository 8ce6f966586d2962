// Glass and its kin: reflection and refraction between two media that do not absorb, with the index
// per wavelength.
//
// Both sides scatter: wo.z < 0 is the side of `interior`. Radiance is divided by the squared
// relative index where it is refracted (Transport::kRadiance), importance is not.
//
// Smooth: reflection is chosen with the mean reflectance over the lanes, which is the same
// probability whatever the hero lane is; every lane keeps its own weight. A refracted ray of a
// dispersive medium belongs to the hero lane alone.
// Rough: rough_dielectric.h and multiple_scattering.h.
#include <cmath>
#include <optional>

#include "materials/fresnel_dielectric.h"
#include "materials/relative_index.h"
#include "materials/rough_dielectric.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

// An index so near to 1 leaves a rough surface nothing to scatter by: half vectors lose all digits.
constexpr float kMatchedIndex = 1e-3f;
// Below this relative spread over the lattice an index counts as constant (float rounding of a
// constant divided by a constant).
constexpr float kConstantIndex = 1e-6f;

class SmoothDielectricBsdf final : public Bsdf {
 public:
  explicit SmoothDielectricBsdf(const DielectricInterface& interface) : interface_(interface) {}

  Lobes lobes() const override { return lobe::kReflect | lobe::kTransmit | lobe::kDelta; }
  bool dispersive() const override { return interface_.dispersive; }

  BsdfValue evaluate(const Vec3&, const Vec3&) const override {
    return {SampledSpectrum(0.0f), 0.0f};
  }

  std::optional<BsdfSample> sample(const Vec3& wo, const BsdfNumbers& u) const override {
    if (wo.z == 0.0f) return std::nullopt;
    const SampledSpectrum& eta = interface_.eta(wo.z);
    const float cos_theta = std::min(std::abs(wo.z), 1.0f);
    const SampledSpectrum f = dielectric_reflectance(cos_theta, eta);
    const float reflected = mean(f);
    if (u.lobe < reflected) {
      return BsdfSample{
          {-wo.x, -wo.y, wo.z}, f * (1.0f / reflected), 1.0f, lobe::kReflect | lobe::kDelta};
    }
    return transmitted(wo, f, 1.0f / (1.0f - reflected));
  }

 private:
  std::optional<BsdfSample> transmitted(Vec3 wo, const SampledSpectrum& f, float scale) const {
    const SampledSpectrum& eta = interface_.eta(wo.z);
    const int hero = interface_.hero;
    if (!(f[hero] < 1.0f)) return std::nullopt;  // totally reflected, though other lanes are not
    SampledSpectrum weight;
    for (int i = 0; i < kLanes; ++i) {
      const bool follows = !interface_.dispersive || i == hero;
      weight[i] = follows ? (1.0f - f[i]) * scale * interface_.radiance_scale(eta[i]) : 0.0f;
    }
    const Vec3 facet{0.0f, 0.0f, std::copysign(1.0f, wo.z)};
    return BsdfSample{refract(wo, facet, eta[hero]), weight,   1.0f, lobe::kTransmit | lobe::kDelta,
                      interface_.dispersive,         eta[hero]};
  }

  DielectricInterface interface_;
};

class DielectricMaterial final : public Material {
 public:
  DielectricMaterial(LatticeSpectrum eta, bool dispersive, Roughness roughness, bool multiple)
      : eta_(eta), dispersive_(dispersive), roughness_(roughness) {
    for (int phase = 0; phase < kPhases; ++phase) {
      inverse_[phase] = for_each_lane([&](int i) { return 1.0f / eta_[phase][i]; });
    }
    if (multiple && !roughness.smooth()) multiple_.emplace(roughness, eta_, dispersive);
  }

  const Bsdf* prepare(const ShadingPoint&, SampledWavelengths wavelengths, Transport transport,
                      BsdfStorage& storage) const override {
    const DielectricInterface interface {
      &eta_[wavelengths.phase], &inverse_[wavelengths.phase], wavelengths.hero, dispersive_,
          transport == Transport::kRadiance, wavelengths.phase
    };
    if (roughness_.smooth()) return storage.make<SmoothDielectricBsdf>(interface);
    return storage.make<RoughDielectricBsdf>(interface, roughness_,
                                             multiple_ ? &*multiple_ : nullptr);
  }
  bool uses_uv() const override { return roughness_.anisotropic(); }
  bool only_delta() const override { return roughness_.smooth(); }
  bool transmits() const override { return true; }

 private:
  LatticeSpectrum eta_, inverse_;
  bool dispersive_;
  Roughness roughness_;
  std::optional<MultipleScattering> multiple_;
};

class DielectricType final : public MaterialType {
 public:
  std::string description() const override {
    return "a transparent medium (glass, water, gems), smooth or rough, dispersive as its index is";
  }
  std::vector<ParameterInfo> parameters() const override {
    ParameterInfo interior;
    interior.name = "interior";
    interior.type = ParameterType::kIndex;
    interior.description = "index of the medium inside, of which n counts, e.g. main/SiO2/Malitson";
    interior.required = true;
    ParameterInfo multiple;
    multiple.name = "multiple_scattering";
    multiple.type = ParameterType::kBoolean;
    multiple.description =
        "light that meets the rough surface more than once (no energy is lost); without it that "
        "light is lost";
    multiple.default_json = "true";
    std::vector<ParameterInfo> all{interior, exterior_parameter(), multiple};
    for (ParameterInfo& info : roughness_parameters()) all.push_back(std::move(info));
    return all;
  }

  std::unique_ptr<const Material> create(const Parameters& parameters,
                                         const MaterialContext& context) const override {
    const LatticeIndex index = relative_index("interior", parameters, context);
    warn_if_absorbing("interior", index.k, "a dielectric uses its n alone", context);
    Roughness roughness = read_roughness(parameters, *context.warnings);
    const auto [least, largest] = extremes(index.n);
    if (!(least > 0.0f)) {
      throw InputError("interior: its n is " + std::to_string(least) +
                       " relative to the exterior somewhere; it must be above 0");
    }
    if (!roughness.smooth() && least < 1.0f + kMatchedIndex && largest > 1.0f - kMatchedIndex) {
      context.warnings->push_back(
          "interior and exterior have nearly the same index: the surface is rendered as smooth");
      roughness.alpha = {0.0f, 0.0f};
    }
    const bool dispersive = largest - least > kConstantIndex * largest;
    return std::make_unique<DielectricMaterial>(index.n, dispersive, roughness,
                                                parameters.boolean("multiple_scattering"));
  }
};

KARAT_REGISTER(MaterialType, "dielectric", DielectricType);

}  // namespace
}  // namespace karat
