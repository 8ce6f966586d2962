// Indices in scene files that are made from others: what they read, and what they say when wrong.
#include <catch2/catch.hpp>

#include "render/index_reader.h"
#include "render/scene_schema.h"
#include "spectral/spectrum_file.h"
#include "spectral/support/data_path.h"
#include "tests/scene_text.h"

namespace karat {
namespace {

using Catch::Matchers::Contains;

Json metal(const Json& nk) {
  Json scene = small_scene();
  scene["materials"]["clay"] = {{"type", "conductor"}, {"nk", nk}};
  return scene;
}

Json parsed(const char* nk) { return Json::parse(nk); }

// The table that a value gives, with what reading it collects.
struct Read {
  IndexTablePtr table;
  std::vector<std::string> warnings;
  std::vector<Provenance> tables;
};
Read read(const char* nk, RangePolicy policy = RangePolicy::kError) {
  Read result;
  const Json json = parsed(nk);
  const ReadContext context{"", kVisible, policy, "cie1931", &result.warnings, &result.tables};
  result.table = read_index(JsonValue(json, "test.json", "/nk"), context);
  return result;
}

bool same(ComplexIndex a, ComplexIndex b) {
  return std::abs(a.n - b.n) < 1e-12 && std::abs(a.k - b.k) < 1e-12;
}

TEST_CASE("alloys: by mass, volume and atom; parts in objects and lists", "[composed_index]") {
  // 0.75 / 19.3 against 0.25 / 10.5 of volume.
  const double gold = 0.75 / 19.3, silver = 0.25 / 10.5;
  const Read mass =
      read(R"({"alloy": {"main/Au/Johnson": 0.75, "main/Ag/Johnson": 0.25}, "by": "mass"})");
  const Json by_volume = {{"alloy",
                           {{"main/Au/Johnson", gold / (gold + silver)},
                            {"main/Ag/Johnson", silver / (gold + silver)}}},
                          {"by", "volume"}};
  const Read volume = read(by_volume.dump().c_str());
  CHECK(same(mass.table->at(500.0), volume.table->at(500.0)));
  const Read listed = read(R"({"alloy": [{"nk": "main/Au/Johnson", "fraction": 0.75},
                                         {"nk": "main/Ag/Johnson", "fraction": 0.25, "density": 10.5}],
                               "by": "mass", "model": "bruggeman"})");
  CHECK(same(mass.table->at(500.0), listed.table->at(500.0)));
  // Equal numbers of atoms: volumes as M / density.
  const Read atoms =
      read(R"({"alloy": {"main/Au/Johnson": 0.5, "main/Cu/Johnson": 0.5}, "by": "atom"})");
  const double gold_mass = 196.966570 / (196.966570 + 63.546);
  const Json by_mass = {
      {"alloy", {{"main/Au/Johnson", gold_mass}, {"main/Cu/Johnson", 1 - gold_mass}}},
      {"by", "mass"}};
  const Read masses = read(by_mass.dump().c_str());
  CHECK(same(atoms.table->at(500.0), masses.table->at(500.0)));
  // The image names the mixture and both tables.
  REQUIRE(mass.tables.size() == 3);
  CHECK(mass.tables[0].name == "main/Ag/Johnson");
  CHECK(mass.tables[1].name == "main/Au/Johnson");
  CHECK_THAT(mass.tables[2].name,
             Contains("alloy by mass (bruggeman)") && Contains("0.75 main/Au/Johnson"));
  CHECK_THAT(mass.tables[2].reference, Contains("Bruggeman") && Contains("densities"));
  CHECK(mass.warnings.empty());
}

TEST_CASE("presets: every one loads, covers the visible and names its source", "[composed_index]") {
  const auto names = data_names("alloys");
  CHECK(names.size() >= 9);
  for (const std::string& name : names) {
    INFO(name);
    const Read preset = read(Json({{"alloy", name}}).dump().c_str());
    CHECK(preset.table->range().covers(kVisible));
    CHECK_NOTHROW(on_lattice(*preset.table, WavelengthLattice()));
    CHECK_THAT(preset.tables[0].name, Contains("alloy " + name));
    CHECK(preset.tables[0].reference.size() > 20);
    CHECK(preset.tables.size() >= 2);
  }
  CHECK_THAT(load_error(metal({{"alloy", "yelow-gold-18k"}})),
             Contains("/materials/clay/nk/alloy") && Contains("did you mean \"yellow-gold-18k\""));
}

