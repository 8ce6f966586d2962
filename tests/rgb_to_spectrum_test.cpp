#include "spectral/rgb_to_spectrum.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "spectral/illuminant.h"
#include "spectral/support/error.h"

using namespace karat;

namespace {

Rgb colour_under_d65(const Spectrum& reflectance) {
  return linear_srgb_of_xyz(
      xyz_of_reflectance(reflectance, *illuminant("D65"), observer("cie1931")));
}

double largest_difference(const Rgb& a, const Rgb& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

double delta_e(const Rgb& a, const Rgb& b) {
  const Xyz white = white_xyz("D65");
  return delta_e_2000(lab_of_xyz(xyz_of_linear_srgb(a), white),
                      lab_of_xyz(xyz_of_linear_srgb(b), white));
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
  double worst = 0.0, worst_delta_e = 0.0;
  for_each_rgb({0.001, 0.01, 0.05, 0.2, 0.5, 0.8, 0.95, 0.99}, [&](const Rgb& rgb) {
    const Rgb back = colour_under_d65(*rgb_reflectance_spectrum(rgb));
    const double e = largest_difference(rgb, back), de = delta_e(rgb, back);
    if (e > 1e-4 || de > 0.1) WARN(rgb[0] << " " << rgb[1] << " " << rgb[2] << ": " << e << " dE " << de);
    worst = std::max(worst, e), worst_delta_e = std::max(worst_delta_e, de);
  });
  WARN(worst << " dE " << worst_delta_e);
  CHECK(worst < 1e-4);
  CHECK(worst_delta_e < 0.1);
}

TEST_CASE("Colours on the faces of the cube", "[rgb_to_spectrum]") {
  double worst = 0.0;
  for_each_rgb({0.0, 0.5, 1.0}, [&](const Rgb& rgb) {
    const Rgb back = colour_under_d65(*rgb_reflectance_spectrum(rgb));
    const double e = largest_difference(rgb, back);
    const auto c = rgb_reflectance_fit(rgb).coefficients;
    WARN(rgb[0] << " " << rgb[1] << " " << rgb[2] << ": " << e << " dE " << delta_e(rgb, back) << " c " << c[0] << " " << c[1] << " " << c[2]);
    worst = std::max(worst, e);
  });
}
