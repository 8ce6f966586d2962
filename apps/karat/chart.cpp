#include "apps/karat/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "apps/karat/chart/parts.h"
#include "render/replace_file.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr double kMargin = 14.0, kGutterX = 26.0, kGutterY = 14.0;
constexpr double kTitle = 15.0, kSubtitle = 12.0, kCaption = 9.5;
constexpr Colour kQuiet{0.4, 0.4, 0.4, 1.0};

void check(const Chart& chart) {
  if (chart.panels.empty() || chart.columns == 0) throw InputError("a chart needs a panel");
  for (const Panel& panel : chart.panels) {
    for (const Series& series : panel.series) {
      const std::size_t count = series.x.size();
      if (series.y.size() == count && (series.labels.empty() || series.labels.size() == count)) {
        continue;
      }
      throw InputError(fmt::format("series \"{}\" has {} x, {} y and {} labels", series.name, count,
                                   series.y.size(), series.labels.size()));
    }
    if (panel.map && panel.map->values.size() != panel.map->columns * panel.map->rows) {
      throw InputError(fmt::format("a map of {} columns and {} rows has {} values",
                                   panel.map->columns, panel.map->rows, panel.map->values.size()));
    }
  }
}

// Lines of text downwards from `top`; returns where they end. Without a canvas it only measures.
double draw_text_lines(Canvas* canvas, const std::string& text, const TextStyle& style, double left,
                       double top, double width) {
  for (const std::string& line : broken_lines(text, style, width)) {
    top += 1.3 * style.size;
    if (canvas) canvas->text({left, top - 0.3 * style.size}, line, style);
  }
  return top;
}

double draw_head(Canvas* canvas, const Chart& chart) {
  const double width = chart.width - 2.0 * kMargin;
  double y = draw_text_lines(canvas, chart.title, {kTitle, true}, kMargin, kMargin - 4.0, width);
  y = draw_text_lines(canvas, chart.subtitle, {kSubtitle, false, kQuiet}, kMargin, y, width);
  y += draw_legend(canvas, chart, kMargin, y + 2.0, width);
  const bool titled = std::any_of(chart.panels.begin(), chart.panels.end(),
                                  [](const Panel& panel) { return !panel.title.empty(); });
  return y + (titled ? 22.0 : 10.0);
}

// The caption's height; with a canvas it is drawn so that it ends at the bottom margin.
double draw_caption(Canvas* canvas, const Chart& chart) {
  const TextStyle style{kCaption, false, kQuiet};
  const double width = chart.width - 2.0 * kMargin;
  const double height = draw_text_lines(nullptr, chart.caption, style, kMargin, 0.0, width);
  if (canvas) {
    draw_text_lines(canvas, chart.caption, style, kMargin, chart.height - 0.7 * kMargin - height,
                    width);
  }
  return height;
}

// The panels of `chart` that share a row or a column with panel i, or it alone.
std::vector<const Panel*> sharing(const Chart& chart, std::size_t i, bool shared, bool row) {
  std::vector<const Panel*> panels;
  for (std::size_t j = 0; j < chart.panels.size(); ++j) {
    const bool same =
        row ? j / chart.columns == i / chart.columns : j % chart.columns == i % chart.columns;
    if (j == i || (shared && same)) panels.push_back(&chart.panels[j]);
  }
  return panels;
}

std::vector<PlacedPanel> scaled_panels(const Chart& chart) {
  std::vector<PlacedPanel> placed(chart.panels.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    placed[i].panel = &chart.panels[i];
    placed[i].x = scale_of_x(sharing(chart, i, chart.share_x, false));
    placed[i].y = scale_of_y(sharing(chart, i, chart.share_y, true), placed[i].x);
    placed[i].names_x = !chart.share_x || i + chart.columns >= placed.size();
    placed[i].names_y = !chart.share_y || i % chart.columns == 0;
  }
  return placed;
}

// Widths that the y axes take left of each column and the colour bars right of it.
struct ColumnRoom {
  double left = 0.0, right = 0.0;
};

