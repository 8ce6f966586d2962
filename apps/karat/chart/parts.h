// The parts of a chart, each drawn by one function.
#pragma once

#include <string>
#include <vector>

#include "apps/karat/chart/canvas.h"
#include "apps/karat/chart/scale.h"

namespace karat {

inline constexpr double kTickSize = 10.5, kAxisSize = 11.5;  // letters in pixels
inline constexpr double kTickSpacingX = 58.0, kTickSpacingY = 26.0;
inline constexpr double kMapBarWidth = 74.0;  // what a map's colour bar takes right of the panel

// A panel with its place and its scales.
struct PlacedPanel {
  const Panel* panel = nullptr;
  Box box;  // of the data, inside the axes
  Scale x, y;
  bool names_x = true, names_y = true;  // tick labels and axis title
};

// Scales that hold all values of the panels, as their axes ask. Throws InputError.
Scale scale_of_x(const std::vector<const Panel*>& panels);
Scale scale_of_y(const std::vector<const Panel*>& panels, const Scale& x);

// Background, bands and grid; then what is measured; then frame, ticks and titles.
void draw_background(Canvas& canvas, const PlacedPanel& placed);
void draw_map(Canvas& canvas, const PlacedPanel& placed);
void draw_lines(Canvas& canvas, const PlacedPanel& placed);
void draw_labels(Canvas& canvas, const PlacedPanel& placed);
void draw_axes(Canvas& canvas, const PlacedPanel& placed);
void draw_spectrum_strip(Canvas& canvas, const PlacedPanel& placed);

// Room for the labels of the y axis, and below the x axis, in pixels.
double y_axis_width(const Panel& panel, const Scale& y);
double x_axis_height(const Panel& panel);

// A marker around a point; also drawn in the legend.
void draw_marker(Canvas& canvas, Marker marker, Point at, double size, const Colour& colour);

// The entries of all panels in lines from `top`, no wider than `width`; returns their height.
double draw_legend(Canvas* canvas, const Chart& chart, double left, double top, double width);

}  // namespace karat
