// The study of Fresnel models against computations of its own: complex amplitudes in double loops,
// closed forms, and CIEDE2000 of colours summed nanometre by nanometre.
#include "materials/fresnel_study/fresnel_study.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "materials/fresnel_study/fresnel_ranking.h"
#include "materials/index/index_catalogue.h"
#include "spectral/illuminant.h"
#include "spectral/support/error.h"
#include "tests/reference_fresnel.h"

using namespace karat;

namespace {

FresnelMaterialStudy study_of(const std::string& table, std::vector<std::string> models) {
  FresnelStudyOptions options;
  options.tables = {table};
  options.models = std::move(models);
  return study_fresnel_models(options).front();
}

double schlick(double n, double k, double c) {
  const double f0 = ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
  return f0 + (1 - f0) * std::pow(1 - c, 5);
}

// A model of one value at every angle and wavelength.
class Constant final : public FresnelModel {
 public:
  explicit Constant(float value) : value_(value) {}
  std::string description() const override { return "the same everywhere"; }
  std::string source() const override { return "a test"; }
  FresnelTables prepare(const LatticeIndex&) const override { return {}; }
  SampledSpectrum reflectance(const FresnelTables&, int, float) const override {
    return SampledSpectrum(value_);
  }
  Scalar evaluate(ComplexIndex, double) const override {
    return {std::nullopt, std::nullopt, double{value_}};
  }

 private:
  float value_;
};

}  // namespace

TEST_CASE("the usual grid has 81 wavelengths and 90 angles", "[fresnel_study]") {
  const FresnelGrid grid = usual_fresnel_grid();
  REQUIRE(grid.wavelengths_nm.size() == 81);
  REQUIRE(grid.angles_deg.size() == 90);
  CHECK(grid.wavelengths_nm[1] == 385.0);
  CHECK(grid.wavelengths_nm.back() == 780.0);
  CHECK(grid.angles_deg.back() == 89.0);
}

TEST_CASE("errors of Schlick on gold agree with complex amplitudes in double loops",
          "[fresnel_study]") {
  const FresnelMaterialStudy study = study_of("main/Au/Johnson", {"schlick"});
  const IndexTablePtr table = find_index_table("main/Au/Johnson");
  double largest = 0.0, absolute = 0.0, square = 0.0, sum = 0.0, at_nm = 0.0, at_deg = 0.0;
  for (int deg = 0; deg <= 89; ++deg) {
    for (int nm = 380; nm <= 780; nm += 5) {
      const auto [n, k] = table->at(nm);
      const double c = std::cos(reference::radians(deg));
      const double error = schlick(n, k, c) - reference::fresnel(n, k, c).unpolarised();
      absolute += std::abs(error), square += error * error, sum += error;
      if (std::abs(error) > largest) largest = std::abs(error), at_nm = nm, at_deg = deg;
    }
  }
  const FresnelErrors& error = study.models[0].error;
  // The kernel's rounding: a few units of the last place of floats below 1.
  CHECK(error.max_abs == Approx(largest).epsilon(0).margin(1e-6));
  CHECK(error.mean_abs == Approx(absolute / 7290).epsilon(0).margin(1e-6));
  CHECK(error.rms == Approx(std::sqrt(square / 7290)).epsilon(0).margin(1e-6));
  CHECK(error.mean_signed == Approx(sum / 7290).epsilon(0).margin(1e-6));
  CHECK(error.worst_nm == at_nm);
  CHECK(error.worst_deg == at_deg);
}

TEST_CASE("the reference is exact, polarised too", "[fresnel_study]") {
  const FresnelMaterialStudy study = study_of("main/Cu/Johnson", {"exact"});
  const IndexTablePtr table = find_index_table("main/Cu/Johnson");
  const FresnelGrid grid = usual_fresnel_grid();
  for (std::size_t i = 0; i < grid.size(); i += 7) {
    const auto [n, k] = table->at(grid.wavelengths_nm[i % 81]);
    const auto r = reference::fresnel(n, k, std::cos(reference::radians(grid.angles_deg[i / 81])));
    CHECK(study.exact.s[i] == Approx(r.s).epsilon(0).margin(1e-12));
    CHECK(study.exact.p[i] == Approx(r.p).epsilon(0).margin(1e-12));
    CHECK(study.exact.unpolarised[i] == Approx(r.unpolarised()).epsilon(0).margin(1e-12));
  }
  // What "exact" errs by is the rounding of the kernel.
  CHECK(study.models[0].error.max_abs < 1e-5);
  CHECK(study.models[0].colour_error.max < 1e-2);
}

TEST_CASE("the albedo of Schlick is (20 F0 + 1)/21", "[fresnel_study]") {
  const FresnelMaterialStudy study = study_of("main/Ag/Johnson", {"schlick"});
  const IndexTablePtr table = find_index_table("main/Ag/Johnson");
  for (std::size_t i = 0; i < 81; ++i) {
    const auto [n, k] = table->at(380.0 + 5.0 * static_cast<double>(i));
    const double f0 = schlick(n, k, 1.0);
    CHECK(study.models[0].curves.albedo[i] == Approx((20 * f0 + 1) / 21).epsilon(0).margin(1e-6));
  }
}

