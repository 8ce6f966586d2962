#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "apps/karat/command.h"
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

// A folder with a scene file in it.
struct Workplace : test::TemporaryFolder {
  Workplace() { std::ofstream(file("scene.json")) << small_scene().dump(1); }
};

std::string bytes_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_CASE("help and version succeed; every command's help shows an example", "[cli]") {
  const Outcome help = karat_run({"--help"});
  CHECK(help.code == 0);
  CHECK_THAT(karat_run({"--version"}).out, Contains("karat " KARAT_VERSION) && Contains("Embree"));
  for (const auto& name : Registry<Command>::instance().names()) {
    const std::size_t space = name.find(' ');
    std::vector<std::string> words{name.substr(0, space)};
    if (space != std::string::npos) words.push_back(name.substr(space + 1));
    CHECK_THAT(help.out, Contains(words.front()));
    words.push_back("--help");
    const Outcome command = karat_run(words);
    INFO(name);
    CHECK(command.code == 0);
    CHECK_THAT(command.out, Contains("Example: karat " + name));
  }
}

TEST_CASE("wrong usage: exit code 2 and the nearest name", "[cli]") {
  const Workplace work;
  const auto wrong = [](const std::vector<std::string>& arguments, const std::string& expected) {
    const Outcome outcome = karat_run(arguments);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.err, Catch::StartsWith("karat: error: ") && Contains(expected));
  };
  const std::string scene = work.file("scene.json");
  wrong({}, "subcommand");
  wrong({"rendr", scene}, "did you mean \"render\"");
  wrong({"render"}, "scene");
  wrong({"render", scene}, "nothing to write");
  wrong({"render", scene, "-o", "a.exr", "--thread", "2"}, "did you mean --threads");
  wrong({"render", scene, "-o", "a.jpg"}, ".exr or .png");
  wrong({"render", scene, "-o", "a.exr", "--size", "12"}, "WIDTHxHEIGHT");
  wrong({"render", scene, "-o", "a.exr", "--crop", "1,2,3"}, "x0,y0,x1,y1");
  wrong({"render", scene, "-o", "a.exr", "--spp", "many"}, "many");
  wrong({"render", scene, "-o", "a.exr", "--spp", "0"}, "0");
  wrong({"render", scene, "-o", "a.exr", "--size", "0x10"}, "1 to 65536");
  wrong({"render", scene, "-o", "a.exr", "--fresnel", "schlik"}, "did you mean \"schlick\"");
  wrong({"render", scene, "-o", "a.exr", "--aov", "albdeo"}, "did you mean \"albedo\"");
  wrong({"render", scene, "-o", "a.exr", "--resume"}, "--checkpoint");
  wrong({"render", scene, "-o", "a.exr", "--progress", "loud"}, "loud");
  wrong({"render", scene, "-o", "a.exr", "-D", "film"}, "PATH=VALUE");
  wrong({"render", scene, "--spectral", "a.exr", "--spectral-bins", "7"}, "power of two");
  wrong({"render", scene, "-o", "a.exr", "--time", "nan"}, "nan");
  wrong({"nk", "shwo"}, "did you mean \"show\"");
  wrong({"nk", "show"}, "karat nk show --help");
  wrong({"nk", "show", "main/Au/Johnson", "--nm", "450,red"}, "found \"red\"");
  wrong({"nk", "show", "main/Au/Johnson", "--nm", "nan"}, "found \"nan\"");
  wrong({"nk", "show", "main/Au/Johnson", "--jsn"}, "did you mean --json");
  wrong({"fresnel", "eval", "--model", "shlick"}, "did you mean \"schlick\"");
}

TEST_CASE("invalid input: exit code 3 and no image", "[cli]") {
  const Workplace work;
  const std::string image = work.file("a.exr");
  CHECK(karat_run({"render", work.file("none.json"), "-o", image}).code == 3);
  CHECK(karat_run({"info", work.file("none.exr")}).code == 3);
  std::ofstream(work.file("bad.json")) << "{";
  CHECK_THAT(karat_run({"render", work.file("bad.json"), "-o", image}).err, Contains("line 1"));
  const std::string scene = work.file("scene.json");
  CHECK(karat_run({"render", scene, "-o", image, "-D", "film.width=-1"}).code == 3);
  CHECK(karat_run({"render", scene, "-o", image, "-D", "film.widht=9"}).code == 3);
  const Outcome view = karat_run({"render", scene, "-o", work.file("a.png"), "--view", "nothing"});
  CHECK(view.code == 3);
  CHECK_FALSE(fs::exists(image));
}

