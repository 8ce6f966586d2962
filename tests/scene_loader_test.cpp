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
  CHECK_THAT(load_error(std::string("")), Contains("malformed JSON"));
  CHECK_THAT(load_error(std::string("{\"film\": {}} x")), Contains("malformed JSON"));
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
      {"/film/heigth", 5, {"unknown key \"heigth\"", "did you mean \"height\""}},
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
      {"/lihgts", Json::array(), {"unknown key \"lihgts\"", "did you mean \"lights\""}}};
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
  CHECK_THAT(load_error(scene), Contains("/instances/0/group") && Contains("\"pair\""));
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
  CHECK_THAT(load_error(small_scene(), with("shapes.1.radius", "1")), Contains("index below 1"));
  CHECK_THAT(load_error(small_scene(), with("film.width", "many")), Contains("found \"many\""));
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