TEST_CASE("densities are in g/cm3: those in kg/m3 are refused", "[composed_index]") {
  const auto part = [](double density) {
    return Json(
        {{"alloy", {{{"nk", 1.5}, {"fraction", 1}, {"density", density}}}}, {"by", "mass"}});
  };
  CHECK_THAT(load_error(metal(part(8960))),
             Contains("/density: found 8960") && Contains("0.01 to 30"));
  CHECK_THAT(load_error(metal(part(0.001))), Contains("0.01 to 30"));
  CHECK_NOTHROW(load_scene_text(metal(part(22.59)).dump(), "test.json", ""));
}

TEST_CASE("alloys inside alloys, and of inline values", "[composed_index]") {
  const Read nested = read(R"({"alloy": [{"nk": {"alloy": "yellow-gold-18k"}, "fraction": 0.5},
                                         {"nk": {"eta": 1.5, "k": 2.0}, "fraction": 0.5}], "by": "volume", "model": "linear"})");
  const ComplexIndex gold = read(R"({"alloy": "yellow-gold-18k"})").table->at(600.0);
  const ComplexIndex mixed = nested.table->at(600.0);
  CHECK(2.0 * mixed.n * mixed.k == Approx(gold.n * gold.k + 3.0));
  CHECK(nested.tables.size() == 7);  // preset, Ag, Au, Cu, its mixture, inline, this mixture
}

TEST_CASE("between: compositions and temperatures", "[composed_index]") {
  const Read read_between = read(R"({"between": {"other/Au-Ag/Rioux-Au60Ag40": 0.6,
                                                 "other/Au-Ag/Rioux-Au50Ag50": 0.5}, "at": 0.525})");
  const ComplexIndex at = read_between.table->at(550.0);
  const ComplexIndex a = read(R"("other/Au-Ag/Rioux-Au50Ag50")").table->at(550.0);
  const ComplexIndex b = read(R"("other/Au-Ag/Rioux-Au60Ag40")").table->at(550.0);
  CHECK(at.n * at.k == Approx(0.75 * a.n * a.k + 0.25 * b.n * b.k));  // half of Im eps
  CHECK(read_between.tables.size() == 3);
  CHECK_NOTHROW(
      read(R"({"between": {"main/Ag/Ferrera-298K": 25, "main/Ag/Ferrera-600K": 327}, "at": 200})"));
}

TEST_CASE("formulas: Drude and Lorentz-Drude", "[composed_index]") {
  const Read drude = read(R"({"drude": {"plasma_eV": 9.03, "gamma_eV": 0.053}})");
  const Read lorentz = read(R"({"lorentz": {"plasma_eV": 9.03, "f0": 1, "gamma0_eV": 0.053,
                                "oscillators": [{"f": 0, "gamma_eV": 1, "omega_eV": 3}]}})");
  CHECK(same(drude.table->at(600.0), lorentz.table->at(600.0)));
  CHECK(drude.table->at(600.0).k == Approx(4.25).margin(0.05));
  REQUIRE(drude.tables.size() == 1);
  CHECK_THAT(drude.tables[0].name, Contains("drude /nk") && Contains("9.03"));
}

TEST_CASE("layers: a conductor takes them, nothing else does", "[composed_index]") {
  const Json titanium = parsed(R"({"substrate": "main/Ti/Johnson",
      "layers": [{"nk": "main/TiO2/Jolivet-amorphous", "thickness_nm": 45}]})");
  const Scene scene = load_scene_text(metal(titanium).dump(), "test.json", "");
  REQUIRE(scene.tables.size() == 3);
  CHECK(scene.tables[2].name == "45 nm main/TiO2/Jolivet-amorphous on main/Ti/Johnson");
  CHECK(scene.warnings.empty());
  // A stack on a stack is one stack.
  const Json two = {{"substrate", titanium}, {"layers", {{{"nk", 1.46}, {"thickness_nm", 90}}}}};
  CHECK_NOTHROW(load_scene_text(metal(two).dump(), "test.json", ""));

  SceneOverrides overrides;
  overrides.fresnel = "schlick";
  const Scene overridden = load_scene_text(metal(titanium).dump(), "test.json", "", overrides);
  REQUIRE(overridden.warnings.size() == 1);
  CHECK_THAT(overridden.warnings[0], Contains("schlick") && Contains("thin films"));
  Json approximated = metal(titanium);
  approximated["materials"]["clay"]["fresnel"] = "schlick";
  CHECK_THAT(load_error(approximated),
             Contains("/materials/clay") && Contains("allowed: \"exact\""));

  Json glass = small_scene();
  glass["materials"]["clay"] = {{"type", "dielectric"}, {"interior", titanium}};
  CHECK_THAT(load_error(glass), Contains("/materials/clay") && Contains("stack of films"));
  CHECK_THAT(
      load_error(metal({{"alloy", {{{"nk", titanium}, {"fraction", 1}}}}, {"by", "volume"}})),
      Contains("/nk/alloy/0/nk") && Contains("stack of films"));
  Json outside = metal("main/Au/Johnson");
  outside["materials"]["clay"]["exterior"] = titanium;
  CHECK_THAT(load_error(outside), Contains("stack of films"));
}

