// Reflection models by name: their parameters, and what only one of them does.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "materials/fresnel.h"
#include "materials/microfacet.h"
#include "spectral/support/error.h"
#include "tests/material_cases.h"
#include "tests/reference_fresnel.h"

using namespace karat;

namespace {

Parameters with(std::initializer_list<std::pair<const char*, ParameterValue>> settings) {
  Parameters parameters;
  for (const auto& [name, value] : settings) parameters.set(name, value);
  return parameters;
}

IndexTablePtr prism() {
  return index_from_spectra(table_spectrum({380.0, 780.0}, {1.8, 1.5}, "n"), constant_spectrum(0.0),
                            {});
}

const Bsdf& prepared(const Material& material, BsdfStorage& storage, Transport transport,
                     SampledWavelengths wavelengths = {4, 9}) {
  return *material.prepare({}, wavelengths, transport, storage);
}

}  // namespace

TEST_CASE("choices of a parameter are what is registered", "[bsdf]") {
  for (const std::string& type : Registry<MaterialType>::instance().names()) {
    CHECK_FALSE(Registry<MaterialType>::instance().find(type)->description().empty());
    for (const ParameterInfo& info : Registry<MaterialType>::instance().find(type)->parameters()) {
      CAPTURE(type, info.name);
      CHECK_FALSE(info.description.empty());
      if (info.name == "fresnel") {
        CHECK(info.choices == Registry<FresnelModel>::instance().names());
      }
      if (info.name == "distribution") {
        CHECK(info.choices == Registry<MicrofacetDistribution>::instance().names());
      }
    }
  }
}

TEST_CASE("contradicting roughness parameters are errors", "[bsdf]") {
  for (const auto& values :
       {with({{"alpha", 0.2}, {"roughness", 0.4}}), with({{"alpha", 0.2}, {"alpha_x", 0.4}}),
        with({{"alpha_x", 0.2}}), with({{"alpha_y", 0.2}}),
        with({{"roughness", 0.2}, {"alpha_x", 0.2}, {"alpha_y", 0.2}}),
        with({{"distribution", std::string("ggxx")}})}) {
    CHECK_THROWS_AS(test::make_material("conductor", values), InputError);
    CHECK_THROWS_AS(test::make_material("dielectric", values), InputError);
  }
}

TEST_CASE("roughness is the square root of alpha", "[bsdf]") {
  const auto by_alpha = test::make_material("conductor", with({{"alpha", 0.16}}));
  const auto by_roughness = test::make_material("conductor", with({{"roughness", 0.4}}));
  BsdfStorage a, b;
  const Vec3 wo = normalize({0.3f, 0.1f, 1.0f}), wi = normalize({-0.2f, 0.0f, 1.0f});
  const float expected = prepared(*by_alpha, a, Transport::kRadiance).evaluate(wo, wi).pdf;
  CHECK(prepared(*by_roughness, b, Transport::kRadiance).evaluate(wo, wi).pdf ==
        Approx(expected).epsilon(1e-5));
}

TEST_CASE("an alpha below a thousandth is smooth, with a warning unless it is zero", "[bsdf]") {
  for (const char* type : {"conductor", "dielectric"}) {
    std::vector<std::string> warnings;
    CHECK(test::make_material(type, with({{"alpha", 0.0}}), &warnings)->only_delta());
    CHECK(warnings.empty());
    CHECK(test::make_material(type, with({{"alpha", 5e-4}}), &warnings)->only_delta());
    CHECK(warnings.size() == 1);
    CHECK_FALSE(test::make_material(type, with({{"alpha", 1e-3}}), &warnings)->only_delta());
    CHECK(warnings.size() == 1);
  }
}

TEST_CASE("an override replaces the conductor's Fresnel model, and must exist", "[bsdf]") {
  const auto values = with({{"nk", constant_index({0.96, 6.69})}});
  const Vec3 wo = normalize({3.0f, 0.0f, 1.0f});
  const double cos_theta = double{wo.z};
  const auto reflectance = [&](const std::string& override_name) {
    BsdfStorage storage;
    const auto material = test::make_material("conductor", values, nullptr, override_name);
    return double{prepared(*material, storage, Transport::kRadiance).sample(wo, {})->weight[3]};
  };
  CHECK(reflectance("") ==
        Approx(reference::fresnel(0.96, 6.69, cos_theta).unpolarised()).margin(5e-6));
  const double schlick = Registry<FresnelModel>::instance()
                             .find("schlick")
                             ->evaluate({0.96, 6.69}, cos_theta)
                             .unpolarised;
  CHECK(reflectance("schlick") == Approx(schlick).margin(5e-6));
  CHECK(std::abs(reflectance("schlick") - reflectance("")) > 1e-3);
  CHECK_THROWS_WITH(reflectance("shlick"), Catch::Contains("did you mean \"schlick\""));
}

