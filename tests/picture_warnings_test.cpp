#include "apps/karat/picture_warnings.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace karat {
namespace {

using Catch::Matchers::Contains;

// Grey pixels from `low` to `high`, in equal steps.
Image ramp(float low, float high) {
  Image image;
  image.width = image.full_width = 40, image.height = image.full_height = 25;
  image.channels = {"R", "G", "B"};
  for (int i = 0; i < 1000; ++i) {
    image.values.insert(image.values.end(), 3, low + (high - low) * static_cast<float>(i) / 999.0f);
  }
  return image;
}

std::string warning_of(const Image& image, double exposure_stops = 0.0) {
  const OcioView view("", "", "", exposure_stops);
  const auto warnings = picture_warnings(image, &view);
  REQUIRE(warnings.size() <= 1);
  return warnings.empty() ? "" : warnings[0];
}

TEST_CASE("a black picture is said to be black", "[picture_warnings]") {
  CHECK_THAT(warning_of(ramp(0, 0)), Contains("every pixel is black"));
  CHECK(picture_warnings(ramp(0, 0), nullptr).size() == 1);
  Image one_lit = ramp(0, 0);
  one_lit.values[7] = 1.0f;
  CHECK(warning_of(one_lit) == "");
}

TEST_CASE("too bright or too dark for the display: with the exposure that helps",
          "[picture_warnings]") {
  CHECK(warning_of(ramp(0.0f, 1.0f)) == "");
  CHECK(warning_of(ramp(0.0f, 2.0f)) == "");  // 37 % are above 1.25
  // The 90th percentile is 9.0; log2(0.7 / 9.0) = -3.68.
  CHECK_THAT(warning_of(ramp(0.0f, 10.0f)), Contains("88 %") && Contains("--exposure -3.7"));
  // 0.9e-3 to 0.7: 9.6 stops.
  CHECK_THAT(warning_of(ramp(0.0f, 1e-3f)), Contains("nearly black") && Contains("--exposure 9.6"));
}

TEST_CASE("the exposure that is named silences the warning", "[picture_warnings]") {
  CHECK(warning_of(ramp(0.0f, 10.0f), -3.7) == "");
  CHECK(warning_of(ramp(0.0f, 1e-3f), 9.6) == "");
  CHECK_THAT(warning_of(ramp(0.0f, 1.0f), 5.0), Contains("--exposure -0.4"));
}

TEST_CASE("what is no defect: no display, crops, masks, white backdrops, feature layers",
          "[picture_warnings]") {
  CHECK(picture_warnings(ramp(0, 10), nullptr).empty());
  Image crop = ramp(0, 0);
  crop.full_width = 80;
  CHECK(warning_of(crop) == "");
  CHECK(warning_of(ramp(5, 5)) == "");
  CHECK(warning_of(ramp(0.95f, 1.05f)) == "");
  Image layers = ramp(0, 0);
  layers.channels.push_back("depth.Z");
  layers.values.assign(4000, 0.0f);
  CHECK(warning_of(layers) == "");
}

}  // namespace
}  // namespace karat