struct Bad {
  const char* nk;
  std::vector<std::string> expected;
};

TEST_CASE("bad indices: the message names place, finding and what is allowed", "[composed_index]") {
  const std::vector<Bad> rows{
      {R"({"aloy": "x"})", {"/nk/aloy", "did you mean \"alloy\""}},
      {R"({})", {"/nk", "alloy, between, drude, lorentz, layers, substrate"}},
      {R"([1])", {"/nk", "allowed: the name of a table"}},
      {R"({"alloy": 1})", {"/nk/alloy", "found 1"}},
      {R"({"alloy": {}, "by": "mass"})", {"/nk/alloy", "at least one part"}},
      {R"({"alloy": {"main/Au/Johnson": 1}})", {"/nk", "\"by\" is missing"}},
      {R"({"alloy": {"main/Au/Johnson": 1}, "by": "weight"})", {"/nk/by", "mass, volume"}},
      {R"({"alloy": {"main/Au/Johnson": 0.7, "main/Ag/Johnson": 0.2}, "by": "mass"})",
       {"/nk/alloy", "sum to 0.9, allowed: 1"}},
      {R"({"alloy": {"main/Au/Johnson": 75}, "by": "mass"})",
       {"main~1Au~1Johnson", "found 75", "0 to 1"}},
      {R"({"alloy": {"main/Au/Johnson": -1}, "by": "mass"})", {"main~1Au~1Johnson", "found -1"}},
      {R"({"alloy": {"main/Au/Johnson": "x"}, "by": "mass"})",
       {"main~1Au~1Johnson", "\"fraction\""}},
      {R"({"alloy": {"main/Au/Jonson": 1}, "by": "mass"})", {"main~1Au~1Jonson", "Johnson"}},
      {R"({"alloy": {"main/Au/Johnson": 1}, "by": "mass", "model": "brugeman"})",
       {"/nk/model", "did you mean \"bruggeman\""}},
      {R"({"alloy": {"main/Au/Johnson": 1}, "by": "mass", "host": "main/Au/Johnson"})",
       {"/nk/host", "no host"}},
      {R"({"alloy": {"main/Au/Johnson": 1}, "by": "mass", "model": "maxwell-garnett", "host": "x"})",
       {"/nk/host", "main/Au/Johnson"}},
      {R"({"alloy": {"main/TiN/Pfluger": 1}, "by": "mass"})", {"density", "main/TiN/Pfluger"}},
      {R"({"alloy": [{"nk": 1.5, "fraction": 1, "density": 2.5}], "by": "atom"})", {"molar mass"}},
      {R"({"alloy": [{"nk": 1.5, "fraction": 1, "density": 0}], "by": "mass"})",
       {"/0/density", "found 0"}},
      {R"({"alloy": [{"nk": 1.5}], "by": "volume"})", {"/nk/alloy/0", "\"fraction\" is missing"}},
      {R"({"alloy": [{"fraction": 1}], "by": "volume"})", {"/nk/alloy/0", "\"nk\" is missing"}},
      {R"({"alloy": {"main/Au/Johnson": 1}, "by": "mass", "at": 1})", {"/nk/at", "unknown key"}},
      {R"({"between": {"main/Au/Johnson": 1}, "at": 1})", {"/nk/between", "at least two"}},
      {R"({"between": {"main/Au/Johnson": 1, "main/Ag/Johnson": 1}, "at": 1})",
       {"two tables are given for 1"}},
      {R"({"between": {"main/Au/Johnson": 0, "main/Ag/Johnson": 1}, "at": 1.2})",
       {"/nk/at", "found 1.2", "0 to 1", "nothing is extrapolated"}},
      {R"({"between": {"main/Au/Johnson": 0, "main/Ag/Johnson": 1, "main/Cu/Jonson": 2}, "at": 0.2})",
       {"main~1Cu~1Jonson", "Johnson"}},
      {R"({"between": {"main/Au/Johnson": 0, "main/Ag/Johnson": 1}})", {"\"at\" is missing"}},
      {R"({"drude": {"plasma_eV": 9}})", {"/nk/drude", "\"gamma_eV\" is missing"}},
      {R"({"drude": {"plasma_eV": 0, "gamma_eV": 1}})", {"/nk/drude/plasma_eV", "above 0"}},
      {R"({"drude": {"plasma_ev": 9, "gamma_eV": 1}})", {"did you mean \"plasma_eV\""}},
      {R"({"lorentz": {"plasma_eV": 9, "oscillators": []}})", {"/nk/lorentz/oscillators", "1 to"}},
      {R"({"lorentz": {"plasma_eV": 9, "oscillators": [{"f": 1, "gamma_eV": 0, "omega_eV": 3}]}})",
       {"/oscillators/0/gamma_eV", "above 0"}},
      {R"({"lorentz": {"plasma_eV": 9, "gamma0_eV": 1, "oscillators": [{"f": 1, "gamma_eV": 1, "omega_eV": 3}]}})",
       {"\"f0\" is missing"}},
      {R"({"substrate": "main/Ti/Johnson"})", {"/nk", "\"layers\" is missing"}},
      {R"({"layers": [{"nk": 1.5, "thickness_nm": 60}]})", {"/nk", "\"substrate\" is missing"}},
      {R"({"substrate": "main/Ti/Johnson", "layers": []})", {"/nk/layers", "1 to"}},
      {R"({"substrate": "main/Ti/Johnson", "layers": [{"nk": 1.5, "thickness_nm": -1}]})",
       {"/nk/layers/0/thickness_nm", "found -1", "0 to 20000"}},
      {R"({"substrate": "main/Ti/Johnson", "layers": [{"nk": 1.5, "thickness_nm": 15000},
                                                      {"nk": 1.5, "thickness_nm": 15000}]})",
       {"/nk", "30000", "20000"}},
      {R"({"substrate": "main/Ti/Johnson", "layers": [{"nk": "main/TiO2/Devore-o", "thickness_nm": 50}]})",
       {"/nk/layers/0/nk", "430"}}};
  for (const Bad& row : rows) {
    const std::string message = load_error(metal(parsed(row.nk)));
    INFO(message);
    for (const std::string& part : row.expected) CHECK_THAT(message, Contains(part));
    CHECK_THAT(message, Contains("test.json: /materials/clay/nk"));
  }
}

