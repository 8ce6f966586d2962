// How wide a text is: cairo asks the fonts of the machine, without hinting, for PNG and SVG alike.
#include <cairo.h>

#include <memory>

#include "apps/karat/chart/canvas.h"

namespace karat {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

}  // namespace

double text_width(const std::string& text, const TextStyle& style) {
  const Surface surface(cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, nullptr),
                        cairo_surface_destroy);
  const Context context(cairo_create(surface.get()), cairo_destroy);
  cairo_select_font_face(context.get(), kChartFont, CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  // Measured large and scaled down: advances are rounded to whole pixels of the measured size.
  constexpr double kMeasured = 1000.0;
  cairo_set_font_size(context.get(), kMeasured);
  cairo_text_extents_t extents;
  cairo_text_extents(context.get(), text.c_str(), &extents);
  return extents.x_advance * style.size / kMeasured;
}

std::vector<std::string> broken_lines(const std::string& text, const TextStyle& style,
                                      double width) {
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t start = 0; start < text.size();) {
    std::size_t end = text.find(' ', start);
    if (end == std::string::npos) end = text.size();
    const std::string word = text.substr(start, end - start);
    start = end + 1;
    const std::string longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && text_width(longer, style) > width) {
      lines.push_back(line);
      line = word;
    } else {
      line = longer;
    }
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

std::vector<double> dash_lengths(Dash dash, double width) {
  switch (dash) {
    case Dash::kSolid:
      return {};
    case Dash::kDashed:
      return {4.0 * width, 2.0 * width};
    case Dash::kDotted:
      return {1.0 * width, 1.6 * width};
    case Dash::kDashDotted:
      return {4.0 * width, 1.6 * width, 1.0 * width, 1.6 * width};
  }
  return {};
}

}  // namespace karat
