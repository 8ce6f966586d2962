// A second opinion: three rings under a lamp, as another renderer has rendered them.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "render/film_image.h"
#include "tests/rendered.h"

using namespace karat;

namespace {

constexpr const char* kReference =
    KARAT_TEST_REFERENCE_DIR "/reference/rings_area/mitsuba_reference.exr";
constexpr int kSpp = 64, kReferenceSpp = 4096;
// That renderer divides by an integral of ybar of 106.750 instead of 106.857.
constexpr double kNormalisation = 0.999;
constexpr int kRegion = 64;

// Luminance of linear Rec. 709.
double luminance(double r, double g, double b) {
  return 0.212639 * r + 0.715169 * g + 0.072192 * b;
}

struct Both {
  Image ours, theirs;
  Film film;
};

const Both& both() {
  static const Both images = [] {
    SceneOverrides overrides;
    overrides.spp = kSpp;
    const Scene scene = load_scene(KARAT_TEST_SCENE_DIR "/rings_area.json", overrides);
    Film film = test::rendered(scene);
    Image ours = film_image(scene, film), theirs = read_image(kReference);
    for (float& v : theirs.values) v *= static_cast<float>(kNormalisation);
    return Both{std::move(ours), std::move(theirs), std::move(film)};
  }();
  return images;
}

bool available() {
  if (std::filesystem::exists(kReference)) return true;
  WARN("skipped: " << kReference << " is not there");
  return false;
}

double value(const Image& image, int x, int y, std::size_t channel) {
  const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(x);
  return image.values[pixel * image.channels.size() + channel];
}

}  // namespace

TEST_CASE("the rings' mean colour is that of another renderer within 0.3 %", "[rings_area]") {
  if (!available()) return;
  const Image &ours = both().ours, &theirs = both().theirs;
  const Film& film = both().film;
  REQUIRE(theirs.channels.size() >= 3);
  REQUIRE(ours.values.size() / ours.channels.size() ==
          theirs.values.size() / theirs.channels.size());
  for (std::size_t channel = 0; channel < 3; ++channel) {
    double sum_ours = 0.0, sum_theirs = 0.0;
    test::for_each_pixel(film, [&](int x, int y) {
      sum_ours += value(ours, x, y, channel), sum_theirs += value(theirs, x, y, channel);
    });
    CAPTURE(channel, sum_ours / sum_theirs);
    CHECK(sum_ours / sum_theirs == Approx(1.0).margin(3e-3));
  }
}

// Every block of the image, so that no error hides in the mean. The bound: four standard errors,
// with the other image's variance taken as ours per sample, four times over because it carries a
// quarter of our wavelengths; and the 0.3 % that are granted to the means.
TEST_CASE("every block of the rings is that of another renderer, within noise", "[rings_area]") {
  if (!available()) return;
  const Image &ours = both().ours, &theirs = both().theirs;
  const Film& film = both().film;
  double worst = 0.0;
  for (int y0 = 0; y0 < ours.height; y0 += kRegion) {
    for (int x0 = 0; x0 < ours.width; x0 += kRegion) {
      double sum_ours = 0.0, sum_theirs = 0.0, variance = 0.0;
      for (int y = y0; y < y0 + kRegion; ++y) {
        for (int x = x0; x < x0 + kRegion; ++x) {
          const auto y_of = [&](const Image& image) {
            return luminance(value(image, x, y, 0), value(image, x, y, 1), value(image, x, y, 2));
          };
          sum_ours += y_of(ours), sum_theirs += y_of(theirs);
          variance += film.pixel(x, y).variance_of_mean * (1.0 + 4.0 * kSpp / kReferenceSpp);
        }
      }
      const double difference = sum_ours - sum_theirs;
      CAPTURE(x0, y0, sum_ours / sum_theirs, difference / std::sqrt(variance));
      CHECK(std::abs(difference) < 4.0 * std::sqrt(variance) + 3e-3 * sum_theirs);
      if (std::abs(difference) > std::abs(worst) * std::sqrt(variance))
        worst = difference / std::sqrt(variance);
    }
  }
  INFO("worst block: " << worst << " standard errors");
  SUCCEED();
}
