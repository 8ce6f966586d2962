#include "apps/karat/nk/compare_picture.h"

#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "apps/karat/swatch.h"
#include "render/replace_file.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr double kWidth = 200.0, kHeight = 108.0, kMargin = 24.0, kHead = 62.0;
constexpr double kTextSize = 12.5, kLineHeight = 16.0;

struct Grid {
  std::size_t columns, rows;
  double width() const { return 2 * kMargin + static_cast<double>(columns) * kWidth; }
  double height() const { return kMargin + kHead + static_cast<double>(rows) * kHeight + kMargin; }
};

// About as wide as high, but never so narrow that the heading is cut.
Grid grid_of(std::size_t count) {
  const std::size_t columns = count <= 4 ? 4 : count <= 12 ? 4 : count <= 30 ? 5 : 6;
  return {columns, (count + columns - 1) / columns};
}

class Drawing {
 public:
  Drawing(cairo_surface_t* surface, double scale) : context_(cairo_create(surface)) {
    cairo_scale(context_.get(), scale, scale);
  }

  void background() {
    cairo_set_source_rgb(context_.get(), 1.0, 1.0, 1.0);
    cairo_paint(context_.get());
  }

  // Text that is wider than `widest` is set smaller.
  void text(const std::string& text, double x, double y, double size, bool bold, double grey,
            double widest) {
    cairo_select_font_face(context_.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context_.get(), size);
    cairo_text_extents_t extents;
    cairo_text_extents(context_.get(), text.c_str(), &extents);
    if (extents.width > widest) cairo_set_font_size(context_.get(), size * widest / extents.width);
    cairo_set_source_rgb(context_.get(), grey, grey, grey);
    cairo_move_to(context_.get(), x, y);
    cairo_show_text(context_.get(), text.c_str());
  }

  void swatch(const Swatch& swatch, double exposure, double x, double y) {
    double text_grey = 0.2;
    cairo_rectangle(context_.get(), x, y, kWidth, kHeight);
    if (swatch.has_colour) {
      Rgb scaled = swatch.linear_srgb;
      for (double& channel : scaled) channel *= exposure;
      const auto [r, g, b] = display_bytes(scaled);
      cairo_set_source_rgb(context_.get(), r / 255.0, g / 255.0, b / 255.0);
      cairo_fill(context_.get());
      // Luminance 0.18 is halfway from black to white for the eye.
      text_grey = xyz_of_linear_srgb(scaled)[1] > 0.18 ? 0.0 : 1.0;
    } else {
      hatch(x, y);
    }
    const double top = y + kHeight - 10.0 - kLineHeight * static_cast<double>(swatch.lines.size());
    text(swatch.name, x + 10.0, top, kTextSize, true, text_grey, kWidth - 16.0);
    for (std::size_t i = 0; i < swatch.lines.size(); ++i) {
      text(swatch.lines[i], x + 10.0, top + kLineHeight * static_cast<double>(i + 1), kTextSize,
           false, text_grey, kWidth - 16.0);
    }
  }

 private:
  void hatch(double x, double y) {
    cairo_save(context_.get());
    cairo_clip_preserve(context_.get());
    cairo_set_source_rgb(context_.get(), 0.96, 0.96, 0.96);
    cairo_fill(context_.get());
    cairo_set_source_rgb(context_.get(), 0.87, 0.87, 0.87);
    cairo_set_line_width(context_.get(), 1.0);
    for (double at = -kHeight; at < kWidth; at += 12.0) {
      cairo_move_to(context_.get(), x + at, y + kHeight);
      cairo_line_to(context_.get(), x + at + kHeight, y);
    }
    cairo_stroke(context_.get());
    cairo_restore(context_.get());
  }

  struct Destroy {
    void operator()(cairo_t* c) const { cairo_destroy(c); }
  };
  std::unique_ptr<cairo_t, Destroy> context_;
};

double common_exposure(const std::vector<Swatch>& swatches) {
  double brightest = 1.0;
  for (const Swatch& swatch : swatches) {
    if (!swatch.has_colour) continue;
    for (const double channel : swatch.linear_srgb) brightest = std::max(brightest, channel);
  }
  return 1.0 / brightest;
}

void draw(Drawing& drawing, const Grid& grid, const std::string& heading,
          const std::string& small_print, const std::vector<Swatch>& swatches) {
  const double exposure = common_exposure(swatches), widest = grid.width() - 2 * kMargin;
  drawing.background();
  drawing.text(heading, kMargin, kMargin + 16.0, 20.0, true, 0.0, widest);
  drawing.text(small_print + (exposure < 1.0 ? fmt::format("; shown at {:.3f} of their brightness, "
                                                           "so that no channel exceeds 1",
                                                           exposure)
                                             : ""),
               kMargin, kMargin + 40.0, 13.0, false, 0.25, widest);
  for (std::size_t i = 0; i < swatches.size(); ++i) {
    drawing.swatch(swatches[i], exposure, kMargin + kWidth * static_cast<double>(i % grid.columns),
                   kMargin + kHead + kHeight * static_cast<double>(i / grid.columns));
  }
}

struct DestroySurface {
  void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
};
using Surface = std::unique_ptr<cairo_surface_t, DestroySurface>;

}  // namespace

void write_swatches(const std::string& file, const std::string& heading,
                    const std::string& small_print, const std::vector<Swatch>& swatches) {
  constexpr double kPixels = 1.5;  // per unit, in PNG
  const Grid grid = grid_of(swatches.size());
  replace_file(file, [&](const std::string& temporary) {
    cairo_status_t status;
    if (file.ends_with(".svg")) {
      const Surface surface(
          cairo_svg_surface_create(temporary.c_str(), grid.width(), grid.height()));
      Drawing drawing(surface.get(), 1.0);
      draw(drawing, grid, heading, small_print, swatches);
      cairo_surface_finish(surface.get());
      status = cairo_surface_status(surface.get());
    } else {
      const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                                       static_cast<int>(grid.width() * kPixels),
                                                       static_cast<int>(grid.height() * kPixels)));
      Drawing drawing(surface.get(), kPixels);
      draw(drawing, grid, heading, small_print, swatches);
      status = cairo_surface_write_to_png(surface.get(), temporary.c_str());
    }
    if (status != CAIRO_STATUS_SUCCESS) throw RuntimeError(cairo_status_to_string(status));
  });
}

}  // namespace karat
