// Drawings as PNG: cairo draws them and writes the file.
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "apps/karat/chart/canvas.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

class CairoCanvas final : public Canvas {
 public:
  explicit CairoCanvas(cairo_t* context) : c_(context) {
    cairo_set_line_join(c_, CAIRO_LINE_JOIN_ROUND);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_set_font_options(c_, options);
    cairo_font_options_destroy(options);
  }

  void line(const std::vector<Point>& points, const Stroke& stroke) override {
    trace(points);
    set(stroke.colour);
    cairo_set_line_width(c_, stroke.width);
    const std::vector<double> dashes = dash_lengths(stroke.dash, stroke.width);
    cairo_set_dash(c_, dashes.data(), static_cast<int>(dashes.size()), 0.0);
    cairo_stroke(c_);
  }

  void polygon(const std::vector<Point>& points, const Colour& fill) override {
    trace(points);
    cairo_close_path(c_);
    set(fill);
    cairo_fill(c_);
  }

  void circle(Point centre, double radius, const Colour& fill) override {
    cairo_new_path(c_);
    cairo_arc(c_, centre.x, centre.y, radius, 0.0, 2.0 * std::numbers::pi);
    set(fill);
    cairo_fill(c_);
  }

  void rectangle(const Box& box, const Colour& fill) override {
    cairo_rectangle(c_, box.left, box.top, box.width, box.height);
    set(fill);
    cairo_fill(c_);
  }

  void text(Point at, const std::string& text, const TextStyle& style) override {
    cairo_save(c_);
    cairo_select_font_face(c_, kChartFont, CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(c_, style.size);
    cairo_translate(c_, at.x, at.y);
    if (style.upwards) cairo_rotate(c_, -0.5 * std::numbers::pi);
    const double share = style.align == Align::kStart ? 0.0
                         : style.align == Align::kEnd ? 1.0
                                                      : 0.5;
    cairo_move_to(c_, -share * text_width(text, style), 0.0);
    set(style.colour);
    cairo_show_text(c_, valid_utf8(text).c_str());
    cairo_restore(c_);
  }

  void cells(const Box& box, std::size_t columns, const std::vector<Colour>& colours) override {
    cairo_save(c_);
    cairo_set_antialias(c_, CAIRO_ANTIALIAS_NONE);
    const std::size_t rows = columns == 0 ? 0 : colours.size() / columns;
    // Edges at whole pixels of the file: no seam, and no cell over its neighbour.
    const double width = box.width / static_cast<double>(columns);
    const double height = box.height / static_cast<double>(rows);
    for (std::size_t i = 0; i < rows * columns; ++i) {
      double left = box.left + width * static_cast<double>(i % columns);
      double top = box.top + height * static_cast<double>(i / columns);
      double right = left + width, bottom = top + height;
      snap(left, top);
      snap(right, bottom);
      rectangle({left, top, right - left, bottom - top}, colours[i]);
    }
    cairo_restore(c_);
  }

  void clipped(const Box& box, const std::function<void()>& draw) override {
    cairo_save(c_);
    cairo_rectangle(c_, box.left, box.top, box.width, box.height);
    cairo_clip(c_);
    draw();
    cairo_restore(c_);
  }

 private:
  void set(const Colour& colour) {
    cairo_set_source_rgba(c_, colour.red, colour.green, colour.blue, colour.alpha);
  }
  void snap(double& x, double& y) {
    cairo_user_to_device(c_, &x, &y);
    x = std::round(x), y = std::round(y);
    cairo_device_to_user(c_, &x, &y);
  }
  void trace(const std::vector<Point>& points) {
    cairo_new_path(c_);
    for (const Point& point : points) cairo_line_to(c_, point.x, point.y);
  }

  cairo_t* c_;
};

}  // namespace

void write_png_drawing(const std::string& path, double width, double height, double scale,
                       const Drawing& draw) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width * scale + 0.5),
                                 static_cast<int>(height * scale + 0.5)),
      cairo_surface_destroy);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(cairo_create(surface.get()),
                                                                   cairo_destroy);
  cairo_scale(context.get(), scale, scale);
  CairoCanvas canvas(context.get());
  canvas.rectangle({0.0, 0.0, width, height}, {1.0, 1.0, 1.0, 1.0});
  draw(canvas);
  cairo_status_t status = cairo_status(context.get());
  if (status == CAIRO_STATUS_SUCCESS) {
    status = cairo_surface_write_to_png(surface.get(), path.c_str());
  }
  if (status != CAIRO_STATUS_SUCCESS) throw RuntimeError(cairo_status_to_string(status));
}

}  // namespace karat
