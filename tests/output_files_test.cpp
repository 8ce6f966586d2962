#include "apps/karat/output_files.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "render/image_file.h"
#include "tests/run_cli.h"
#include "tests/scene_text.h"
#include "tests/temporary_folder.h"

namespace karat {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using test::karat_run;
using test::Outcome;

// A folder with a scene that reads a mesh, a spectrum, an index table and an image.
struct Workplace : test::TemporaryFolder {
  Workplace() {
    std::ofstream(file("mesh.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::ofstream(file("paint.spd")) << "300 0.5\n900 0.5\n";
    std::ofstream(file("metal.yml")) << "DATA:\n  - type: tabulated nk\n    data: |\n"
                                        "        0.3 1.0 2.0\n        0.9 1.0 2.0\n";
    Image sky;
    sky.width = 4, sky.height = 2;
    sky.channels = {"R", "G", "B"};
    sky.values.assign(24, 0.5f);
    write_exr(file("sky.exr"), sky);
    nlohmann::json scene = small_scene();
    scene["materials"]["paint"] = {{"type", "diffuse"}, {"reflectance", {{"file", "paint.spd"}}}};
    scene["materials"]["metal"] = {{"type", "conductor"}, {"nk", "metal.yml"}};
    scene["shapes"].push_back({{"type", "mesh"}, {"material", "paint"}, {"file", "mesh.obj"}});
    scene["lights"] = {{{"type", "image"}, {"file", "sky.exr"}}};
    std::ofstream(file("scene.json")) << scene.dump(1);
  }
  std::string bytes(const std::string& name) const {
    std::ifstream stream(file(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  Outcome render(std::vector<std::string> more) const {
    more.insert(more.begin(), {"render", file("scene.json"), "--progress", "lines"});
    return karat_run(more);
  }
};

TEST_CASE("no output replaces what the render reads", "[output_files]") {
  const Workplace work;
  REQUIRE(work.render({"-o", work.file("a.exr"), "--spp", "1"}).code == 0);
  const std::vector<std::string> inputs{"scene.json", "mesh.obj", "paint.spd", "metal.yml",
                                        "sky.exr"};
  for (const auto& input : inputs) {
    const std::string before = work.bytes(input);
    fs::create_symlink(input, work.path / ("link_" + input + ".exr"));
    fs::create_hard_link(work.path / input, work.path / ("hard_" + input + ".exr"));
    const std::vector<std::pair<std::string, std::string>> outputs{
        {"--stats", input},
        {"--checkpoint", input},
        {"-o", "link_" + input + ".exr"},
        {"--spectral", "hard_" + input + ".exr"}};
    for (const auto& [option, name] : outputs) {
      const std::string given = (work.path / "." / name).string();
      const Outcome outcome = work.render({"-o", work.file("b.exr"), option, given});
      INFO(option << " " << name << ": " << outcome.err);
      CHECK(outcome.code == 2);
      CHECK_THAT(outcome.err, Contains(option + ": \"" + given + "\""));
      CHECK(work.bytes(input) == before);
      CHECK_FALSE(fs::exists(work.file("b.exr")));
    }
  }
  CHECK_THAT(work.render({"--stats", work.file("scene.json")}).err, Contains("is the scene file"));
  CHECK_THAT(work.render({"-o", work.file("sky.exr")}).err, Contains("is read by the scene"));
}

TEST_CASE("no output replaces another one", "[output_files]") {
  const Workplace work;
  fs::create_symlink("x.exr", work.path / "y.exr");  // leads to what is not there yet
  const std::vector<std::pair<std::string, std::string>> pairs{
      {"x.exr", "x.exr"}, {"x.exr", "./x.exr"}, {"x.exr", "y.exr"}};
  for (const auto& [first, second] : pairs) {
    for (const char* option : {"-o", "--spectral"}) {
      const Outcome outcome =
          work.render({"-o", work.file(first), option, (work.path / second).string()});
      INFO(option << " " << second << ": " << outcome.err);
      CHECK(outcome.code == 2);
      CHECK_THAT(outcome.err, Contains("are the same file"));
    }
  }
  CHECK_FALSE(fs::exists(work.file("x.exr")));
}

TEST_CASE("a checkpoint that exists is kept, and the same command can be repeated",
          "[output_files]") {
  const Workplace work;
  const std::string checkpoint = work.file("ck"), image = work.file("a.exr");
  const auto render = [&](const std::string& spp, bool resume) {
    std::vector<std::string> arguments{"-o", image,          "--reproducible", "--spp",
                                       spp,  "--checkpoint", checkpoint};
    if (resume) arguments.push_back("--resume");
    return work.render(arguments);
  };
  const Outcome first = render("3", true);
  CHECK(first.code == 0);
  CHECK_THAT(first.err, Contains("not there yet"));
  const std::string saved = work.bytes("ck"), picture = work.bytes("a.exr");
  const Outcome refused = render("3", false);
  CHECK(refused.code == 2);
  CHECK_THAT(refused.err, Contains("ck\" exists and holds 3 spp: --resume goes on with it"));
  CHECK(work.bytes("ck") == saved);
  const Outcome again = render("3", true);
  CHECK(again.code == 0);
  CHECK_THAT(again.err, Contains("holds 3 spp, 3 were asked for: nothing is left to render"));
  CHECK(work.bytes("a.exr") == picture);
  CHECK_THAT(render("5", true).err, Contains("holds 3 spp: goes on"));
  CHECK_THAT(render("2", true).err, Contains("holds 5 spp, 2 were asked for"));
  std::ofstream(checkpoint) << "my notes";
  const Outcome other = render("3", false);
  CHECK(other.code == 2);
  CHECK_THAT(other.err, Contains("is not a checkpoint"));
  CHECK(work.bytes("ck") == "my notes");
}

TEST_CASE("options without effect, and values that cannot be meant, are refused",
          "[output_files]") {
  const Workplace work;
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& expected) {
    const Outcome outcome = work.render(arguments);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.err, Contains(expected));
  };
  const std::string png = work.file("a.png"), exr = work.file("a.exr");
  refused({"--spectral", png}, "--spectral: found \"" + png + "\", allowed: a name in .exr");
  refused({"-o", png, "--aov", "depth"}, "--aov: needs -o FILE.exr");
  refused({"-o", png, "--half"}, "--half: needs -o FILE.exr or --spectral FILE.exr");
  refused({"-o", exr, "--exposure", "3"}, "--exposure: needs -o FILE.png");
  refused({"-o", exr, "--view", "Raw"}, "--view: needs -o FILE.png");
  refused({"-o", exr, "--ocio", "x.ocio"}, "--ocio: needs -o FILE.png");
  refused({"-o", exr, "--spectral-bins", "8"}, "--spectral-bins: needs --spectral FILE.exr");
  refused({"-o", exr, "--time", "0"}, "--time: found \"0\", allowed: a number from 0.001");
  refused({"-o", exr, "--spp", "0"}, "--spp: found \"0\", allowed: a whole number from 1 to");
  refused({"-o", exr, "--threads", "-1"},
          "--threads: found \"-1\", allowed: a whole number from 0 to 4096");
  refused({"-o", exr, "--seed", "-1"}, "--seed: found \"-1\", allowed: a whole number from 0 to");
}

TEST_CASE("control bytes of a file never reach the terminal", "[output_files]") {
  const Workplace work;
  std::ofstream(work.file("bad.json")) << R"({"\u001b[31m": 1})";
  const Outcome outcome = karat_run({"render", work.file("bad.json"), "-o", work.file("a.exr")});
  CHECK(outcome.code == 3);
  CHECK_THAT(outcome.err, Contains("\\x1b[31m"));
  CHECK(outcome.err.find('\x1b') == std::string::npos);
}

}  // namespace
}  // namespace karat
