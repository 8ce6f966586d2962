// The same bits, whatever the order of the work: threads, passes, interruptions, parts.
#include <tbb/global_control.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "render/checkpoint.h"
#include "tests/rendered.h"

using namespace karat;

namespace {

const FilmChannels kEverything{true, 16};

// Several tiles in each direction, refraction, dispersion, instances, every kind of light.
nlohmann::json busy_scene() {
  return nlohmann::json::parse(R"({
    "camera": {"type": "perspective", "position": [0, -6, 3], "look_at": [0, 0, 0.6],
               "aperture_radius": 0.1},
    "film": {"width": 41, "height": 35},
    "sampling": {"spp": 11},
    "materials": {
      "clay": {"type": "diffuse", "reflectance": 0.5},
      "metal": {"type": "conductor", "nk": {"eta": 0.3, "k": 3}, "alpha": 0.2},
      "glass": {"type": "dielectric",
                "interior": {"eta": {"table": [[380, 1.7], [780, 1.5]]}, "k": 0}},
      "frosted": {"type": "dielectric", "alpha": 0.3,
                  "interior": {"eta": {"table": [[380, 1.7], [780, 1.5]]}, "k": 0}}},
    "shapes": [
      {"type": "rectangle", "material": "clay", "width": 20, "height": 20},
      {"type": "sphere", "material": "glass", "transform": [{"translate": [-1.2, 0, 1.1]}]},
      {"type": "sphere", "material": "frosted", "transform": [{"translate": [1.2, 0, 1.1]}]},
      {"type": "disk", "emission": {"illuminant": "A", "luminance": 10},
       "transform": [{"rotate": {"axis": [1, 0, 0], "angle_deg": 180}}, {"translate": [0, 0, 4]}]}],
    "groups": {"rings": [{"type": "torus", "material": "metal", "major_radius": 0.5,
                          "minor_radius": 0.2, "segments_u": 48, "segments_v": 24}]},
    "instances": [{"group": "rings", "transform": [{"translate": [0, -1, 0.3]}]},
                  {"group": "rings", "transform": [{"scale": [1, 2, -1]}, {"translate": [0, 2, 1]}]}],
    "lights": [{"type": "constant", "radiance": 0.3}, {"type": "point", "position": [2, -3, 4]}]
  })");
}

const Scene& scene() {
  static const Scene shared = test::scene_from(busy_scene());
  return shared;
}

// Rendered once by one thread, without interruption.
const std::vector<std::uint8_t>& expected() {
  static const std::vector<std::uint8_t> bytes = [] {
    RenderOptions options;
    options.threads = 1;
    return test::rendered(scene(), kEverything, options).save();
  }();
  return bytes;
}

// The film of samples [first, last) alone.
Film part(int first, int last) {
  Scene range = test::scene_from(busy_scene());
  range.settings.spp = last;
  RenderOptions options;
  options.first_sample = first;
  return test::rendered(range, kEverything, options);
}

}  // namespace

TEST_CASE("the image is the same, bit for bit, for any number of threads", "[determinism]") {
  // Without this TBB would give an arena no more threads than the machine has.
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 7);
  for (const int threads : {2, 7}) {
    RenderOptions options;
    options.threads = threads;
    CAPTURE(threads);
    CHECK(test::rendered(scene(), kEverything, options).save() == expected());
  }
}

TEST_CASE("two renders of the same file, each loaded anew, are the same", "[determinism]") {
  CHECK(part(0, scene().settings.spp).save() == expected());
}

TEST_CASE("parts of the samples rendered apart and merged in any order are the whole",
          "[determinism]") {
  const Film a = part(0, 3), b = part(3, 4), c = part(4, 11);
  Film forward = test::film_for(scene(), kEverything), backward = forward;
  for (const Film* film : {&a, &b, &c}) forward.merge(*film);
  for (const Film* film : {&c, &b, &a}) backward.merge(*film);
  CHECK(forward.save() == expected());
  CHECK(backward.save() == expected());
}

TEST_CASE("stopped after any pass, saved, loaded and finished: the uninterrupted image",
          "[determinism]") {
  const std::string file =
      (std::filesystem::temp_directory_path() / ("karat_determinism_" + std::to_string(::getpid())))
          .string();
  for (const int passes : {1, 2, 3}) {
    Film first = test::film_for(scene(), kEverything);
    RenderOptions stopping;
    int left = passes;
    stopping.after_pass = [&](const RenderProgress&, const Film&) { return --left > 0; };
    const RenderResult half = render(scene(), stopping, first);
    REQUIRE(half.samples < scene().settings.spp);
    save_checkpoint(file, scene(), first, half.samples);

    Film resumed = test::film_for(scene(), kEverything);
    RenderOptions options;
    options.first_sample = load_checkpoint(file, scene(), resumed);
    CHECK(options.first_sample == half.samples);
    render(scene(), options, resumed);
    CAPTURE(passes);
    CHECK(resumed.save() == expected());
  }
  std::filesystem::remove(file);
}

TEST_CASE("a crop holds the pixels of the full image", "[determinism]") {
  Film whole = test::film_for(scene(), kEverything);
  whole.load(expected());
  nlohmann::json json = busy_scene();
  json["film"]["crop"] = {5, 17, 30, 34};
  const Film crop = test::rendered(test::scene_from(json), kEverything);
  REQUIRE(crop.crop().x1 - crop.crop().x0 == 25);
  int different = 0;
  test::for_each_pixel(crop, [&](int x, int y) {
    const PixelValue a = crop.pixel(x, y), b = whole.pixel(x, y);
    const Film::Features fa = crop.features(x, y), fb = whole.features(x, y);
    different += a.xyz != b.xyz || a.variance_of_mean != b.variance_of_mean ||
                 a.samples != b.samples || fa.albedo_xyz != fb.albedo_xyz ||
                 fa.normal != fb.normal || fa.depth != fb.depth || fa.shape != fb.shape;
    for (int bin = 0; bin < kEverything.spectral_bins; ++bin) {
      different += crop.spectral(x, y, bin) != whole.spectral(x, y, bin);
    }
  });
  CHECK(different == 0);
}

TEST_CASE("another seed gives other noise of the same image", "[determinism]") {
  nlohmann::json json = busy_scene();
  json["sampling"]["seed"] = 1;
  const Film other = test::rendered(test::scene_from(json), kEverything);
  CHECK(other.save() != expected());
  Film whole = test::film_for(scene(), kEverything);
  whole.load(expected());
  double difference = 0.0, variance = 0.0;
  int equal = 0;
  test::for_each_pixel(other, [&](int x, int y) {
    const PixelValue a = other.pixel(x, y), b = whole.pixel(x, y);
    difference += a.xyz[1] - b.xyz[1];
    variance += a.variance_of_mean + b.variance_of_mean;
    equal += a.xyz[1] == b.xyz[1];
  });
  CHECK(equal == 0);
  // Stratified samples vary less than the film's variance says: this bound is wide.
  CHECK(std::abs(difference) < 4.0 * std::sqrt(variance));
}
