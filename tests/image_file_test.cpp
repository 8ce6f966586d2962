#include "render/image_file.h"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "render/film_image.h"
#include "render/replace_file.h"
#include "spectral/support/error.h"
#include "tests/scene_text.h"
#include "tests/temporary_folder.h"

namespace karat {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

using test::TemporaryFolder;

Image gradient(int width, int height, std::vector<std::string> channels) {
  Image image;
  image.width = width, image.height = height;
  image.channels = std::move(channels);
  const std::size_t count = image.channels.size() * static_cast<std::size_t>(width * height);
  for (std::size_t i = 0; i < count; ++i) {
    image.values.push_back(0.37f * static_cast<float>(i) - 3.0f);
  }
  return image;
}

float value_of(const Image& image, const std::string& channel, int x, int y) {
  for (std::size_t c = 0; c < image.channels.size(); ++c) {
    if (image.channels[c] != channel) continue;
    return image.values[static_cast<std::size_t>(y * image.width + x) * image.channels.size() + c];
  }
  FAIL("no channel " << channel);
  return 0.0f;
}

std::string bytes_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_CASE("EXR: floats, layers, windows and attributes come back exactly", "[image_file]") {
  const TemporaryFolder folder;
  Image image = gradient(5, 3, {"R", "G", "B", "normal.X", "depth.Z"});
  image.x = 2, image.y = 1, image.full_width = 10, image.full_height = 8;
  image.attributes["karat:scene"] = "rings.json";
  image.number_attributes["karat:spp"] = 64;
  write_exr(folder.file("a.exr"), image);

  const Image read = read_image(folder.file("a.exr"));
  CHECK(read.width == 5);
  CHECK(read.height == 3);
  CHECK(read.x == 2);
  CHECK(read.y == 1);
  CHECK(read.full_width == 10);
  CHECK(read.full_height == 8);
  CHECK(read.attributes.at("karat:scene") == "rings.json");
  CHECK(read.number_attributes.at("karat:spp") == 64);
  for (const auto& channel : image.channels) {
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 5; ++x) {
        CHECK(value_of(read, channel, x, y) == value_of(image, channel, x, y));
      }
    }
  }
  CHECK(read_image_header(folder.file("a.exr")).values.empty());
}

TEST_CASE("half EXR: 11 bits of precision, and never an infinity", "[image_file]") {
  const TemporaryFolder folder;
  Image image = gradient(4, 4, {"R", "G", "B"});
  image.values[0] = 1e6f;
  write_exr(folder.file("h.exr"), image, true);
  const Image read = read_image(folder.file("h.exr"));
  CHECK(value_of(read, "R", 0, 0) == 65504.0f);
  CHECK(value_of(read, "B", 3, 3) == Approx(value_of(image, "B", 3, 3)).epsilon(0x1p-11));
}

TEST_CASE("the same image gives the same bytes", "[image_file]") {
  const TemporaryFolder folder;
  const Image image = gradient(64, 64, {"R", "G", "B"});
  write_exr(folder.file("a.exr"), image);
  write_exr(folder.file("b.exr"), image);
  CHECK(bytes_of(folder.file("a.exr")) == bytes_of(folder.file("b.exr")));
  write_png(folder.file("a.png"), image);
  write_png(folder.file("b.png"), image);
  CHECK(bytes_of(folder.file("a.png")) == bytes_of(folder.file("b.png")));
}

TEST_CASE("PNG: code values are rounded, and clamped to 0 to 1", "[image_file]") {
  const TemporaryFolder folder;
  Image image;
  image.width = 2, image.height = 1;
  image.channels = {"R", "G", "B"};
  image.values = {-0.5f, 0.5f, 2.0f, 1.0f / 255.0f, std::nanf(""), 0.7f};
  for (const int bits : {8, 16}) {
    const float step = 1.0f / (bits == 8 ? 255.0f : 65535.0f);
    write_png(folder.file("p.png"), image, bits);
    const Image read = read_image(folder.file("p.png"));
    REQUIRE(read.values.size() == 6);
    CHECK(read.values[0] == 0.0f);
    CHECK(std::abs(read.values[1] - 0.5f) <= 0.5001f * step);
    CHECK(read.values[2] == 1.0f);
    CHECK(std::abs(read.values[3] - 1.0f / 255.0f) <= 0.5001f * step);
    CHECK(read.values[4] == 0.0f);
    CHECK(std::abs(read.values[5] - 0.7f) <= 0.5001f * step);
  }
}

TEST_CASE("a failed write leaves the old file as it was, and nothing beside it", "[image_file]") {
  const TemporaryFolder folder;
  const std::string path = folder.file("kept.exr");
  write_exr(path, gradient(4, 4, {"R", "G", "B"}));
  const std::string before = bytes_of(path);

  // A limit on file sizes stands for a full disk.
  rlimit old_limit{};
  getrlimit(RLIMIT_FSIZE, &old_limit);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1024, old_limit.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  CHECK_THROWS_AS(write_exr(path, gradient(256, 256, {"R", "G", "B"})), RuntimeError);
  setrlimit(RLIMIT_FSIZE, &old_limit);
  std::signal(SIGXFSZ, old_handler);

  CHECK(bytes_of(path) == before);
  CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 1);
}

