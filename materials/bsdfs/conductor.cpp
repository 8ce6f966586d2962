// A metal: reflection at an interface to an absorbing medium, smooth or rough.
//
// Rough: f = F(o.h) D(h) G2(o, i) / (4 cos_o cos_i), Cook and Torrance 1982 with the 4 of Walter et
// al. 2007, equation 20; height-correlated G2 = 1 / (1 + Lambda(o) + Lambda(i)), Heitz 2014,
// equation 99; sampled by visible normals, Heitz 2018. Single scattering: light that would meet the
// surface twice is lost.
//
// An index that is a stack of thin films gives its own exact Fresnel term, tabulated over angle.
#include <algorithm>
#include <cmath>

#include "materials/film_stack.h"
#include "materials/fresnel_choice.h"
#include "materials/microfacet_reflection.h"
#include "materials/relative_index.h"
#include "materials/roughness.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

class SmoothConductorBsdf final : public Bsdf {
 public:
  SmoothConductorBsdf(const FresnelModel* fresnel, const FresnelTables* tables, int phase)
      : fresnel_(fresnel), tables_(tables), phase_(phase) {}

  Lobes lobes() const override { return lobe::kReflect | lobe::kDelta; }

  BsdfValue evaluate(const Vec3&, const Vec3&) const override {
    return {SampledSpectrum(0.0f), 0.0f};
  }

  std::optional<BsdfSample> sample(const Vec3& wo, const BsdfNumbers&) const override {
    std::optional<BsdfSample> result;  // the one variable that is returned, see diffuse.cpp
    if (!(wo.z > 0.0f)) return result;
    BsdfSample& sample = result.emplace();
    sample.wi = {-wo.x, -wo.y, wo.z};
    sample.weight = bounded_reflectance(*fresnel_, *tables_, phase_, std::min(wo.z, 1.0f));
    sample.pdf = 1.0f;
    sample.lobes = lobes();
    return result;
  }

 private:
  const FresnelModel* fresnel_;
  const FresnelTables* tables_;
  int phase_;
};

class RoughConductorBsdf final : public Bsdf {
 public:
  RoughConductorBsdf(const FresnelModel* fresnel, const FresnelTables* tables, int phase,
                     Roughness roughness)
      : fresnel_(fresnel), tables_(tables), facets_(roughness), phase_(phase) {}

  Lobes lobes() const override { return lobe::kReflect | lobe::kGlossy; }

  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const override {
    const FacetReflection r = facets_.evaluate(wo, wi);
    if (!(r.pdf > 0.0f)) return {SampledSpectrum(0.0f), 0.0f};
    return {bounded_reflectance(*fresnel_, *tables_, phase_, r.cos_facet) * r.value, r.pdf};
  }

  std::optional<BsdfSample> sample(const Vec3& wo, const BsdfNumbers& u) const override {
    std::optional<BsdfSample> result;  // the one variable that is returned, see diffuse.cpp
    const std::optional<FacetReflectionSample> s = facets_.sample(wo, u.direction);
    if (!s) return result;
    BsdfSample& sample = result.emplace();
    sample.wi = s->wi;
    sample.weight = bounded_reflectance(*fresnel_, *tables_, phase_, s->cos_facet);
    sample.weight *= s->weight;
    sample.pdf = s->pdf;
    sample.lobes = lobes();
    return result;
  }

 private:
  const FresnelModel* fresnel_;
  const FresnelTables* tables_;
  MicrofacetReflection facets_;
  int phase_;
};

class ConductorMaterial final : public Material {
 public:
  ConductorMaterial(PreparedFresnel fresnel, Roughness roughness)
      : fresnel_(*fresnel.model), tables_(std::move(fresnel.tables)), roughness_(roughness) {}

  const Bsdf* prepare(const ShadingPoint&, SampledWavelengths wavelengths, Transport,
                      BsdfStorage& storage) const override {
    if (roughness_.smooth()) {
      return storage.make<SmoothConductorBsdf>(&fresnel_, &tables_, wavelengths.phase);
    }
    return storage.make<RoughConductorBsdf>(&fresnel_, &tables_, wavelengths.phase, roughness_);
  }
  bool uses_uv() const override { return roughness_.anisotropic(); }
  bool only_delta() const override { return roughness_.smooth(); }

 private:
  const FresnelModel& fresnel_;
  FresnelTables tables_;
  Roughness roughness_;
};

// For what holds of every stack of a scene.
void warn_once(const std::string& warning, const MaterialContext& context) {
  auto& warnings = *context.warnings;
  if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) {
    warnings.push_back(warning);
  }
}

// The tables for tabulated_fresnel(), with a warning where they do what was not asked for.
PreparedFresnel prepare_films(const FilmStack& films, const Parameters& parameters,
                              const MaterialContext& context) {
  if (const std::string& model = parameters.fresnel("fresnel").model; model != "exact") {
    throw InputError("fresnel: found \"" + model +
                     "\", allowed: \"exact\", because \"nk\" is a stack of thin films");
  }
  const std::string& name = context.fresnel_override;
  if (!name.empty() && name != "exact") {
    warn_once("the Fresnel model " + name + " does not apply to thin films: theirs stays exact",
              context);
  }
  TabulatedReflectance films_of_angle =
      tabulated_films(films, *exterior_index(parameters, context), context.lattice);
  if (films_of_angle.error > kTabulatedError) {
    warn_once("thin films: between tabulated angles the reflectance is off by up to " +
                  std::to_string(films_of_angle.error),
              context);
  }
  return {&tabulated_fresnel(), std::move(films_of_angle.tables)};
}

class ConductorType final : public MaterialType {
 public:
  std::string description() const override {
    return "a metal from its measured complex index, smooth or rough; black seen from below";
  }
  std::vector<ParameterInfo> parameters() const override {
    ParameterInfo nk;
    nk.name = "nk";
    nk.type = ParameterType::kIndex;
    nk.description = "complex index of the metal, or thin films on a substrate";
    nk.required = true;
    std::vector<ParameterInfo> all{nk, exterior_parameter(), fresnel_parameter()};
    for (ParameterInfo& info : roughness_parameters()) all.push_back(std::move(info));
    return all;
  }
  std::unique_ptr<const Material> create(const Parameters& parameters,
                                         const MaterialContext& context) const override {
    const FilmStack* films = film_stack_of(*parameters.index("nk"));
    PreparedFresnel fresnel =
        films ? prepare_films(*films, parameters, context)
              : prepare_fresnel(parameters, relative_index("nk", parameters, context), context);
    return std::make_unique<ConductorMaterial>(std::move(fresnel),
                                               read_roughness(parameters, *context.warnings));
  }
};

KARAT_REGISTER(MaterialType, "conductor", ConductorType);

}  // namespace
}  // namespace karat
