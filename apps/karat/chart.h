// Charts for commands and reports: lines, points and maps, as SVG or PNG from one description.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace karat {

// Nonlinear sRGB in [0, 1], with opacity.
struct Colour {
  double red = 0.0, green = 0.0, blue = 0.0, alpha = 1.0;
};

// Colours that people with any kind of colour vision tell apart (Okabe and Ito 2008), without its
// yellow, which is too light for lines on white; the index wraps around.
Colour series_colour(std::size_t index);

enum class Dash { kSolid, kDashed, kDotted, kDashDotted };
enum class Marker { kNone, kCircle, kSquare, kTriangle, kDiamond, kCross, kBar };

// Values over an axis. A value that is not finite, or not positive on a logarithmic axis, is a gap.
struct Series {
  std::string name;          // in the legend; series of one name share an entry, "" has none
  std::vector<double> x, y;  // of equal length
  Colour colour;
  Dash dash = Dash::kSolid;
  double width = 1.6;               // of the line in pixels; 0: markers alone
  Marker marker = Marker::kNone;    // at every point, or
  std::vector<std::size_t> marked;  // at these points only, where not empty
  double marker_size = 5.0;         // pixels
  std::vector<std::string> labels;  // of the points, as many as points, or none
};

struct Axis {
  std::string title;  // with the unit: "wavelength (nm)"
  bool log = false;
  std::optional<double> min, max;  // otherwise what the values need
};

// A shaded interval of x, behind everything; labelled at its upper end.
struct Band {
  double from = 0.0, to = 0.0;
  Colour colour{0.0, 0.0, 0.0, 0.05};
  std::string label;
};

// A line across the whole panel at a value of x, or of y.
struct Rule {
  double value = 0.0;
  bool across_x = false;  // true: at a value of y, running along x
  Colour colour{0.45, 0.45, 0.45, 1.0};
  Dash dash = Dash::kDashed;
  std::string label;
};

// Both run evenly in CIELAB: sequential from dark violet to yellow, diverging from blue over white,
// which stands for the middle of the range, to red.
enum class ColourMap { kSequential, kDiverging };
Colour mapped_colour(double value_0_to_1, ColourMap map);

// Values on a grid of equal cells that fills the ranges of x and y; beyond `min` and `max` the end
// colours hold and the bar says so; not finite: grey.
struct HeatMap {
  std::size_t columns = 0, rows = 0;
  std::vector<double> values;  // rows * columns, row by row from the smallest y
  std::array<double, 2> x_range{0.0, 1.0}, y_range{0.0, 1.0};  // outer edges of the cells
  std::string title;                                           // of the colour bar, with the unit
  bool log = false;
  std::optional<double> min, max;
  ColourMap map = ColourMap::kSequential;
};

// One coordinate system: a map or not, and any number of series upon it.
struct Panel {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
  std::vector<Band> bands;
  std::vector<Rule> rules;
  std::optional<HeatMap> map;
  // Above 0: x is a wavelength in units of so many nm, and the colours of the visible spectrum run
  // along the axis.
  double spectrum_unit_nm = 0.0;
};

// Panels row by row, `columns` in each. The legend stands above them, the caption below: neither
// covers data. Lines that are too long are broken, others where a
// newline stands. Text is UTF-8; bytes that are not are replaced.
struct Chart {
  std::string title;
  std::string subtitle;
  std::vector<Panel> panels;
  std::size_t columns = 1;
  bool share_x = true;   // panels of one column have one range of x, written below the last
  bool share_y = false;  // panels of one row have one range of y, written left of the first
  std::string caption;   // source, conditions
  double width = 760.0, height = 520.0;  // pixels of 1/96 inch
  double png_scale = 2.0;                // pixels of a PNG per pixel of the chart
};

// Writes FILE.svg or FILE.png, whole or not at all; the same bytes for the same chart (on one
// machine: the widths of letters come from its fonts). Throws InputError for another extension or a
// chart whose numbers do not fit together, RuntimeError where the file cannot be written.
void draw_chart(const Chart& chart, const std::string& path);

// The same as SVG text, to be put into a page; it has no ids that could clash there.
std::string chart_svg(const Chart& chart);

}  // namespace karat