TEST_CASE("an output that cannot be written: exit code 1 before anything is loaded", "[cli]") {
  const Workplace work;
  const Outcome outcome =
      karat_run({"render", work.file("none.json"), "-o", work.file("no/folder/a.exr")});
  CHECK(outcome.code == 1);
  CHECK_THAT(outcome.err, Contains("there is no folder"));
}

TEST_CASE("a render writes what was asked for", "[cli]") {
  const Workplace work;
  const Outcome outcome = karat_run({"render",
                                     work.file("scene.json"),
                                     "-o",
                                     work.file("a.exr"),
                                     "-o",
                                     work.file("a.png"),
                                     "--spectral",
                                     work.file("s.exr"),
                                     "--spectral-bins",
                                     "8",
                                     "--aov",
                                     "albedo,normal,depth",
                                     "--stats",
                                     work.file("stats.json"),
                                     "--progress",
                                     "json",
                                     "--size",
                                     "16x12",
                                     "--crop",
                                     "2,2,10,8",
                                     "--spp",
                                     "32"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);

  const Image image = read_image(work.file("a.exr"));
  CHECK(image.width == 8);
  CHECK(image.full_width == 16);
  CHECK(image.channels.size() == 10);
  CHECK(image.number_attributes.at("karat:spp") == 32);
  CHECK(read_image(work.file("a.png")).width == 8);
  CHECK(read_image_header(work.file("s.exr")).channels.size() == 11);

  const auto stats = nlohmann::json::parse(bytes_of(work.file("stats.json")));
  CHECK(stats["spp"] == 32);
  CHECK(stats["rays"].get<double>() >= 8 * 6 * 32);
  CHECK(stats["non_finite"] == 0);
  CHECK(stats["negative"] == 0);
  CHECK(stats["seconds"].get<double>() > 0.0);
  CHECK(stats["first_ray_seconds"].get<double>() > 0.0);
  CHECK(stats["peak_memory_bytes"].get<double>() > 1e6);

  const Outcome info = karat_run({"info", work.file("a.exr"), "--json"});
  CHECK(info.code == 0);
  const auto facts = nlohmann::json::parse(info.out);
  CHECK(facts["provenance"]["scene"] == "scene.json");
  CHECK(facts["provenance"]["observer"] == "cie1931");
  CHECK(facts["provenance"]["version"] == KARAT_VERSION);
}

TEST_CASE("equal files for any number of threads, and after a resume", "[cli]") {
  const Workplace work;
  const auto render = [&](const std::string& image, std::vector<std::string> more) {
    std::vector<std::string> arguments{
        "render", work.file("scene.json"), "-o", work.file(image), "--reproducible", "--progress",
        "none"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = karat_run(arguments);
    INFO(outcome.err);
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.err, !Contains("karat:"));  // oneTBB may note that there are fewer cores
  };
  render("one.exr", {"--spp", "16", "--threads", "1"});
  render("four.exr", {"--spp", "16", "--threads", "4"});
  CHECK(bytes_of(work.file("one.exr")) == bytes_of(work.file("four.exr")));
  render("part.exr", {"--spp", "5", "--checkpoint", work.file("c")});
  render("rest.exr", {"--spp", "16", "--checkpoint", work.file("c"), "--resume"});
  CHECK(bytes_of(work.file("one.exr")) == bytes_of(work.file("rest.exr")));
  CHECK(bytes_of(work.file("one.exr")) != bytes_of(work.file("part.exr")));
}

TEST_CASE("Ctrl-C: the image is written and the exit code is 130", "[cli]") {
  const Workplace work;
  const auto old_handler = std::signal(SIGINT, SIG_IGN);
  std::thread interrupter([] {
    struct sigaction current {};
    do {  // until the render has set its own handler
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      sigaction(SIGINT, nullptr, &current);
    } while (current.sa_handler == SIG_IGN);
    ::raise(SIGINT);
  });
  const Outcome outcome = karat_run({"render", work.file("scene.json"), "-o", work.file("a.exr"),
                                     "--time", "60", "--progress", "none"});
  interrupter.join();
  std::signal(SIGINT, old_handler);
  CHECK(outcome.code == 130);
  CHECK(read_image(work.file("a.exr")).width == 8);
}

TEST_CASE("karat schema prints the published schema", "[cli]") {
  const Outcome outcome = karat_run({"schema"});
  CHECK(outcome.code == 0);
  CHECK(outcome.out == scene_schema());
}

}  // namespace
}  // namespace karat
