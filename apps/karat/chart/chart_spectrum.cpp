// A strip of the visible spectrum's colours along a wavelength axis.
#include <algorithm>
#include <cmath>

#include "apps/karat/chart/parts.h"
#include "spectral/colour.h"
#include "spectral/observer.h"

namespace karat {
namespace {

// Monochromatic light lies outside every display's gamut: negative channels are cut off, the
// brightest is raised to 1, and the ends of the spectrum fade to the paper's white.
Colour spectral_colour(const Observer& eye, double nm) {
  const Xyz xyz = {eye[0](nm), eye[1](nm), eye[2](nm)};
  Rgb rgb = linear_srgb_of_xyz(xyz);
  const double largest = std::max({rgb[0], rgb[1], rgb[2], 1e-9});
  const double strength = std::min(1.0, std::sqrt((xyz[0] + xyz[1] + xyz[2]) / 0.25));
  for (double& channel : rgb) {
    channel = 1.0 - strength * (1.0 - srgb_encode(std::max(0.0, channel / largest)));
  }
  return {rgb[0], rgb[1], rgb[2], 1.0};
}

}  // namespace

void draw_spectrum_strip(Canvas& canvas, const PlacedPanel& placed) {
  constexpr double kHeight = 5.0, kFirst = 380.0, kLast = 780.0;
  const Observer& eye = observer();
  const double unit = placed.panel->spectrum_unit_nm;
  const double low = std::max(kFirst / unit, placed.x.min);
  const double high = std::min(kLast / unit, placed.x.max);
  if (!(high > low)) return;
  const double left = placed.x.pixel(low), right = placed.x.pixel(high);
  const int count = std::clamp(static_cast<int>(right - left), 1, 200);
  std::vector<Colour> colours;
  for (int i = 0; i < count; ++i) {
    const double share = (i + 0.5) / count;
    const double at = placed.x.log ? low * std::pow(high / low, share) : low + (high - low) * share;
    colours.push_back(spectral_colour(eye, at * unit));
  }
  canvas.cells({left, placed.box.bottom() - kHeight, right - left, kHeight}, colours.size(),
               colours);
}

}  // namespace karat
