#include "render/scene_loader.h"

#include <catch2/catch.hpp>
#include <fstream>

#include "render/scene_json.h"
#include "render/scene_schema.h"
#include "spectral/support/data_path.h"
#include "tests/scene_text.h"

namespace karat {
namespace {

using Catch::Matchers::Contains;

Scene load(const Json& scene, const SceneOverrides& overrides = {}) {
  return load_scene_text(scene.dump(), "test.json", "", overrides);
}

Json changed(const std::string& pointer, const Json& value) {
  Json scene = small_scene();
  scene[Json::json_pointer(pointer)] = value;
  return scene;
}

TEST_CASE("a small scene loads with its values and the defaults of the rest", "[scene_loader]") {
  const Scene scene = load(small_scene());
  CHECK(scene.settings.width == 8);
  CHECK(scene.settings.height == 6);
  CHECK(scene.settings.crop.x1 == 8);
  CHECK(scene.settings.spp == 4);
  CHECK(scene.settings.white == "D65");
  CHECK(scene.settings.observer == "cie1931");
  CHECK(scene.lattice.range().min_nm == 380.0);
  CHECK(scene.camera != nullptr);
  CHECK(scene.materials.size() == 1);
  CHECK(scene.lights.size() == 1);
  CHECK(scene.environments.size() == 1);
  CHECK(scene.warnings.empty());
  SurfaceHit hit;
  REQUIRE(scene.world.intersect({{0, -5, 0}, {0, 1, 0}}, hit));
  CHECK(hit.distance == Approx(4.0f));
}

TEST_CASE("transforms apply their operations in order", "[scene_loader]") {
  const Json moved_then_scaled = Json::array({{{"translate", {1, 0, 0}}}, {{"scale", 2}}});
  const Scene scene = load(changed("/shapes/0/transform", moved_then_scaled));
  SurfaceHit hit;
  REQUIRE(scene.world.intersect({{2, -5, 0}, {0, 1, 0}}, hit));
  CHECK(hit.distance == Approx(3.0f));  // radius 2 around x = 2
}

TEST_CASE("text that is not JSON: the place is named", "[scene_loader]") {
  CHECK_THAT(load_error(std::string("{\n  \"film\": {,}\n}")),
             Contains("test.json") && Contains("line 2, column 12"));
  CHECK_THAT(load_error(std::string("")), Contains("the file is empty"));
  CHECK_THAT(load_error(std::string("{\"film\": {}} x")), Contains("after the last bracket"));
  CHECK_THAT(load_error(std::string("{\"a\": 1e999}")), Contains("test.json"));
  CHECK_THAT(load_error(std::string("{\"film\": {\"width\": 1, \"width\": 2}}")),
             Contains("/film") && Contains("\"width\"") && Contains("twice"));
  CHECK_THAT(load_error(std::string(1000, '[')), Contains("nested deeper than 64"));
  CHECK_THAT(load_error(std::string("[1, 2]")), Contains("found [1,2], allowed: an object"));
}

TEST_CASE("a missing file, a folder: said so", "[scene_loader]") {
  CHECK_THROWS_WITH(load_scene("/nowhere/scene.json"),
                    Contains("/nowhere/scene.json") && Contains("no such file"));
  CHECK_THROWS_WITH(load_scene("/tmp"), Contains("is a folder"));
}

// Each row: where, what is put there, what the message must hold beside the file and the place.
struct BadValue {
  std::string pointer;
  Json value;
  std::vector<std::string> expected;
};

TEST_CASE("bad values: the message names place, finding and what is allowed", "[scene_loader]") {
  const std::vector<BadValue> rows{
      {"/film/width", 0, {"found 0", "allowed: 1 to 65536"}},
      {"/film/width", 65537, {"found 65537", "65536"}},
      {"/film/width", 2.5, {"found 2.5", "whole number"}},
      {"/film/width", "wide", {"found \"wide\"", "number"}},
      {"/film/heigth", 5, {"unknown key \"heigth\"", "\"height\" is there already"}},
      {"/film/crop", {0, 0, 9, 6}, {"[0, 0, 9, 6]", "x1 <= 8"}},
      {"/film/crop", {0, 0, 0, 6}, {"x0 < x1"}},
      {"/sampling/spp", 0, {"found 0", "1 to 16777216"}},
      {"/sampling/seed", -1, {"found -1"}},
      {"/sampling/sampler", "sobel", {"did you mean \"sobol\""}},
      {"/integrator", {{"type", "pth"}}, {"did you mean \"path\""}},
      {"/integrator", {{"max_depth", -1}}, {"found -1"}},
      {"/observer", "cie1932", {"cie1931"}},
      {"/white", "D66", {"D65"}},
      {"/white", 10, {"found 10", "500 to 100000"}},
      {"/wavelengths", {{"min", 700}, {"max", 400}}, {"700 to 400 nm"}},
      {"/extrapolate", "maybe", {"error, clamp"}},
      {"/camera/type", "perspectiv", {"did you mean \"perspective\""}},
      {"/camera/fov_deg", 200, {"found 200", "above 0, at most 179"}},
      {"/camera/position", {1, 2}, {"found [1,2]", "3 numbers"}},
      {"/materials/clay/type", "conducter", {"did you mean \"conductor\""}},
      {"/materials/clay/reflectance", -0.3, {"found -0.3", "0 to 1"}},
      {"/materials/clay/reflectance", {{"rgb", {0.1, 0.2, 1.5}}}, {"found 1.5", "0 to 1"}},
      {"/materials/clay/reflectance", {{"table", {{400, 0.1}, {390, 0.2}}}}, {"must increase"}},
      {"/materials/clay/reflectance",
       {{"table", {{400, 0.1}, {700, 0.2}}}},
       {"400 to 700 nm", "380 to 780 nm", "clamp"}},
      {"/materials/clay/reflectance",
       {{"rgb", {1, 1, 1}}, {"table", Json::array()}},
       {"exclude each other"}},
      {"/materials/clay/reflectance", {{"file", "nowhere.spd"}}, {"no such file", "nowhere.spd"}},
      {"/materials/clay/alpha", 0.5, {"unknown key \"alpha\""}},
      {"/shapes/0/material", "cley", {"did you mean \"clay\""}},
      {"/shapes/0/type", "spere", {"did you mean \"sphere\""}},
      {"/shapes/0/radius", -1, {"found -1", "above 0"}},
      {"/shapes/0/radius", 1e300, {"found 1e+300"}},
      {"/shapes/0/two_sided", true, {"emission"}},
      {"/shapes/0/emission", "bright", {"found \"bright\"", "blackbody"}},
      {"/shapes/0/emission", {{"blackbody", 0}}, {"found 0", "100 to"}},
      {"/shapes/0/emission", {{"illuminant", "D66"}}, {"D65"}},
      {"/shapes/0/emission", {{"scale", 2}}, {"one of: rgb, illuminant, blackbody"}},
      {"/shapes/0/emission",
       {{"illuminant", "E"}, {"scale", 1}, {"luminance", 1}},
       {"exclude each other"}},
      {"/shapes/0/transform", {{{"scale", 0}}}, {"no inverse"}},
      {"/shapes/0/transform",
       {{{"rotate", {{"axis", {0, 0, 0}}, {"angle_deg", 9}}}}},
       {"not zero"}},
      {"/shapes/0/transform", {{{"spin", 5}}}, {"unknown key \"spin\""}},
      {"/shapes/0/transform", {{{"matrix", {1, 2, 3}}}}, {"12 or 16 numbers"}},
      {"/lights/0/radiance", -1, {"found -1"}},
      {"/lihgts", Json::array(), {"unknown key \"lihgts\"", "\"lights\" is there already"}}};
  for (const BadValue& row : rows) {
    const std::string message = load_error(changed(row.pointer, row.value));
    INFO(row.pointer << " = " << row.value << ": " << message);
    CHECK_THAT(message, Catch::StartsWith("test.json: /" + row.pointer.substr(1, 3)));
    for (const auto& part : row.expected) CHECK_THAT(message, Contains(part));
  }
}

TEST_CASE("what must be there: its absence is named", "[scene_loader]") {
  Json scene = small_scene();
  scene.erase("camera");
  CHECK_THAT(load_error(scene), Contains("\"camera\" is missing"));
  scene = small_scene();
  scene["shapes"][0].erase("material");
  CHECK_THAT(load_error(scene), Contains("/shapes/0") && Contains("\"material\" is missing"));
  scene = small_scene();
  scene["materials"]["clay"].erase("type");
  CHECK_THAT(load_error(scene), Contains("/materials/clay") && Contains("\"type\" is missing"));
  scene["materials"]["clay"] = {{"type", "conductor"}};
  CHECK_THAT(load_error(scene), Contains("/materials/clay") && Contains("\"nk\" is missing"));
}

TEST_CASE("index tables: unknown names, ranges and inline values", "[scene_loader]") {
  const auto metal = [](const Json& nk) {
    return changed("/materials/clay", {{"type", "conductor"}, {"nk", nk}});
  };
  CHECK_THAT(load_error(metal("main/Au/Jonson")),
             Contains("/materials/clay/nk") && Contains("Johnson"));
  CHECK_THAT(load_error(metal(-1)), Contains("found -1"));
  CHECK_THAT(load_error(metal({{"eta", 1.0}, {"k", -1.0}})), Contains("/nk/k") && Contains("-1"));
  CHECK_THAT(load_error(metal({{"k", 1.0}})), Contains("\"eta\" is missing"));

  Json far = metal("main/Au/Johnson");
  far["wavelengths"] = {{"min", 380}, {"max", 5000}};
  CHECK_THAT(load_error(far), Contains("main/Au/Johnson") && Contains("5000"));
  far["extrapolate"] = "clamp";
  const Scene clamped = load(far);
  REQUIRE(clamped.warnings.size() == 1);
  CHECK_THAT(clamped.warnings[0], Contains("main/Au/Johnson"));

  const Scene gold = load(metal("main/Au/Johnson"));
  REQUIRE(gold.tables.size() == 1);
  CHECK(gold.tables[0].name == "main/Au/Johnson");
  CHECK_FALSE(gold.tables[0].reference.empty());
  CHECK(gold.fresnel == "exact");
  CHECK_NOTHROW(load(metal({{"eta", {{"table", {{380, 0.2}, {780, 0.3}}}}}, {"k", 3.0}})));
}

TEST_CASE("--fresnel changes every conductor, and only to a known model", "[scene_loader]") {
  const Json scene = changed("/materials/clay", {{"type", "conductor"}, {"nk", "main/Au/Johnson"}});
  SceneOverrides overrides;
  overrides.fresnel = "schlick";
  CHECK(load(scene, overrides).fresnel == "schlick");
  overrides.fresnel = "schlik";
  CHECK_THAT(load_error(scene, overrides), Contains("did you mean \"schlick\""));
}

TEST_CASE("scenes that must come out black: a warning says why", "[scene_loader]") {
  Json scene = small_scene();
  scene.erase("lights");
  REQUIRE(load(scene).warnings.size() == 1);
  CHECK_THAT(load(scene).warnings[0], Contains("black") && Contains("no \"lights\""));

  scene["lights"] = {{{"type", "point"}, {"position", {0, -5, 5}}}};
  CHECK(load(scene).warnings.empty());
  scene["materials"]["clay"] = {{"type", "mirror"}};
  REQUIRE(load(scene).warnings.size() == 1);
  CHECK_THAT(load(scene).warnings[0], Contains("black") && Contains("perfectly smooth"));
}

TEST_CASE("a mesh file without triangles or that is not there: an error", "[scene_loader]") {
  const std::string path = "/tmp/karat_scene_test_empty.obj";
  std::ofstream(path) << "v 0 0 0\nv 1 0 0\n";
  const Json mesh = {{"type", "mesh"}, {"material", "clay"}, {"file", path}};
  CHECK_THAT(load_error(changed("/shapes/0", mesh)), Contains("/shapes/0") && Contains(path));
  std::remove(path.c_str());
  CHECK_THAT(load_error(changed("/shapes/0", mesh)), Contains("no such file"));
}

TEST_CASE("groups are placed by instances and cannot emit", "[scene_loader]") {
  Json scene = small_scene();
  scene["shapes"] = Json::array();
  scene["groups"] = {{"pair", {{{"type", "sphere"}, {"material", "clay"}}}}};
  scene["instances"] = {{{"group", "pair"}, {"transform", {{{"translate", {3, 0, 0}}}}}}};
  const Scene loaded = load(scene);
  SurfaceHit hit;
  CHECK_FALSE(loaded.world.intersect({{0, -5, 0}, {0, 1, 0}}, hit));
  CHECK(loaded.world.intersect({{3, -5, 0}, {0, 1, 0}}, hit));
  scene["instances"][0]["group"] = "pear";
  CHECK_THAT(load_error(scene), Contains("/instances/0/group") && Contains("Known: pair."));
  scene["groups"]["pair"][0]["emission"] = 1;
  scene["instances"][0]["group"] = "pair";
  CHECK_THAT(load_error(scene), Contains("/groups/pair/0/emission") && Contains("cannot emit"));
}

TEST_CASE("-D sets what the schema knows and nothing else", "[scene_loader]") {
  const auto with = [](const std::string& path, const std::string& value) {
    SceneOverrides overrides;
    overrides.values = {{path, value}};
    return overrides;
  };
  CHECK(load(small_scene(), with("film.width", "16")).settings.width == 16);
  CHECK(load(small_scene(), with("/film/width", "16")).settings.width == 16);
  CHECK(load(small_scene(), with("white", "E")).settings.white == "E");
  CHECK(load(small_scene(), with("integrator.max_depth", "3")).settings.max_depth == 3);
  CHECK_NOTHROW(load(small_scene(), with("shapes.0.radius", "2")));
  CHECK_THAT(load_error(small_scene(), with("film.widht", "16")),
             Contains("-D film.widht") && Contains("did you mean \"width\""));
  CHECK_THAT(load_error(small_scene(), with("materials.cley.reflectance", "1")),
             Contains("did you mean \"clay\""));
  CHECK_THAT(load_error(small_scene(), with("shapes.1.radius", "1")), Contains("no element 1 yet"));
}

SceneOverrides defined(const std::vector<std::pair<std::string, std::string>>& values) {
  SceneOverrides overrides;
  overrides.values = values;
  return overrides;
}

TEST_CASE("a bad value from -D is blamed on -D", "[scene_loader]") {
  const auto error = [](const std::string& path, const std::string& value) {
    return load_error(small_scene(), defined({{path, value}}));
  };
  CHECK_THAT(error("film.width", "many"), Catch::StartsWith("-D film.width: found \"many\""));
  CHECK_THAT(error("/film/width", "0"), Catch::StartsWith("-D /film/width: found 0"));
  CHECK_THAT(error("white", "D66"), Catch::StartsWith("-D white: ") && Contains("D65"));
  CHECK_THAT(error("film.crop", "[0,0,9,9]"), Catch::StartsWith("-D film.crop: found [0, 0, 9"));
  CHECK_THAT(error("shapes.1", R"({"type": "sphere", "material": "cley"})"),
             Catch::StartsWith("-D shapes.1: /shapes/1/material: ") && Contains("clay"));
  CHECK_THAT(error("shapes.0.two_sided", "1"), Catch::StartsWith("-D shapes.0.two_sided: "));
  CHECK_THAT(error("camera.look_at", "[0,-5,0]"),
             Catch::StartsWith("test.json: /camera: ") && Contains("(after -D camera.look_at)"));
  CHECK_THAT(error("film", "{\"width\": 1,}"),
             Catch::StartsWith("-D film: line 1, column 12: a comma before"));
  // The file's own mistakes stay the file's.
  Json scene = small_scene();
  scene["film"]["height"] = 0;
  CHECK_THAT(load_error(scene, defined({{"film.width", "9"}})),
             Catch::StartsWith("test.json: /film/height"));
}

TEST_CASE("-D appends to lists and removes what need not be there", "[scene_loader]") {
  const std::string sphere = R"({"type": "sphere", "material": "clay"})";
  const Scene two = load(small_scene(), defined({{"shapes.1", sphere}, {"shapes.1.radius", "3"}}));
  SurfaceHit hit;
  REQUIRE(two.world.intersect({{0, -5, 0}, {0, 1, 0}}, hit));
  CHECK(hit.distance == Approx(2.0f));
  CHECK_THAT(load_error(small_scene(), defined({{"shapes.2", sphere}})), Contains("1 to append"));
  CHECK_THAT(load_error(small_scene(), defined({{"shapes.1.radius", "2"}})),
             Contains("no element 1 yet"));
  Json dark = small_scene();
  dark.erase("lights");
  CHECK(load(dark, defined({{"lights.0", R"({"type": "constant"})"}})).lights.size() == 1);

  Json bigger = changed("/shapes/0/radius", 2);
  REQUIRE(load(bigger, defined({{"shapes.0.radius", "null"}}))
              .world.intersect({{0, -5, 0}, {0, 1, 0}}, hit));
  CHECK(hit.distance == Approx(4.0f));  // the default radius, 1
  CHECK_THAT(load_error(small_scene(), defined({{"camera.look_at", "null"}})),
             Contains("\"look_at\" must be there"));
  CHECK_THAT(load_error(small_scene(), defined({{"shapes.0", "null"}})),
             Contains("not an element of a list"));
}

TEST_CASE("unknown keys of -D: only those of the type at hand are listed", "[scene_loader]") {
  const std::string message = load_error(small_scene(), defined({{"shapes.0.size", "2"}}));
  CHECK_THAT(message, Contains("unknown key \"size\"") && Contains("radius") &&
                          !Contains("did you mean") && !Contains("inner_radius"));
  CHECK_NOTHROW(
      load(small_scene(), defined({{"shapes.0.major_radius", "2"}, {"shapes.0.type", "torus"}})));
}

TEST_CASE("a suggestion is not a key that is there already", "[scene_loader]") {
  CHECK_THAT(load_error(changed("/camera/look_att", 1)),
             !Contains("did you mean") && Contains("\"look_at\" is there already"));
  CHECK_THAT(load_error(changed("/camera/fov", 30)),
             Contains("did you mean \"fov_deg\" or \"fov_axis\"?"));
}

TEST_CASE("looking along z: y is up unless something was given", "[scene_loader]") {
  Json scene = changed("/camera/position", {0, 0, 5});
  CHECK_NOTHROW(load(scene));
  scene["camera"]["up"] = {0, 0, 1};
  CHECK_THAT(load_error(scene), Contains("up: found [0, 0, 1]") && Contains("as [0, 1, 0]"));
  scene["camera"]["up"] = {0, 0, 0};
  CHECK_THAT(load_error(scene), Contains("up: found [0, 0, 0]") && Contains("not zero"));
  const auto placed = [](const Json& look_at) {
    return changed("/shapes/0/transform", Json::array({{{"look_at", look_at}}}));
  };
  CHECK_NOTHROW(load(placed({{"from", {0, 0, 3}}, {"to", {0, 0, 0}}})));
  CHECK_THAT(load_error(placed({{"from", {0, 0, 3}}, {"to", {0, 0, 3}}})),
             Contains("/look_at/to: found [0,0,3]"));
  CHECK_THAT(load_error(placed({{"from", {0, 0, 3}}, {"to", {0, 0, 0}}, {"up", {0, 0, 2}}})),
             Contains("/look_at/up: found [0,0,2]"));
}

TEST_CASE("a material's warning names the material", "[scene_loader]") {
  const Json metal = {{"type", "dielectric"}, {"interior", "main/Au/Johnson"}};
  const Scene scene = load(changed("/materials/clay", metal));
  REQUIRE(scene.warnings.size() == 1);
  CHECK_THAT(scene.warnings[0], Catch::StartsWith("/materials/clay: the interior absorbs"));
}

TEST_CASE("the content hash follows what decides the image, not the sample count",
          "[scene_loader]") {
  const auto hash = [](const SceneOverrides& overrides) {
    return load(small_scene(), overrides).content_hash;
  };
  SceneOverrides more_samples, other_seed, smaller, darker;
  more_samples.spp = 64;
  other_seed.seed = 7;
  smaller.width = 4;
  darker.values = {{"materials.clay.reflectance", "0.4"}};
  const auto base = hash({});
  CHECK(hash(more_samples) == base);
  CHECK(hash(other_seed) != base);
  CHECK(hash(smaller) != base);
  CHECK(hash(darker) != base);
}

TEST_CASE("the published schema is the generated one, and accepts what loads", "[scene_loader]") {
  std::ifstream stream(data_path("schema/scene.schema.json"));
  const std::string published{std::istreambuf_iterator<char>(stream), {}};
  CHECK(published == scene_schema());  // karat schema > data/schema/scene.schema.json
  CHECK(schema_violation(small_scene()) == "");
  CHECK(schema_violation(changed("/film/width", "x")) != "");
  CHECK(schema_violation(changed("/materials/clay/colour", 1)) != "");
}

}  // namespace
}  // namespace karat
