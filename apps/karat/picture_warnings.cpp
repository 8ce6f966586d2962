#include "apps/karat/picture_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace karat {
namespace {

// "Clearly" above white: still white when a third of a stop darker. A backdrop that is white is
// not.
constexpr float kDarker = 0.8f;
// The code value of 2 % of the display's white under the sRGB curve.
constexpr float kDarkCode = 0.15f;
// Where a picture is seen well: its 90th percentile at 70 % of white.
constexpr double kWellExposed = 0.7;
// Brightnesses this near to each other are one flat area.
constexpr float kFlat = 1.1f;

std::vector<float> colours_of(const Image& image) {
  std::vector<float> rgb;
  const std::size_t stride = image.channels.size();
  for (std::size_t i = 0; i < image.values.size(); i += stride) {
    rgb.insert(rgb.end(), &image.values[i], &image.values[i] + 3);
  }
  return rgb;
}

// The largest of each pixel's colours.
std::vector<float> largest_of(const std::vector<float>& rgb) {
  std::vector<float> largest(rgb.size() / 3);
  for (std::size_t i = 0; i < largest.size(); ++i) {
    largest[i] = std::max({rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]});
  }
  return largest;
}

std::vector<float> displayed(std::vector<float> rgb, const OcioView& view, float factor) {
  for (float& value : rgb) value *= factor;
  view.apply(rgb.data(), rgb.size() / 3);
  return largest_of(rgb);
}

// `values` are not empty and are rearranged.
float percentile(std::vector<float>& values, double fraction) {
  const auto at = values.begin() +
                  static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

std::vector<std::string> picture_warnings(const Image& image, const OcioView* view) {
  if (image.width != image.full_width || image.height != image.full_height) return {};
  const std::vector<float> rgb = colours_of(image);
  std::vector<float> lit = largest_of(rgb);
  const std::size_t pixels = lit.size();
  std::erase_if(lit, [](float value) { return !(value > 0.0f); });
  if (lit.empty()) {
    const bool black = std::all_of(rgb.begin(), rgb.end(), [](float v) { return v == 0.0f; });
    if (!black || image.channels.size() > 3) return {};
    return {"every pixel is black: is the camera inside a shape, or is there no light in view?"};
  }
  if (!view) return {};
  const float middle = percentile(lit, 0.5), high = percentile(lit, 0.9);
  if (!(high > kFlat * percentile(lit, 0.1))) return {};

  const std::vector<float> darker = displayed(rgb, *view, kDarker);
  const auto white = static_cast<std::size_t>(
      std::count_if(darker.begin(), darker.end(), [](float code) { return code >= 0.999f; }));
  const auto stops = [](float brightness) { return std::log2(kWellExposed / brightness); };
  if (2 * white > pixels) {
    // Where a lamp fills a tenth of the picture, the rest of it counts.
    const double shown = high > 16.0f * middle ? stops(middle) : stops(high);
    return {
        fmt::format("{:.0f} % of the pixels are above the display's white: --exposure {:.1f} "
                    "would show them",
                    100.0 * static_cast<double>(white) / static_cast<double>(pixels), shown)};
  }
  const std::vector<float> codes = displayed(rgb, *view, 1.0f);
  if (*std::max_element(codes.begin(), codes.end()) < kDarkCode) {
    return {
        fmt::format("even the brightest pixel is nearly black on the display: --exposure {:.1f} "
                    "would show the picture",
                    stops(high))};
  }
  return {};
}

}  // namespace karat
