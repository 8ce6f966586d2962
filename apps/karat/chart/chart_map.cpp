// Heat maps and their colour bars.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/karat/chart/parts.h"

namespace karat {
namespace {

constexpr Colour kNoValue{0.8, 0.8, 0.8, 1.0};

// The range of colours. Where only the data tell, a diverging map is symmetric about 0.
Scale colour_scale(const HeatMap& map) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : map.values) {
    if (!std::isfinite(value) || (map.log && value <= 0.0)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) low = high = map.log ? 1.0 : 0.0;
  if (map.map == ColourMap::kDiverging && !map.min && !map.max && !map.log) {
    high = std::max(std::abs(low), std::abs(high));
    low = -high;
  }
  Scale scale{map.min.value_or(low), map.max.value_or(high), map.log, 0.0, 1.0};
  if (!(scale.max > scale.min)) {
    scale.max = map.log ? scale.min * 10.0 : scale.min + std::max(1e-12, std::abs(scale.min));
  }
  return scale;
}

void draw_cells(Canvas& canvas, const PlacedPanel& placed, const Scale& colours) {
  const HeatMap& map = *placed.panel->map;
  std::vector<Colour> cells;
  for (std::size_t row = map.rows; row-- > 0;) {
    for (std::size_t column = 0; column < map.columns; ++column) {
      const double value = map.values[row * map.columns + column];
      // What a logarithm does not know lies below every value that it does.
      const bool below = map.log && value <= 0.0;
      const double share = below ? 0.0 : colours.pixel(value);
      // 256 steps: finer ones nobody sees, and equal neighbours make small files.
      cells.push_back(std::isfinite(share)
                          ? mapped_colour(std::round(share * 255.0) / 255.0, map.map)
                          : kNoValue);
    }
  }
  const double left = placed.x.pixel(map.x_range[0]), right = placed.x.pixel(map.x_range[1]);
  const double top = placed.y.pixel(map.y_range[1]), bottom = placed.y.pixel(map.y_range[0]);
  canvas.cells({left, top, right - left, bottom - top}, map.columns, cells);
}

// Values beyond the bar, which show its end colours, are said in words at its ends.
std::string beyond_sign(const HeatMap& map, const Scale& colours, bool above) {
  const bool beyond = std::any_of(map.values.begin(), map.values.end(), [&](double value) {
    return std::isfinite(value) && (above ? value > colours.max : value < colours.min);
  });
  return !beyond ? "" : above ? "≥ " : "≤ ";
}

void draw_bar(Canvas& canvas, const PlacedPanel& placed, const Scale& colours) {
  const HeatMap& map = *placed.panel->map;
  const Box bar{placed.box.right() + 12.0, placed.box.top, 13.0, placed.box.height};
  std::vector<Colour> steps;
  for (int i = 255; i >= 0; --i) steps.push_back(mapped_colour(i / 255.0, map.map));
  canvas.cells(bar, 1, steps);
  Scale scale = colours;
  scale.from_pixel = bar.bottom();
  scale.to_pixel = bar.top;
  double widest = 0.0;
  const TextStyle style{kTickSize, false, {0.25, 0.25, 0.25, 1.0}, Align::kStart, false};
  for (const Tick& tick : axis_ticks(scale, kTickSpacingY)) {
    const double y = scale.pixel(tick.value);
    const bool major = !tick.text.empty();
    canvas.line({{bar.right(), y}, {bar.right() + (major ? 4.0 : 2.0), y}}, {{0, 0, 0, 1}, 0.8});
    canvas.text({bar.right() + 6.0, y + 0.36 * kTickSize}, tick.text, style);
    widest = std::max(widest, text_width(tick.text, style));
  }
  canvas.text({bar.left + 0.5 * bar.width, bar.top - 4.0}, beyond_sign(map, colours, true),
              {kTickSize, false, style.colour, Align::kMiddle, false});
  canvas.text({bar.left + 0.5 * bar.width, bar.bottom() + 11.0}, beyond_sign(map, colours, false),
              {kTickSize, false, style.colour, Align::kMiddle, false});
  canvas.text({bar.right() + 6.0 + widest + 4.0 + kAxisSize, bar.top + 0.5 * bar.height}, map.title,
              {kAxisSize, false, {0.13, 0.13, 0.13, 1.0}, Align::kMiddle, true});
}

}  // namespace

void draw_map(Canvas& canvas, const PlacedPanel& placed) {
  if (!placed.panel->map || placed.panel->map->values.empty()) return;
  const Scale colours = colour_scale(*placed.panel->map);
  canvas.clipped(placed.box, [&] { draw_cells(canvas, placed, colours); });
  draw_bar(canvas, placed, colours);
}

}  // namespace karat