TEST_CASE("ranges: the intersection, held ends only when asked for", "[composed_index]") {
  const char* alloy =
      R"({"alloy": {"main/Au/Johnson": 0.5, "main/Zn/Motulevich": 0.5}, "by": "volume"})";
  Json scene = metal(parsed(alloy));
  CHECK_THAT(load_error(scene), Contains("main~1Zn~1Motulevich") && Contains("covers"));
  const Read clamped = read(alloy, RangePolicy::kClamp);
  CHECK(clamped.warnings.size() == 2);  // of the part and of the whole
}

TEST_CASE("the schema accepts what loads, and refuses what does not", "[composed_index]") {
  for (
      const char* nk :
      {R"({"alloy": "rose-gold-18k"})",
       R"({"alloy": {"main/Au/Johnson": {"fraction": 1, "density": 19}}, "by": "mass"})",
       R"({"alloy": [{"nk": {"alloy": "rose-gold-18k"}, "fraction": 1}], "by": "volume"})",
       R"({"between": {"main/Ag/Ferrera-298K": 298, "main/Ag/Ferrera-600K": 600}, "at": 300})",
       R"({"drude": {"plasma_eV": 9, "gamma_eV": 0.05, "eps_inf": 4}})",
       R"({"substrate": {"alloy": "sterling-silver"}, "layers": [{"nk": {"eta": 2.9, "k": 0.4}, "thickness_nm": 30}]})"}) {
    INFO(nk);
    CHECK(schema_violation(metal(parsed(nk))) == "");
    CHECK_NOTHROW(load_scene_text(metal(parsed(nk)).dump(), "test.json", ""));
  }
  CHECK(schema_violation(metal(parsed(R"({"alloy": {"main/Au/Johnson": 2}, "by": "mass"})"))) !=
        "");
  CHECK(schema_violation(metal(parsed(R"({"substrate": 1.5, "layers": []})"))) != "");
  CHECK(schema_violation(metal(parsed(R"({"drude": {"plasma_eV": 9}})"))) != "");
}

}  // namespace
}  // namespace karat
