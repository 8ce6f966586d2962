// Drawings as SVG 1.1. Written here, because cairo turns letters into outlines: text stays text,
// which can be searched, read aloud and edited, and the file is a tenth as large.
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "apps/karat/chart/canvas.h"

namespace karat {
namespace {

// Hundredths of a pixel without trailing zeros.
std::string number(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : valid_utf8(text)) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else if (static_cast<unsigned char>(c) >= 0x20) {  // XML 1.0 knows no control characters
      result += c;
    } else {
      result += ' ';
    }
  }
  return result;
}

std::string hex(const Colour& colour) {
  const auto byte = [](double value) {
    return static_cast<int>(std::lround(255.0 * std::min(1.0, std::max(0.0, value))));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.red), byte(colour.green),
                     byte(colour.blue));
}

std::string fill_of(const Colour& colour) {
  std::string text = fmt::format("fill=\"{}\"", hex(colour));
  if (colour.alpha < 1.0) text += fmt::format(" fill-opacity=\"{}\"", number(colour.alpha));
  return text;
}

class SvgCanvas final : public Canvas {
 public:
  void line(const std::vector<Point>& points, const Stroke& stroke) override {
    std::string dashes;
    for (const double length : dash_lengths(stroke.dash, stroke.width)) {
      if (!dashes.empty()) dashes += ' ';
      dashes += number(length);
    }
    if (!dashes.empty()) dashes = fmt::format(" stroke-dasharray=\"{}\"", dashes);
    if (stroke.colour.alpha < 1.0) {
      dashes += fmt::format(" stroke-opacity=\"{}\"", number(stroke.colour.alpha));
    }
    out_ += fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
        "stroke-linejoin=\"round\"{}/>\n",
        path_of(points), hex(stroke.colour), number(stroke.width), dashes);
  }

  void polygon(const std::vector<Point>& points, const Colour& fill) override {
    out_ += fmt::format("<path d=\"{}z\" {}/>\n", path_of(points), fill_of(fill));
  }

  void circle(Point centre, double radius, const Colour& fill) override {
    out_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", number(centre.x),
                        number(centre.y), number(radius), fill_of(fill));
  }

  void rectangle(const Box& box, const Colour& fill) override {
    out_ +=
        fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n", number(box.left),
                    number(box.top), number(box.width), number(box.height), fill_of(fill));
  }

  void text(Point at, const std::string& text, const TextStyle& style) override {
    if (text.empty()) return;
    std::string more;
    if (style.bold) more += " font-weight=\"bold\"";
    if (style.align == Align::kMiddle) more += " text-anchor=\"middle\"";
    if (style.align == Align::kEnd) more += " text-anchor=\"end\"";
    if (style.upwards) {
      more += fmt::format(" transform=\"rotate(-90 {} {})\"", number(at.x), number(at.y));
    }
    out_ +=
        fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" {}{}>{}</text>\n", number(at.x),
                    number(at.y), number(style.size), fill_of(style.colour), more, escaped(text));
  }

  // Cells of one colour are one path, in which neighbours of a row are one rectangle. The units of
  // the inner picture are cells.
  void cells(const Box& box, std::size_t columns, const std::vector<Colour>& colours) override {
    std::map<std::string, std::string> paths;
    for (std::size_t i = 0, end = 0; i < colours.size(); i = end) {
      const std::string colour = hex(colours[i]);
      for (end = i + 1; end % columns != 0 && hex(colours[end]) == colour;) ++end;
      paths[colour] += fmt::format("M{} {}h{}v1h-{}z", i % columns, i / columns, end - i, end - i);
    }
    begin_inner(box, {0.0, 0.0, static_cast<double>(columns),
                      static_cast<double>(colours.size() / columns)});
    for (const auto& [colour, path] : paths) {
      out_ += fmt::format("<path shape-rendering=\"crispEdges\" d=\"{}\" fill=\"{}\"/>\n", path,
                          colour);
    }
    out_ += "</svg>\n";
  }

  // An inner picture is clipped without an id that might stand twice in a page.
  void clipped(const Box& box, const std::function<void()>& draw) override {
    begin_inner(box, box);
    draw();
    out_ += "</svg>\n";
  }

  const std::string& text_so_far() const { return out_; }

 private:
  void begin_inner(const Box& box, const Box& view) {
    out_ += fmt::format(
        "<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} {}\" "
        "preserveAspectRatio=\"none\" overflow=\"hidden\">\n",
        number(box.left), number(box.top), number(box.width), number(box.height), number(view.left),
        number(view.top), number(view.width), number(view.height));
  }

  static std::string path_of(const std::vector<Point>& points) {
    std::string path;
    for (const Point& point : points) {
      path += fmt::format("{}{} {}", path.empty() ? "M" : "L", number(point.x), number(point.y));
    }
    return path;
  }

  std::string out_;
};

}  // namespace

std::string svg_drawing(double width, double height, const std::string& title,
                        const Drawing& draw) {
  SvgCanvas canvas;
  draw(canvas);
  // Verdana has the letter widths of DejaVu Sans, which others than Debian's users may lack.
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" role=\"img\" font-family=\"'{2}', Verdana, sans-serif\">\n"
      "<title>{3}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n{4}</svg>\n",
      number(width), number(height), kChartFont, escaped(title), canvas.text_so_far());
}

}  // namespace karat
