// Labels of points: beside their points, where they cover neither each other nor a marker.
#include <array>
#include <cmath>

#include "apps/karat/chart/parts.h"

namespace karat {
namespace {

constexpr double kSize = 10.0;

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

// Places around a point, the preferred first; `r` keeps clear of the marker.
std::array<Box, 8> places_around(Point at, double width, double r) {
  const double d = 0.7 * r;
  return {{{at.x + r, at.y - 0.5 * kSize, width, kSize},
           {at.x - r - width, at.y - 0.5 * kSize, width, kSize},
           {at.x - 0.5 * width, at.y - r - kSize, width, kSize},
           {at.x - 0.5 * width, at.y + r, width, kSize},
           {at.x + d, at.y - d - kSize, width, kSize},
           {at.x + d, at.y + d, width, kSize},
           {at.x - d - width, at.y - d - kSize, width, kSize},
           {at.x - d - width, at.y + d, width, kSize}}};
}

// How much a label at `place` would hide or be cut off.
double cost_of(const Box& place, const Box& frame, const std::vector<Box>& taken) {
  double cost = 0.0;
  if (place.left < frame.left || place.right() > frame.right()) cost += 10.0;
  if (place.top < frame.top || place.bottom() > frame.bottom()) cost += 10.0;
  for (const Box& other : taken) cost += overlap(place, other) ? 1.0 : 0.0;
  return cost;
}

}  // namespace

void draw_labels(Canvas& canvas, const PlacedPanel& placed) {
  struct Label {
    Point at;
    const std::string* text;
    const Series* series;
  };
  std::vector<Label> labels;
  std::vector<Box> taken;
  for (const Series& series : placed.panel->series) {
    for (std::size_t i = 0; i < series.labels.size(); ++i) {
      const Point at{placed.x.pixel(series.x[i]), placed.y.pixel(series.y[i])};
      if (!std::isfinite(at.x) || !std::isfinite(at.y)) continue;
      const double r = 0.5 * series.marker_size;
      taken.push_back({at.x - r, at.y - r, 2.0 * r, 2.0 * r});
      labels.push_back({at, &series.labels[i], &series});
    }
  }
  for (const Label& label : labels) {
    const TextStyle style{kSize, false, label.series->colour, Align::kStart, false};
    const double width = text_width(*label.text, style);
    Box best;
    double least = 1e300;
    for (const Box& place : places_around(label.at, width, 0.5 * label.series->marker_size + 3.0)) {
      const double cost = cost_of(place, placed.box, taken);
      if (cost < least) best = place, least = cost;
    }
    taken.push_back(best);
    canvas.text({best.left, best.top + 0.86 * kSize}, *label.text, style);
  }
}

}  // namespace karat