TEST_CASE("the albedo of exact agrees with a sum over fine steps", "[fresnel_study]") {
  const FresnelMaterialStudy study = study_of("main/Al/Rakic", {});
  const auto [n, k] = find_index_table("main/Al/Rakic")->at(550.0);
  double sum = 0.0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double c = (i + 0.5) / kSteps;
    sum += 2.0 * c * reference::fresnel(n, k, c).unpolarised() / kSteps;
  }
  CHECK(study.exact.albedo[34] == Approx(sum).epsilon(0).margin(1e-6));
}

TEST_CASE("colour errors are CIEDE2000 of sums over nanometres", "[fresnel_study]") {
  const FresnelMaterialStudy study = study_of("main/Au/Johnson", {"schlick"});
  const IndexTablePtr table = find_index_table("main/Au/Johnson");
  for (const int deg : {0, 45, 80, 89}) {
    const double c = std::cos(reference::radians(deg));
    const auto on_grid = [&](double nm, bool approximate) {
      const auto [n, k] = table->at(nm);
      return approximate ? schlick(n, k, c) : reference::fresnel(n, k, c).unpolarised();
    };
    const auto between = [&](bool approximate) {
      return [&, approximate](int nm) {
        const double below = nm == 780 ? 775.0 : nm - (nm - 380) % 5, t = (nm - below) / 5.0;
        return (1 - t) * on_grid(below, approximate) + t * on_grid(below + 5.0, approximate);
      };
    };
    const SpectrumPtr light = illuminant("D65");
    const Observer& eye = observer("cie1931");
    Xyz a{}, b{}, white{};
    for (int nm = 380; nm <= 780; ++nm) {
      for (int i = 0; i < 3; ++i) {
        const double s = (*light)(nm)*eye[i](nm);
        const auto x = static_cast<std::size_t>(i);
        a[x] += between(true)(nm) * s, b[x] += between(false)(nm) * s, white[x] += s;
      }
    }
    const double expected = delta_e_2000(lab_of_xyz(a, white), lab_of_xyz(b, white));
    CHECK(study.models[0].colour_error.delta_e[static_cast<std::size_t>(deg)] ==
          Approx(expected).epsilon(0).margin(1e-3));
  }
}

TEST_CASE("a model that is registered at run time is studied like any other", "[fresnel_study]") {
  auto& registry = Registry<FresnelModel>::instance();
  registry.add("constant of a test", std::make_unique<const Constant>(0.75f));
  const FresnelMaterialStudy study = study_of("main/Ag/Johnson", {"constant of a test", "exact"});
  registry.remove("constant of a test");
  const FresnelModelStudy& found = study.models[0];
  CHECK(found.model == "constant of a test");
  double largest = 0.0;
  for (const double r : study.exact.unpolarised) largest = std::max(largest, std::abs(0.75 - r));
  CHECK(found.error.max_abs == Approx(largest).epsilon(1e-12));
  CHECK(found.curves.albedo[0] == Approx(0.75).epsilon(1e-12));
  CHECK(found.curves.s.empty());
  // A grey at every angle: its colour has the white's chromaticity.
  const Xyz first = found.colours.per_angle.front();
  CHECK(first[1] == Approx(0.75).epsilon(1e-9));
}

TEST_CASE("a grid beyond a table is refused, naming both", "[fresnel_study]") {
  FresnelStudyOptions options;
  options.tables = {"main/Au/Johnson"};
  options.models = {"exact"};
  options.grid.wavelengths_nm = {100.0, 500.0};
  CHECK_THROWS_WITH(study_fresnel_models(options), Catch::Matchers::Contains("main/Au/Johnson") &&
                                                       Catch::Matchers::Contains("100"));
  options.grid = usual_fresnel_grid();
  options.models = {"schlik"};
  CHECK_THROWS_WITH(study_fresnel_models(options), Catch::Matchers::Contains("schlick"));
}

TEST_CASE("other measurements of a metal are compared with the one chosen", "[fresnel_study]") {
  const FresnelMaterialStudy study = study_of("main/Cu/Johnson", {"exact"});
  REQUIRE_FALSE(study.other_tables.empty());
  for (const auto& other : study.other_tables) {
    CHECK(other.table.starts_with("main/Cu/"));
    CHECK(other.table != "main/Cu/Johnson");
    CHECK(other.error.max_abs > 1e-4);
  }
}

TEST_CASE("the ranking finds the models that no other beats", "[fresnel_study]") {
  FresnelMaterialStudy material;
  material.table = constant_index({1.5, 0.0});
  const auto add = [&](const std::string& name, double delta_e) {
    FresnelModelStudy study;
    study.model = name;
    study.colour_error.mean = study.colour_error.max = delta_e;
    material.models.push_back(study);
  };
  add("exact", 0.0), add("cheap", 2.0), add("bad", 3.0), add("middle", 1.0);
  add("as cheap", 2.5), add("the same", 2.0 + 1e-9);
  const auto cost = [](const std::string& name, double relative) {
    return FresnelCost{name, {}, {relative, relative, relative}};
  };
  const auto ranks = rank_fresnel_models(
      {material}, {cost("exact", 1.0), cost("cheap", 0.2), cost("bad", 0.5), cost("middle", 0.4),
                   cost("as cheap", 0.1999), cost("the same", 0.2001)});
  REQUIRE(ranks.size() == 6);
  CHECK(ranks[0].efficient);
  CHECK(ranks[1].efficient);
  CHECK_FALSE(ranks[2].efficient);
  CHECK(ranks[3].efficient);
  CHECK_FALSE(ranks[4].efficient);  // a thousandth cheaper: nobody can measure that
  CHECK(ranks[5].efficient);
}
