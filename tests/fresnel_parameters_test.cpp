// Free parameters of Fresnel models in scenes and on the command line, and a model that registers
// itself while the program runs.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "materials/fresnel_choice.h"
#include "tests/run_cli.h"
#include "tests/scene_text.h"
#include "tests/temporary_folder.h"

using namespace karat;
using Catch::Matchers::Contains;
using test::karat_run;
using test::Outcome;

namespace {

namespace fs = std::filesystem;

using Workplace = test::TemporaryFolder;

nlohmann::json scene_with(const nlohmann::json& fresnel) {
  nlohmann::json scene = small_scene();
  scene["materials"]["clay"] = {
      {"type", "conductor"}, {"nk", "main/Au/Johnson"}, {"fresnel", fresnel}};
  return scene;
}

// The reflectance of the scene's one material at an angle, hero wavelengths of a phase.
SampledSpectrum reflected(const nlohmann::json& scene, float cos_theta) {
  const Scene loaded = load_scene_text(scene.dump(), "test.json", "");
  BsdfStorage storage;
  const Bsdf& bsdf = *loaded.materials[0]->prepare({}, {3, 0}, Transport::kRadiance, storage);
  const Vec3 wo{std::sqrt(1.0f - cos_theta * cos_theta), 0.0f, cos_theta};
  return bsdf.sample(wo, {0.5f, {0.5f, 0.5f}})->weight;
}

// Reflects half of what Schlick's approximation does, at any material.
class HalfFresnel final : public FresnelModel {
 public:
  std::string description() const override { return "half"; }
  std::string source() const override { return "this test"; }
  FresnelTables prepare(const LatticeIndex&) const override { return {}; }
  SampledSpectrum reflectance(const FresnelTables&, int, float cos_theta) const override {
    return SampledSpectrum(0.5f * cos_theta);
  }
  Scalar evaluate(ComplexIndex, double cos_theta) const override {
    return {std::nullopt, std::nullopt, 0.5 * cos_theta};
  }
};

}  // namespace

TEST_CASE("a conductor takes a model's parameters from its scene", "[fresnel]") {
  const nlohmann::json stated = {{"model", "schlick-exponent"},
                                 {"parameters", {{"exponent", 3.0}, {"f90", 0.9}}}};
  const SampledSpectrum f0 = reflected(scene_with("schlick"), 1.0f);
  const SampledSpectrum r = reflected(scene_with(stated), 0.2f);
  for (int i = 0; i < kLanes; ++i) {
    const double expected = double{f0[i]} + (0.9 - double{f0[i]}) * std::pow(0.8, 3.0);
    CHECK(double{r[i]} == Approx(expected).margin(1e-6));
  }
  // By name alone, and with an empty list, the model chooses.
  const SampledSpectrum chosen = reflected(scene_with("schlick-exponent"), 0.2f);
  const SampledSpectrum same = reflected(scene_with({{"model", "schlick-exponent"}}), 0.2f);
  CHECK(chosen.lane == same.lane);
  CHECK(chosen[0] != r[0]);
  const nlohmann::json table = {{"table", {{380, 2.0}, {780, 8.0}}}};
  const SampledSpectrum varying =
      reflected(scene_with({{"model", "schlick-exponent"},
                            {"parameters", {{"exponent", table}, {"f90", 1}}}}),
                0.2f);
  const double nm = WavelengthLattice().wavelength_nm(7, 3);
  const double exponent = 2.0 + 6.0 * (nm - 380.0) / 400.0;
  CHECK(double{varying[7]} ==
        Approx(double{f0[7]} + (1.0 - double{f0[7]}) * std::pow(0.8, exponent)).margin(1e-6));
}

TEST_CASE("wrong parameters of a model are errors that say what is allowed", "[fresnel]") {
  const auto error = [](const nlohmann::json& parameters, const char* model = "schlick-exponent") {
    return load_error(scene_with({{"model", model}, {"parameters", parameters}}));
  };
  CHECK_THAT(error({{"exponent", 3}}), Contains("f90") && Contains("missing"));
  CHECK_THAT(error({{"exponnt", 3}, {"f90", 1}}), Contains("did you mean \"exponent\""));
  CHECK_THAT(error({{"exponent", 300}, {"f90", 1}}), Contains("found 300") && Contains("1 to 100"));
  CHECK_THAT(error({{"f", 3}}, "schlick"), Contains("no free parameters"));
  CHECK_THAT(error({{"a", {{"table", {{380, 0.1}, {780, 0.2}}}}}, {"alpha", 5}},
                   "lazanyi-compensated-metal"),
             Contains("one number"));
  CHECK_THAT(load_error(scene_with({{"model", "shlick"}})), Contains("did you mean \"schlick\""));
  CHECK_THAT(load_error(scene_with({{"modle", "schlick"}})), Contains("modle"));
}

