// Series: lines with gaps where there are no values, and markers.
#include <cmath>
#include <numbers>

#include "apps/karat/chart/parts.h"

namespace karat {
namespace {

std::vector<Point> regular(Point centre, double radius, int corners, double first_deg) {
  std::vector<Point> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = (first_deg + 360.0 * i / corners) * std::numbers::pi / 180.0;
    points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return points;
}

void draw_series_line(Canvas& canvas, const Series& series, const std::vector<Point>& points) {
  if (!(series.width > 0.0)) return;
  std::vector<Point> run;
  const auto finish = [&] {
    if (run.size() > 1) canvas.line(run, {series.colour, series.width, series.dash});
    run.clear();
  };
  for (const Point& point : points) {
    if (std::isfinite(point.x) && std::isfinite(point.y)) {
      run.push_back(point);
    } else {
      finish();
    }
  }
  finish();
}

void draw_markers(Canvas& canvas, const Series& series, const std::vector<Point>& points) {
  const auto draw = [&](std::size_t i) {
    if (i < points.size() && std::isfinite(points[i].x) && std::isfinite(points[i].y)) {
      draw_marker(canvas, series.marker, points[i], series.marker_size, series.colour);
    }
  };
  if (series.marker == Marker::kNone) return;
  if (series.marked.empty()) {
    for (std::size_t i = 0; i < points.size(); ++i) draw(i);
  } else {
    for (const std::size_t i : series.marked) draw(i);
  }
}

// Beyond the frame only the direction matters, and renderers dislike coordinates of millions.
double held(double pixel, double low, double high) {
  const double reach = 10.0 * (high - low);
  return std::isfinite(pixel) ? std::min(std::max(pixel, low - reach), high + reach) : pixel;
}

}  // namespace

void draw_marker(Canvas& canvas, Marker marker, Point at, double size, const Colour& colour) {
  const double r = 0.5 * size;
  switch (marker) {
    case Marker::kNone:
      return;
    case Marker::kCircle:
      return canvas.circle(at, r, colour);
    case Marker::kSquare:
      return canvas.rectangle({at.x - 0.9 * r, at.y - 0.9 * r, 1.8 * r, 1.8 * r}, colour);
    case Marker::kTriangle:
      return canvas.polygon(regular(at, 1.25 * r, 3, -90.0), colour);
    case Marker::kDiamond:
      return canvas.polygon(regular(at, 1.25 * r, 4, -90.0), colour);
    case Marker::kBar:
      return canvas.line({{at.x, at.y - r}, {at.x, at.y + r}}, {colour, 1.5, Dash::kSolid});
    case Marker::kCross:
      canvas.line({{at.x - r, at.y - r}, {at.x + r, at.y + r}}, {colour, 1.5, Dash::kSolid});
      canvas.line({{at.x - r, at.y + r}, {at.x + r, at.y - r}}, {colour, 1.5, Dash::kSolid});
      return;
  }
}

void draw_lines(Canvas& canvas, const PlacedPanel& placed) {
  const Box& box = placed.box;
  for (const Series& series : placed.panel->series) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      points.push_back({held(placed.x.pixel(series.x[i]), box.left, box.right()),
                        held(placed.y.pixel(series.y[i]), box.top, box.bottom())});
    }
    draw_series_line(canvas, series, points);
    draw_markers(canvas, series, points);
  }
}

}  // namespace karat
