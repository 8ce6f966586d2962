// The legend: entries side by side above the panels, in as many lines as they need.
#include <algorithm>

#include "apps/karat/chart/parts.h"

namespace karat {
namespace {

constexpr double kSample = 26.0, kGap = 18.0, kLineHeight = 18.0, kSize = 11.5;

std::vector<const Series*> entries_of(const Chart& chart) {
  std::vector<const Series*> entries;
  for (const Panel& panel : chart.panels) {
    for (const Series& series : panel.series) {
      const bool known = std::any_of(entries.begin(), entries.end(), [&](const Series* entry) {
        return entry->name == series.name;
      });
      if (!series.name.empty() && !known) entries.push_back(&series);
    }
  }
  return entries;
}

// Markers alone need less room than a line.
double sample_width(const Series& series) { return series.width > 0.0 ? kSample : 10.0; }

void draw_entry(Canvas& canvas, const Series& series, double x, double y) {
  const double middle = y - 0.35 * kSize;
  if (series.width > 0.0) {
    canvas.line({{x, middle}, {x + kSample, middle}}, {series.colour, series.width, series.dash});
  }
  const double sample = sample_width(series);
  draw_marker(canvas, series.marker, {x + 0.5 * sample, middle}, series.marker_size, series.colour);
  canvas.text({x + sample + 6.0, y}, series.name, {kSize});
}

}  // namespace

double draw_legend(Canvas* canvas, const Chart& chart, double left, double top, double width) {
  const std::vector<const Series*> entries = entries_of(chart);
  if (entries.empty()) return 0.0;
  double x = left, y = top + 13.0;
  for (const Series* series : entries) {
    const double needed = sample_width(*series) + 6.0 + text_width(series->name, {kSize});
    if (x > left && x + needed > left + width) x = left, y += kLineHeight;
    if (canvas) draw_entry(*canvas, *series, x, y);
    x += needed + kGap;
  }
  return y + 6.0 - top;
}

}  // namespace karat
