#include "render/checkpoint.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "render/renderer.h"
#include "tests/scene_text.h"

namespace karat {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

struct TemporaryFile {
  std::string path =
      (fs::temp_directory_path() / ("karat_checkpoint_" + std::to_string(::getpid()))).string();
  ~TemporaryFile() { fs::remove(path); }
};

Scene scene_with(int spp, const nlohmann::json& json = small_scene()) {
  SceneOverrides overrides;
  overrides.spp = spp;
  return load_scene_text(json.dump(), "test.json", "", overrides);
}

Film film_of(const Scene& scene) {
  return {scene.settings.crop, {}, Sensor::make(scene.settings.observer, scene.lattice)};
}

TEST_CASE("resuming from a checkpoint gives the bits of one uninterrupted render", "[checkpoint]") {
  const TemporaryFile file;
  const Scene whole = scene_with(8);
  Film expected = film_of(whole);
  render(whole, {}, expected);

  const Scene half = scene_with(4);
  Film first = film_of(half);
  render(half, {}, first);
  save_checkpoint(file.path, half, first, 4);

  Film resumed = film_of(whole);
  RenderOptions options;
  options.first_sample = load_checkpoint(file.path, whole, resumed);
  CHECK(options.first_sample == 4);
  render(whole, options, resumed);
  CHECK(resumed.save() == expected.save());
}

TEST_CASE("a checkpoint of another render: what differs is named", "[checkpoint]") {
  const TemporaryFile file;
  const Scene scene = scene_with(4);
  save_checkpoint(file.path, scene, film_of(scene), 0);
  const auto load_into = [&](const nlohmann::json& json) {
    const Scene other = scene_with(4, json);
    Film film = film_of(other);
    load_checkpoint(file.path, other, film);
  };
  nlohmann::json other = small_scene();
  other["film"]["width"] = 9;
  CHECK_THROWS_WITH(load_into(other), Contains(file.path) && Contains("its crop is [0, 0, 8, 6]"));
  other = small_scene();
  other["sampling"]["seed"] = 5;
  CHECK_THROWS_WITH(load_into(other), Contains("its seed is 0, this one's is 5"));
  other = small_scene();
  other["materials"]["clay"]["reflectance"] = 0.25;
  CHECK_THROWS_WITH(load_into(other), Contains("content"));
}

TEST_CASE("damaged checkpoints: every flipped byte and every cut is found", "[checkpoint]") {
  const TemporaryFile file;
  const Scene scene = scene_with(4);
  save_checkpoint(file.path, scene, film_of(scene), 3);
  std::ifstream stream(file.path, std::ios::binary);
  const std::string good{std::istreambuf_iterator<char>(stream), {}};
  const auto load_bytes = [&](const std::string& bytes) {
    std::ofstream(file.path, std::ios::binary) << bytes;
    Film film = film_of(scene);
    return load_checkpoint(file.path, scene, film);
  };
  CHECK(load_bytes(good) == 3);
  for (std::size_t length = 0; length < good.size(); length += 37) {
    CHECK_THROWS_AS(load_bytes(good.substr(0, length)), InputError);
  }
  CHECK_THROWS_AS(load_bytes(good + "x"), InputError);
  for (std::size_t at = 0; at < good.size(); at = at < 80 ? at + 1 : at + 101) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x10);
    INFO("byte " << at);
    CHECK_THROWS_AS(load_bytes(bad), InputError);
  }
}

TEST_CASE("no checkpoint file, or a folder: an error", "[checkpoint]") {
  const Scene scene = scene_with(4);
  Film film = film_of(scene);
  CHECK_THROWS_AS(load_checkpoint("/nowhere/film.ckpt", scene, film), InputError);
  CHECK_THROWS_AS(load_checkpoint("/tmp", scene, film), InputError);
}

}  // namespace
}  // namespace karat