TEST_CASE("what cannot be written is said beforehand, and why", "[image_file]") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(check_writable(folder.file("no/such/folder.exr")),
                    Contains("there is no folder"));
  CHECK_THROWS_WITH(check_writable(folder.path.string()), Contains("it is a folder"));
  CHECK_THROWS_WITH(check_writable("/dev/null"), Contains("device"));
  std::ofstream(folder.file("plain")) << "x";
  CHECK_THROWS_WITH(check_writable(folder.file("plain/a.exr")), Contains("not a folder"));
  CHECK_NOTHROW(check_writable(folder.file("plain")));
  CHECK(bytes_of(folder.file("plain")) == "x");
  CHECK_NOTHROW(check_writable(folder.file("new.exr")));
  CHECK_FALSE(fs::exists(folder.file("new.exr")));
}

TEST_CASE("a link to a file stays a link", "[image_file]") {
  const TemporaryFolder folder;
  fs::create_symlink(folder.file("real.exr"), folder.file("link.exr"));
  write_exr(folder.file("link.exr"), gradient(2, 2, {"R", "G", "B"}));
  CHECK(fs::is_symlink(folder.file("link.exr")));
  CHECK(read_image(folder.file("real.exr")).width == 2);
}

TEST_CASE("files that are no images: an error with their name", "[image_file]") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(read_image(folder.file("none.exr")), Contains("no such file"));
  CHECK_THROWS_WITH(read_image(folder.path.string()), Contains("folder"));
  for (const char* name : {"text.exr", "text.png"}) {
    std::ofstream(folder.file(name)) << "not an image at all";
    CHECK_THROWS_AS(read_image(folder.file(name)), InputError);
  }
  write_exr(folder.file("cut.exr"), gradient(64, 64, {"R", "G", "B"}));
  fs::resize_file(folder.file("cut.exr"), fs::file_size(folder.file("cut.exr")) / 2);
  CHECK_THROWS_AS(read_image(folder.file("cut.exr")), InputError);
}

// A film where every pixel has received the radiance 2 in every phase.
Film even_film(const Scene& scene) {
  const RenderSettings& settings = scene.settings;
  Film film(settings.crop, {!settings.channels.empty(), settings.spectral_bins},
            Sensor::make(settings.observer, scene.lattice));
  for (int y = settings.crop.y0; y < settings.crop.y1; ++y) {
    for (int x = settings.crop.x0; x < settings.crop.x1; ++x) {
      for (int phase = 0; phase < kPhases; ++phase) {
        film.add(x, y, SampledSpectrum(2.0f), {phase, 0}, nullptr);
      }
    }
  }
  return film;
}

TEST_CASE("the spectral EXR has the published layout", "[image_file]") {
  SceneOverrides overrides;
  overrides.spectral_bins = 4;
  const Scene scene = load_scene_text(small_scene().dump(), "test.json", "", overrides);
  const Image image = spectral_image(scene, even_film(scene));
  // Band centres of 380 to 780 nm in four, with a decimal comma.
  CHECK(image.channels == std::vector<std::string>{"R", "G", "B", "S0.430,000000nm",
                                                   "S0.530,000000nm", "S0.630,000000nm",
                                                   "S0.730,000000nm"});
  CHECK(image.attributes.at("spectralLayoutVersion") == "1.0");
  CHECK(image.attributes.at("emissiveUnits") == "W.m^-2.sr^-1");
  for (const char* band : {"S0.430,000000nm", "S0.730,000000nm"}) {
    CHECK(value_of(image, band, 3, 2) == Approx(2.0f).epsilon(1e-6));
  }
}

TEST_CASE("equal energy is white where the scene says so", "[image_file]") {
  nlohmann::json json = small_scene();
  json["white"] = "E";
  const Scene scene = load_scene_text(json.dump(), "test.json", "");
  const Image image = film_image(scene, even_film(scene));
  // 380 to 780 nm hold all but 2e-5 of the observer's luminous integral; Rec. 709's white and that
  // of the D65 table differ by 2.4e-4.
  for (const char* channel : {"R", "G", "B"}) {
    CHECK(value_of(image, channel, 0, 0) == Approx(2.0f).epsilon(1e-3));
  }
}

TEST_CASE("provenance: run facts only where asked for", "[image_file]") {
  const Scene scene = load_scene_text(small_scene().dump(), "folder/test.json", "");
  Image with, without;
  const RunFacts facts{1.5, 2};
  add_provenance(with, scene, 4, &facts);
  add_provenance(without, scene, 4, nullptr);
  CHECK(with.number_attributes.at("karat:render_seconds") == 1.5);
  CHECK(without.number_attributes.count("karat:render_seconds") == 0);
  CHECK(without.number_attributes.at("karat:spp") == 4);
  CHECK(without.attributes.at("karat:scene") == "test.json");
}

}  // namespace
}  // namespace karat
