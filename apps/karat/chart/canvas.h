// What charts are drawn on: pixels with y downwards, SVG or PNG behind it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/karat/chart.h"

namespace karat {

struct Point {
  double x = 0.0, y = 0.0;
};

struct Box {
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

struct Stroke {
  Colour colour;
  double width = 1.0;
  Dash dash = Dash::kSolid;
};

enum class Align { kStart, kMiddle, kEnd };

struct TextStyle {
  double size = 12.0;
  bool bold = false;
  Colour colour{0.13, 0.13, 0.13, 1.0};
  Align align = Align::kStart;
  bool upwards = false;  // turned by 90 degrees, reading from below
};

class Canvas {
 public:
  virtual ~Canvas() = default;
  virtual void line(const std::vector<Point>& points, const Stroke& stroke) = 0;
  virtual void polygon(const std::vector<Point>& points, const Colour& fill) = 0;
  virtual void circle(Point centre, double radius, const Colour& fill) = 0;
  virtual void rectangle(const Box& box, const Colour& fill) = 0;
  // `at` is on the baseline.
  virtual void text(Point at, const std::string& text, const TextStyle& style) = 0;
  // Equal cells, row by row from the top, without seams between them.
  virtual void cells(const Box& box, std::size_t columns, const std::vector<Colour>& colours) = 0;
  // Whatever `draw` draws is cut off at `box`.
  virtual void clipped(const Box& box, const std::function<void()>& draw) = 0;
};

// The text with bytes that are not UTF-8 replaced: neither fonts nor XML know them.
std::string valid_utf8(const std::string& text);

// Width of a text in pixels.
double text_width(const std::string& text, const TextStyle& style);

// `text` in lines no wider than `width`, broken at newlines and
// blanks; a longer word stands alone.
std::vector<std::string> broken_lines(const std::string& text, const TextStyle& style,
                                      double width);

// Lengths of dashes and gaps of a line of that width in pixels; none for a solid line.
std::vector<double> dash_lengths(Dash dash, double width);

inline constexpr const char* kChartFont = "DejaVu Sans";

// Draws `draw` on a canvas of that size.
using Drawing = std::function<void(Canvas&)>;
std::string svg_drawing(double width, double height, const std::string& title, const Drawing& draw);
void write_png_drawing(const std::string& path, double width, double height, double scale,
                       const Drawing& draw);

}  // namespace karat