TEST_CASE("--fresnel with another model drops stated parameters, and says so", "[fresnel]") {
  SceneOverrides overrides;
  overrides.fresnel = "schlick";
  const auto scene = scene_with(
      {{"model", "schlick-exponent"}, {"parameters", {{"exponent", 3.0}, {"f90", 0.9}}}});
  const Scene loaded = load_scene_text(scene.dump(), "test.json", "", overrides);
  CHECK(loaded.fresnel == "schlick");
  REQUIRE(loaded.warnings.size() == 1);
  CHECK_THAT(loaded.warnings[0], Contains("schlick-exponent") && Contains("--fresnel"));
}

TEST_CASE("karat fresnel fit writes what it finds into a scene that renders", "[fresnel]") {
  const Workplace work;
  std::ofstream(work.file("in.json")) << scene_with("exact").dump();
  const std::string out = work.file("out.json");
  CHECK(karat_run({"fresnel", "fit", "main/Au/Johnson", "--model", "hoffman-f82", "--nm",
                   "380:780:20", "--scene", work.file("in.json"), "-o", out})
            .code == 0);
  std::ifstream in(out);
  const nlohmann::json scene = nlohmann::json::parse(in);
  const auto& fresnel = scene["materials"]["clay"]["fresnel"];
  CHECK(fresnel["model"] == "hoffman-f82");
  CHECK(fresnel["parameters"]["f82"]["table"].size() == 21);
  const SampledSpectrum r = reflected(scene, 0.3f), exact = reflected(scene_with("exact"), 0.3f);
  for (int i = 0; i < kLanes; ++i) CHECK(std::abs(r[i] - exact[i]) <= 0.03f);

  const auto printed = nlohmann::json::parse(
      karat_run({"fresnel", "fit", "main/Au/Johnson", "--model", "lazanyi-compensated", "--nm",
                 "450,550", "--over-range", "--json"})
          .out);
  CHECK(printed["per_wavelength"] == false);
  REQUIRE(printed["fits"].size() == 1);
  CHECK(printed["fits"][0]["values"].contains("alpha"));
  CHECK(printed["max_abs_error"] >= printed["rms_error"]);
}

TEST_CASE("a scene that a fit does not suit is refused before the fit is printed", "[fresnel]") {
  const Workplace work;
  nlohmann::json scene = scene_with("exact");
  auto& materials = scene["materials"];
  materials["copper"] = {{"type", "conductor"}, {"nk", "main/Cu/Johnson"}};
  materials["wet"] = {{"type", "conductor"}, {"nk", "main/Ag/Johnson"}, {"exterior", 1.33}};
  materials["mix"] = {{"type", "conductor"}, {"nk", {{"eta", 0.2}, {"k", 3.0}}}};
  std::ofstream(work.file("in.json")) << scene.dump();
  const std::string out = work.file("out.json");
  const auto fit = [&](const std::string& page, std::vector<std::string> more) {
    std::vector<std::string> all{
        "fresnel", "fit", page, "--model", "hoffman-f82", "--scene", work.file("in.json"),
        "-o",      out};
    all.insert(all.end(), more.begin(), more.end());
    return karat_run(all);
  };
  const auto refused = [&](const std::string& page, const std::vector<std::string>& more,
                           const auto& message) {
    const Outcome outcome = fit(page, more);
    CHECK(outcome.code == 3);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.err, message);
    CHECK_FALSE(fs::exists(out));
  };
  refused("main/Au/Johnson", {"--nm", "400:700:10"},
          Contains("400 to 700 nm") && Contains("380 to 780 nm") && Contains("--nm"));
  refused("main/Au/Johnson", {"--nm", "550"}, Contains("550 nm") && Contains("--over-range"));
  refused("main/Ag/Johnson", {"--material", "copper"},
          Contains("main/Cu/Johnson") && Contains("main/Ag/Johnson"));
  refused("main/Ag/Johnson", {}, Contains("n = 1.33") && Contains("--n-exterior 1"));
  refused("main/Au/Johnson", {"--n-exterior", "1.5"}, Contains("n = 1") && Contains("1.5"));
  refused("main/Al/Rakic", {}, Contains("no conductor") && Contains("copper"));
  refused("main/Au/Johnson", {"--material", "cly"}, Contains("did you mean \"clay\""));

  CHECK(fit("Au/Johnson", {}).code == 0);  // the scene says main/Au/Johnson
  CHECK(load_scene(out).warnings.empty());
  CHECK(fit("Ag/Johnson", {"--n-exterior", "1.33"}).code == 0);
  CHECK(fit("Au/Johnson", {"--nm", "550", "--over-range"}).code == 0);
  load_scene(out);
  const Outcome mixed = fit("Ag/Johnson", {"--material", "mix"});
  CHECK(mixed.code == 0);
  CHECK_THAT(mixed.err, Contains("warning") && Contains("\"mix\"") && Contains("main/Ag/Johnson"));
}

