#include "spectral/rgb_to_spectrum.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "spectral/illuminant.h"
#include "spectral/support/error.h"

using namespace karat;

namespace {

Rgb colour_under_d65(const Spectrum& reflectance) {
  static const SpectrumPtr d65 = illuminant("D65");
  return linear_srgb_of_xyz(xyz_of_reflectance(reflectance, *d65, observer("cie1931")));
}

double largest_difference(const Rgb& a, const Rgb& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

double delta_e(const Rgb& a, const Rgb& b) {
  static const Xyz white = white_xyz("D65");
  return delta_e_2000(lab_of_xyz(xyz_of_linear_srgb(a), white),
                      lab_of_xyz(xyz_of_linear_srgb(b), white));
}

// Whether the reflectance of `rgb` lies within [0, 1] and has that colour.
void check_round_trip(const Rgb& rgb, double tolerance) {
  const SpectrumPtr reflectance = rgb_reflectance_spectrum(rgb);
  for (double nm = 300.0; nm <= 900.0; nm += 5.0) {
    const double r = (*reflectance)(nm);
    if (!(r >= 0.0 && r <= 1.0)) FAIL_CHECK("reflectance " << r << " at " << nm);
  }
  const Rgb back = colour_under_d65(*reflectance);
  INFO(rgb[0] << " " << rgb[1] << " " << rgb[2] << " returned as " << back[0] << " " << back[1]
              << " " << back[2]);
  CHECK(largest_difference(rgb, back) < tolerance);
  CHECK(delta_e(rgb, back) < 0.1);
}

template <typename Visit>
void for_each_rgb(const std::vector<double>& levels, Visit&& visit) {
  for (const double r : levels) {
    for (const double g : levels) {
      for (const double b : levels) visit(Rgb{r, g, b});
    }
  }
}

}  // namespace

TEST_CASE("A reflectance from RGB has that colour under D65", "[rgb_to_spectrum]") {
  for_each_rgb({0.0, 0.001, 0.02, 0.2, 0.5, 0.8, 0.98, 0.999},
               [](const Rgb& rgb) { check_round_trip(rgb, 1e-4); });
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    check_round_trip({uniform(random), uniform(random), uniform(random)}, 1e-4);
  }
}

TEST_CASE("Corners, edges and faces of the RGB cube are met", "[rgb_to_spectrum]") {
  for_each_rgb({0.0, 1e-6, 0.5, 1.0 - 1e-6, 1.0}, [](const Rgb& rgb) {
    // The D65 table's white is not the sRGB matrix's: near (1, 1, 1) no reflectance up to 1 is
    // left.
    const bool nearly_white = std::min({rgb[0], rgb[1], rgb[2]}) > 0.9;
    check_round_trip(rgb, nearly_white ? 2.5e-4 : 1e-4);
  });
  CHECK(rgb_reflectance_spectrum({0, 0, 0})->mean({380, 780}) == 0.0);
  CHECK(rgb_reflectance_spectrum({1, 1, 1})->mean({380, 780}) == 1.0);
}

TEST_CASE("A grey's reflectance is nearly flat", "[rgb_to_spectrum]") {
  for (const double grey : {0.02, 0.18, 0.5, 0.9}) {
    const SpectrumPtr s = rgb_reflectance_spectrum({grey, grey, grey});
    for (double nm = 380.0; nm <= 780.0; nm += 10.0) {
      CHECK((*s)(nm) == Approx(grey).epsilon(2e-3));
    }
  }
}

TEST_CASE("The fit's own error is that of the 1 nm sums", "[rgb_to_spectrum]") {
  for (const Rgb& rgb : {Rgb{0.8, 0.1, 0.3}, Rgb{0.9999, 0.9999, 0.9999}}) {
    const RgbReflectanceFit fit = rgb_reflectance_fit(rgb);
    const Rgb back = colour_under_d65(*rgb_reflectance_spectrum(rgb));
    CHECK(fit.error == Approx(largest_difference(rgb, back)).epsilon(0).margin(1e-10));
  }
}

TEST_CASE("Neighbouring colours have neighbouring reflectances", "[rgb_to_spectrum]") {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform(0.05, 0.95);
  for (int i = 0; i < 100; ++i) {
    const Rgb a{uniform(random), uniform(random), uniform(random)};
    const Rgb b{a[0] + 1e-4, a[1], a[2]};
    const SpectrumPtr s = rgb_reflectance_spectrum(a), t = rgb_reflectance_spectrum(b);
    for (double nm = 400.0; nm <= 700.0; nm += 10.0) {
      if (!(std::abs((*s)(nm) - (*t)(nm)) < 0.01)) {
        FAIL_CHECK(a[0] << " " << a[1] << " " << a[2] << " jumps at " << nm);
      }
    }
  }
}

TEST_CASE("Emission from RGB has that colour", "[rgb_to_spectrum]") {
  const Observer& o = observer("cie1931");
  for (const Rgb& rgb :
       {Rgb{1, 1, 1}, Rgb{12, 3, 0.5}, Rgb{0, 0, 7}, Rgb{1e-3, 0, 1e-3}, Rgb{1e5, 1e5, 0}}) {
    const SpectrumPtr s = rgb_illuminant_spectrum(rgb, illuminant("D65"));
    const Rgb back = linear_srgb_of_xyz(xyz_of_emission(*s, o));
    CHECK(largest_difference(rgb, back) < 1e-4 * std::max({rgb[0], rgb[1], rgb[2]}));
  }
  CHECK(xyz_of_emission(*rgb_illuminant_spectrum({0, 0, 0}, illuminant("D65")), o)[1] == 0.0);
  // White under a spiky lamp is that lamp's own white.
  const SpectrumPtr lamp = rgb_illuminant_spectrum({2, 2, 2}, illuminant("FL11"));
  const auto xyy = xyy_of_xyz(xyz_of_emission(*lamp, o)), white = xyy_of_xyz(white_xyz("FL11"));
  CHECK(xyy[0] == Approx(white[0]).epsilon(0).margin(2e-4));
  CHECK(xyy[1] == Approx(white[1]).epsilon(0).margin(2e-4));
  CHECK(xyy[2] == Approx(2.0).epsilon(1e-3));
  CHECK(lamp->range().min_nm == 380.0);
}

TEST_CASE("RGB outside its range is an error", "[rgb_to_spectrum]") {
  for (const Rgb& rgb : {Rgb{-0.001, 0, 0}, Rgb{0, 1.001, 0}, Rgb{0, 0, std::nan("")}}) {
    CHECK_THROWS_AS(rgb_reflectance_spectrum(rgb), InputError);
  }
  for (const Rgb& rgb : {Rgb{-0.001, 0, 0}, Rgb{0, INFINITY, 0}, Rgb{0, 0, std::nan("")}}) {
    CHECK_THROWS_AS(rgb_illuminant_spectrum(rgb, illuminant("D65")), InputError);
  }
}
