// What stands around the data: bands, grid, frame, ticks and titles.
#include <algorithm>
#include <cmath>

#include "apps/karat/chart/parts.h"

namespace karat {
namespace {

constexpr Colour kGrid{0.9, 0.9, 0.9, 1.0}, kFrame{0.35, 0.35, 0.35, 1.0};
constexpr Colour kTickText{0.25, 0.25, 0.25, 1.0}, kNote{0.4, 0.4, 0.4, 1.0};

void draw_bands(Canvas& canvas, const PlacedPanel& placed) {
  const Box& box = placed.box;
  for (const Band& band : placed.panel->bands) {
    const double a = placed.x.pixel(std::max(band.from, placed.x.min));
    const double b = placed.x.pixel(std::min(band.to, placed.x.max));
    const double left = std::clamp(std::min(a, b), box.left, box.right());
    const double right = std::clamp(std::max(a, b), box.left, box.right());
    if (!(right > left)) continue;
    canvas.rectangle({left, box.top, right - left, box.height}, band.colour);
  }
}

// Over the grid, on a ground that keeps its lines away from the letters.
void draw_band_labels(Canvas& canvas, const PlacedPanel& placed) {
  const Box& box = placed.box;
  const TextStyle style{9.5, false, kNote, Align::kMiddle, false};
  for (const Band& band : placed.panel->bands) {
    const double left = placed.x.pixel(std::max(band.from, placed.x.min));
    const double right = placed.x.pixel(std::min(band.to, placed.x.max));
    const double width = text_width(band.label, style), middle = 0.5 * (left + right);
    if (band.label.empty() || !(width < right - left - 4.0)) continue;
    canvas.rectangle({middle - 0.5 * width - 3.0, box.top + 3.0, width + 6.0, 13.0},
                     {1.0, 1.0, 1.0, 0.8});
    canvas.text({middle, box.top + 13.0}, band.label, style);
  }
}

void draw_grid(Canvas& canvas, const PlacedPanel& placed) {
  const Box& box = placed.box;
  for (const Tick& tick : axis_ticks(placed.x, kTickSpacingX)) {
    if (tick.text.empty()) continue;
    const double x = placed.x.pixel(tick.value);
    canvas.line({{x, box.top}, {x, box.bottom()}}, {kGrid, 0.8});
  }
  for (const Tick& tick : axis_ticks(placed.y, kTickSpacingY)) {
    if (tick.text.empty()) continue;
    const double y = placed.y.pixel(tick.value);
    canvas.line({{box.left, y}, {box.right(), y}}, {kGrid, 0.8});
  }
}

void draw_rules(Canvas& canvas, const PlacedPanel& placed) {
  const Box& box = placed.box;
  for (const Rule& rule : placed.panel->rules) {
    const Scale& scale = rule.across_x ? placed.y : placed.x;
    if (!(rule.value >= scale.min && rule.value <= scale.max)) continue;
    const double at = scale.pixel(rule.value);
    const Stroke stroke{rule.colour, 1.0, rule.dash};
    if (rule.across_x) {
      canvas.line({{box.left, at}, {box.right(), at}}, stroke);
      canvas.text({box.right() - 4.0, at - 4.0}, rule.label,
                  {9.5, false, kNote, Align::kEnd, false});
    } else {
      canvas.line({{at, box.top}, {at, box.bottom()}}, stroke);
      canvas.text({at - 4.0, box.top + 6.0}, rule.label, {9.5, false, kNote, Align::kEnd, true});
    }
  }
}

void draw_x_ticks(Canvas& canvas, const PlacedPanel& placed) {
  const Box& box = placed.box;
  for (const Tick& tick : axis_ticks(placed.x, kTickSpacingX)) {
    const double x = placed.x.pixel(tick.value);
    const double length = tick.text.empty() ? 2.5 : 4.5;
    canvas.line({{x, box.bottom()}, {x, box.bottom() + length}}, {kFrame, 0.9});
    if (!placed.names_x) continue;
    canvas.text({x, box.bottom() + 16.0}, tick.text,
                {kTickSize, false, kTickText, Align::kMiddle, false});
  }
}

void draw_y_ticks(Canvas& canvas, const PlacedPanel& placed) {
  const Box& box = placed.box;
  for (const Tick& tick : axis_ticks(placed.y, kTickSpacingY)) {
    const double y = placed.y.pixel(tick.value);
    const double length = tick.text.empty() ? 2.5 : 4.5;
    canvas.line({{box.left - length, y}, {box.left, y}}, {kFrame, 0.9});
    if (!placed.names_y) continue;
    canvas.text({box.left - 7.0, y + 0.36 * kTickSize}, tick.text,
                {kTickSize, false, kTickText, Align::kEnd, false});
  }
}

}  // namespace

void draw_background(Canvas& canvas, const PlacedPanel& placed) {
  draw_bands(canvas, placed);
  draw_grid(canvas, placed);
  draw_band_labels(canvas, placed);
}

void draw_axes(Canvas& canvas, const PlacedPanel& placed) {
  const Box& box = placed.box;
  draw_rules(canvas, placed);
  canvas.line({{box.left, box.top},
               {box.right(), box.top},
               {box.right(), box.bottom()},
               {box.left, box.bottom()},
               {box.left, box.top}},
              {kFrame, 0.9});
  draw_x_ticks(canvas, placed);
  draw_y_ticks(canvas, placed);
  if (placed.names_x) {
    canvas.text({box.left + 0.5 * box.width, box.bottom() + 34.0}, placed.panel->x.title,
                {kAxisSize, false, {0.13, 0.13, 0.13, 1.0}, Align::kMiddle, false});
  }
  if (placed.names_y) {
    const double left = box.left - y_axis_width(*placed.panel, placed.y);
    canvas.text({left + kAxisSize, box.top + 0.5 * box.height}, placed.panel->y.title,
                {kAxisSize, false, {0.13, 0.13, 0.13, 1.0}, Align::kMiddle, true});
  }
  canvas.text({box.left, box.top - 6.0}, placed.panel->title,
              {kAxisSize, true, {0.13, 0.13, 0.13, 1.0}, Align::kStart, false});
}

double y_axis_width(const Panel& panel, const Scale& y) {
  double widest = 0.0;
  for (const Tick& tick : axis_ticks(y, kTickSpacingY)) {
    widest = std::max(widest, text_width(tick.text, {kTickSize}));
  }
  return widest + 9.0 + (panel.y.title.empty() ? 2.0 : kAxisSize + 7.0);
}

double x_axis_height(const Panel& panel) { return panel.x.title.empty() ? 22.0 : 40.0; }

}  // namespace karat
