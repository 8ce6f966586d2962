// How wide a text is: cairo asks the fonts of the machine, without hinting, for PNG and SVG alike.
#include <cairo.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/karat/chart/canvas.h"

namespace karat {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

}  // namespace

// nlohmann-json replaces what is not UTF-8 when it writes.
std::string valid_utf8(const std::string& text) {
  using nlohmann::json;
  const std::string quoted = json(text).dump(-1, ' ', false, json::error_handler_t::replace);
  return json::parse(quoted).get<std::string>();
}

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
  cairo_text_extents(context.get(), valid_utf8(text).c_str(), &extents);
  return extents.x_advance * style.size / kMeasured;
}

std::vector<std::string> broken_lines(const std::string& text, const TextStyle& style,
                                      double width) {
  std::vector<std::string> lines;
  std::istringstream paragraphs(text);
  for (std::string paragraph; std::getline(paragraphs, paragraph);) {
    std::istringstream words(paragraph);
    std::string line;
    for (std::string word; words >> word;) {
      const std::string longer = line.empty() ? word : line + " " + word;
      if (!line.empty() && text_width(longer, style) > width) {
        lines.push_back(line);
        line = word;
      } else {
        line = longer;
      }
    }
    if (!line.empty()) lines.push_back(line);
  }
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