TEST_CASE("a fit says once and at once that its file cannot be written", "[fresnel]") {
  const Workplace work;
  std::ofstream(work.file("in.json")) << scene_with("exact").dump();
  const Outcome outcome = karat_run({"fresnel", "fit", "main/Au/Johnson", "--model", "hoffman-f82",
                                     "--scene", work.file("in.json"), "-o", "/proc/x.json"});
  CHECK(outcome.code == 1);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.find("cannot write") == outcome.err.rfind("cannot write"));
  CHECK_THAT(outcome.err, Contains("no permission"));
}

TEST_CASE("names given twice and steps that miss the last wavelength are refused", "[fresnel]") {
  const Workplace work;
  std::ofstream(work.file("angles.csv")) << "n,k,theta_deg\n0.4,2.4,60\n";
  const Outcome fitted =
      karat_run({"fresnel", "fit", "main/Au/Johnson", "--model", "schlick-exponent", "--nm", "550",
                 "--fix", "f90=1", "--fix", "f90=0.9"});
  CHECK(fitted.code == 3);
  CHECK_THAT(fitted.err, Contains("f90") && Contains("twice"));
  const Outcome evaluated =
      karat_run({"fresnel", "eval", "--model", "schlick-exponent", "--set", "f90=1", "--set",
                 "exponent=5", "--set", "f90=0.5", work.file("angles.csv")});
  CHECK(evaluated.code == 3);
  CHECK_THAT(evaluated.err, Contains("f90") && Contains("twice"));

  const auto fit = [](const std::string& nm, const std::string& name = "schlick-exponent") {
    return karat_run({"fresnel", "fit", "main/Au/Johnson", "--model", name, "--nm", nm, "--json"});
  };
  for (const char* nm : {"380:780:500", "450,", ",450", "450,red", "0", "nan", "550:450:10", ""}) {
    CAPTURE(nm);
    CHECK(fit(nm).code == 2);
  }
  CHECK_THAT(fit("380:780:500").err, Contains("do not meet the last"));
  CHECK(nlohmann::json::parse(fit("650,450,550").out)["wavelengths_nm"] ==
        nlohmann::json({450.0, 550.0, 650.0}));
  CHECK(fit("550", "table").code == 2);
  CHECK_THAT(fit("550", "table").err, Contains("no parameters to fit") && Contains("gulbrandsen"));
}

TEST_CASE("fresnel eval takes metals without loss, which reflect all, and refuses what overflows",
          "[fresnel]") {
  const Workplace work;
  std::ofstream(work.file("lossless.csv")) << "n,k,theta_deg,n_exterior\n0,3,0,1\n0,3,45,1.5\n";
  std::ofstream(work.file("overflow.csv")) << "n,k,theta_deg\n1,1e300,10\n";
  for (const std::string& name : Registry<FresnelModel>::instance().names()) {
    CAPTURE(name);
    const Outcome lossless = karat_run(
        {"fresnel", "eval", "--model", name, "--precision", "double", work.file("lossless.csv")});
    REQUIRE(lossless.code == 0);
    std::istringstream lines(lossless.out);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      // cook-torrance-n would need an infinite index: its largest, 3e4, loses 1.4e-4.
      CHECK(std::stod(line.substr(line.rfind(',') + 1)) == Approx(1.0).margin(2e-4));
    }
    CHECK(karat_run({"fresnel", "eval", "--model", name, work.file("overflow.csv")}).code == 3);
  }
}

TEST_CASE("a model that is one new class is listed, evaluated and rendered at once", "[fresnel]") {
  auto& models = Registry<FresnelModel>::instance();
  models.add("test-half", std::make_unique<const HalfFresnel>());
  const Workplace work;
  std::ofstream(work.file("angles.csv")) << "n,k,theta_deg\n0.4,2.4,60\n";
  const Outcome listed = karat_run({"fresnel", "list"});
  const Outcome evaluated =
      karat_run({"fresnel", "eval", "--model", "test-half", work.file("angles.csv")});
  const SampledSpectrum r = reflected(scene_with("test-half"), 0.5f);
  models.remove("test-half");
  CHECK_THAT(listed.out, Contains("test-half\n    half\n    this test"));
  CHECK(evaluated.code == 0);
  CHECK_THAT(evaluated.out, Contains("0.4,2.4,60,,,0.25"));
  CHECK(r[0] == 0.25f);
}
