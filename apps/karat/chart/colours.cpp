// Colours of series and of maps.
#include <algorithm>
#include <cmath>

#include "apps/karat/chart.h"
#include "spectral/colour.h"

namespace karat {
namespace {

Colour of_bytes(int red, int green, int blue) {
  return {red / 255.0, green / 255.0, blue / 255.0, 1.0};
}

// Lab of an sRGB colour against D65.
Lab lab_of(const Colour& colour) {
  const Rgb linear = {srgb_decode(colour.red), srgb_decode(colour.green), srgb_decode(colour.blue)};
  return lab_of_xyz(xyz_of_linear_srgb(linear), xyz_of_linear_srgb({1.0, 1.0, 1.0}));
}

Colour of_lab(const Lab& lab) {
  const Rgb linear = linear_srgb_of_xyz(xyz_of_lab(lab, xyz_of_linear_srgb({1.0, 1.0, 1.0})));
  const auto encoded = [](double value) { return srgb_encode(std::clamp(value, 0.0, 1.0)); };
  return {encoded(linear[0]), encoded(linear[1]), encoded(linear[2]), 1.0};
}

// Through the points evenly in lightness, hue and chroma joined by straight lines of CIELAB.
Colour along(const std::vector<Colour>& points, double t) {
  const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(points.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), points.size() - 2);
  const double u = place - static_cast<double>(i);
  const Lab a = lab_of(points[i]), b = lab_of(points[i + 1]);
  return of_lab({a[0] + u * (b[0] - a[0]), a[1] + u * (b[1] - a[1]), a[2] + u * (b[2] - a[2])});
}

}  // namespace

// Okabe and Ito, "Color Universal Design" (2008): black, blue, vermilion, bluish green, reddish
// purple, orange, sky blue; the most distinct first.
Colour series_colour(std::size_t index) {
  static const Colour kColours[] = {
      of_bytes(0, 114, 178), of_bytes(213, 94, 0),   of_bytes(0, 158, 115), of_bytes(204, 121, 167),
      of_bytes(230, 159, 0), of_bytes(86, 180, 233), of_bytes(0, 0, 0)};
  return kColours[index % std::size(kColours)];
}

Colour mapped_colour(double value_0_to_1, ColourMap map) {
  // Lightness L* rises in equal steps from 15 to 91, hue turns from violet over green to yellow.
  static const std::vector<Colour> kSequential = {
      of_lab({15.0, 40.0, -32.0}), of_lab({34.0, 15.0, -38.0}), of_lab({53.0, -26.0, -9.0}),
      of_lab({72.0, -44.0, 46.0}), of_lab({91.0, -13.0, 86.0})};
  static const std::vector<Colour> kDiverging = {
      of_lab({36.0, 2.0, -45.0}), of_lab({66.0, -6.0, -28.0}), of_lab({96.0, 0.0, 0.0}),
      of_lab({66.0, 36.0, 34.0}), of_lab({36.0, 52.0, 40.0})};
  return along(map == ColourMap::kSequential ? kSequential : kDiverging, value_0_to_1);
}

}  // namespace karat