TEST_CASE("an exterior divides the index; one that absorbs is warned about", "[bsdf]") {
  std::vector<std::string> warnings;
  const auto material = test::make_material(
      "conductor",
      with({{"nk", constant_index({0.6, 4.2})}, {"exterior", constant_index({1.5, 0.0})}}),
      &warnings);
  CHECK(warnings.empty());
  BsdfStorage storage;
  const auto s = prepared(*material, storage, Transport::kRadiance).sample({0, 0, 1}, {});
  CHECK(double{s->weight[0]} == Approx(reference::fresnel(0.4, 2.8, 1.0).unpolarised()));
  test::make_material("conductor", with({{"exterior", constant_index({1.3, 0.1})}}), &warnings);
  CHECK(warnings.size() == 1);
  test::make_material("dielectric", with({{"interior", constant_index({1.5, 0.1})}}), &warnings);
  CHECK(warnings.size() == 2);
  CHECK_THROWS_AS(
      test::make_material("conductor", with({{"exterior", constant_index({0.0, 0.0})}})),
      InputError);
  CHECK_THROWS_AS(
      test::make_material("dielectric", with({{"interior", constant_index({-1.0, 0.0})}})),
      InputError);
}

TEST_CASE("smooth glass refracts by Snell's law, each hero by its own index", "[bsdf]") {
  const auto material = test::make_material("dielectric", with({{"interior", prism()}}));
  CHECK(material->transmits());
  const Vec3 wo = normalize({0.8f, 0.3f, 0.6f});
  for (const int hero : {0, 7, kLanes - 1}) {
    BsdfStorage storage;
    const Bsdf& bsdf = prepared(*material, storage, Transport::kRadiance, {4, hero});
    CHECK(bsdf.dispersive());
    const auto s = bsdf.sample(wo, {0.99f, {}});
    REQUIRE(s);
    const double nm = WavelengthLattice().wavelength_nm(hero, 4);
    const double n = 1.8 + (nm - 380.0) / 400.0 * (1.5 - 1.8);
    CHECK(double{s->wi.x} == Approx(-double{wo.x} / n).epsilon(1e-5));
    CHECK(double{s->wi.y} == Approx(-double{wo.y} / n).epsilon(1e-5));
    CHECK(double{s->relative_eta} == Approx(n).epsilon(1e-6));
    CHECK(s->dispersive);
    for (int i = 0; i < kLanes; ++i) CHECK((s->weight[i] > 0.0f) == (i == hero));
  }
}

TEST_CASE("refraction divides radiance, not importance, by the squared index", "[bsdf]") {
  for (const double alpha : {0.0, 0.3}) {
    const auto material =
        test::make_material("dielectric", with({{"interior", prism()}, {"alpha", alpha}}));
    BsdfStorage a, b;
    const Bsdf& radiance = prepared(*material, a, Transport::kRadiance);
    const Bsdf& importance = prepared(*material, b, Transport::kImportance);
    for (const float side : {1.0f, -1.0f}) {
      const Vec3 wo = normalize({0.2f, 0.1f, side});
      const BsdfNumbers u{0.99f, {0.3f, 0.4f}};
      const auto s = radiance.sample(wo, u), t = importance.sample(wo, u);
      REQUIRE((s && t));
      REQUIRE((s->lobes & lobe::kTransmit) != 0);
      const float eta = s->relative_eta;
      CHECK((eta > 1.0f) == (side > 0.0f));
      CHECK(s->weight[9] * eta * eta == Approx(t->weight[9]).epsilon(1e-5));
    }
  }
}

TEST_CASE("the lanes' densities of rough dispersive glass are those of their own heroes",
          "[bsdf]") {
  const auto material =
      test::make_material("dielectric", with({{"interior", prism()}, {"alpha", 0.2}}));
  const Vec3 wo = normalize({0.5f, 0.1f, 0.8f});
  for (const Vec3 wi : {normalize({-0.3f, -0.1f, -0.9f}), normalize({-0.4f, 0.0f, 0.9f})}) {
    BsdfStorage storage;
    const SampledSpectrum pdfs =
        prepared(*material, storage, Transport::kRadiance, {4, 0}).lane_pdfs(wo, wi);
    for (int hero = 0; hero < kLanes; ++hero) {
      BsdfStorage other;
      CHECK(
          pdfs[hero] ==
          Approx(prepared(*material, other, Transport::kRadiance, {4, hero}).evaluate(wo, wi).pdf));
    }
    CHECK(std::abs(pdfs[0] / pdfs[kLanes - 1] - 1.0f) > 1e-3f);
  }
}

TEST_CASE("a diffuse surface reflects its reflectance in every wavelength", "[bsdf]") {
  const auto material = test::make_material(
      "diffuse", with({{"reflectance", table_spectrum({380.0, 780.0}, {0.0, 1.0}, "ramp")}}));
  BsdfStorage storage;
  const auto s =
      prepared(*material, storage, Transport::kRadiance).sample({0, 0, 1}, {0, {0.2f, 0.9f}});
  REQUIRE(s);
  for (int i = 0; i < kLanes; ++i) {
    const double nm = WavelengthLattice().wavelength_nm(i, 4);
    CHECK(double{s->weight[i]} == Approx((nm - 380.0) / 400.0).margin(1e-6));
  }
}