std::vector<ColumnRoom> column_rooms(const Chart& chart, const std::vector<PlacedPanel>& placed) {
  std::vector<ColumnRoom> rooms(chart.columns);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    ColumnRoom& room = rooms[i % chart.columns];
    if (placed[i].names_y) {
      room.left = std::max(room.left, y_axis_width(*placed[i].panel, placed[i].y));
    }
    if (placed[i].panel->map) room.right = kMapBarWidth;
  }
  return rooms;
}

void place_pixels(PlacedPanel& placed) {
  placed.x.from_pixel = placed.box.left;
  placed.x.to_pixel = placed.box.right();
  placed.y.from_pixel = placed.box.bottom();
  placed.y.to_pixel = placed.box.top;
}

// Panels of equal size within `area`.
void place_panels(const Chart& chart, std::vector<PlacedPanel>& placed, const Box& area) {
  const std::size_t columns = chart.columns;
  const std::size_t rows = (placed.size() + columns - 1) / columns;
  // How high y ticks are named depends on the height and the other way round: twice is enough.
  for (int round = 0; round < 2; ++round) {
    const std::vector<ColumnRoom> rooms = column_rooms(chart, placed);
    double free_width = area.width - kGutterX * static_cast<double>(columns - 1);
    for (const ColumnRoom& room : rooms) free_width -= room.left + room.right;
    const double below = x_axis_height(*placed.back().panel);
    const double titles = placed.front().panel->title.empty() ? 0.0 : 12.0;
    const double between = chart.share_x ? kGutterY + titles : below + kGutterY + titles;
    const double free_height = area.height - below - between * static_cast<double>(rows - 1);
    const double width = std::max(20.0, free_width / static_cast<double>(columns));
    const double height = std::max(20.0, free_height / static_cast<double>(rows));
    for (std::size_t i = 0; i < placed.size(); ++i) {
      double left = area.left + rooms[0].left;
      for (std::size_t c = 0; c < i % columns; ++c) {
        left += width + rooms[c].right + kGutterX + rooms[c + 1].left;
      }
      const double top = area.top + (height + between) * static_cast<double>(i / columns);
      placed[i].box = {left, top, width, height};
      place_pixels(placed[i]);
    }
  }
}

void draw_panel(Canvas& canvas, const PlacedPanel& placed) {
  draw_background(canvas, placed);
  draw_map(canvas, placed);
  if (placed.panel->spectrum_unit_nm > 0.0) draw_spectrum_strip(canvas, placed);
  canvas.clipped(placed.box, [&] { draw_lines(canvas, placed); });
  draw_labels(canvas, placed);
  draw_axes(canvas, placed);
}

Drawing drawing_of(const Chart& chart) {
  check(chart);
  std::vector<PlacedPanel> placed = scaled_panels(chart);
  const double top = draw_head(nullptr, chart);
  const double caption = draw_caption(nullptr, chart);
  place_panels(chart, placed,
               {kMargin, top, chart.width - 2.0 * kMargin - 4.0,
                chart.height - top - kMargin - (caption > 0.0 ? caption + 6.0 : 0.0)});
  return [&chart, placed](Canvas& canvas) {
    draw_head(&canvas, chart);
    for (const PlacedPanel& panel : placed) draw_panel(canvas, panel);
    draw_caption(&canvas, chart);
  };
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw RuntimeError("the file could not be written whole");
}

}  // namespace

std::string chart_svg(const Chart& chart) {
  return svg_drawing(chart.width, chart.height, chart.title, drawing_of(chart));
}

void draw_chart(const Chart& chart, const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".svg") {
    const std::string svg = chart_svg(chart);
    replace_file(path, [&](const std::string& temporary) { write_text(temporary, svg); });
  } else if (extension == ".png") {
    const Drawing draw = drawing_of(chart);
    replace_file(path, [&](const std::string& temporary) {
      write_png_drawing(temporary, chart.width, chart.height, chart.png_scale, draw);
    });
  } else {
    throw InputError(
        fmt::format("\"{}\": a chart is written as .svg or .png, not as \"{}\"", path, extension));
  }
}

}  // namespace karat
