#include "apps/karat/chart.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>

#include "apps/karat/chart/scale.h"
#include "apps/karat/run_karat.h"
#include "render/image_file.h"
#include "spectral/colour.h"
#include "spectral/support/error.h"
#include "tests/temporary_folder.h"

namespace karat {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

using Folder = test::TemporaryFolder;

std::string bytes_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Whether every element is closed in order and no bare ampersand stands in the text.
bool well_formed(const std::string& svg) {
  std::vector<std::string> open;
  const std::regex tag("<(/?)([a-z]+)((?: [a-zA-Z-]+(?::[a-z]+)?=\"[^\"<]*\")*)(/?)>");
  std::string rest = svg;
  for (auto it = std::sregex_iterator(svg.begin(), svg.end(), tag); it != std::sregex_iterator();
       ++it) {
    if ((*it)[1].length() > 0) {
      if (open.empty() || open.back() != (*it)[2].str()) return false;
      open.pop_back();
    } else if ((*it)[4].length() == 0) {
      open.push_back((*it)[2].str());
    }
  }
  rest = std::regex_replace(rest, tag, "");
  rest = std::regex_replace(rest, std::regex("&(amp|lt|gt|quot);"), "");
  return open.empty() && rest.find_first_of("<>&") == std::string::npos;
}

Chart small_chart() {
  Chart chart;
  chart.title = "Silver & gold <Ag, Au>";
  chart.caption = "λ in µm², at 60°";
  Panel panel;
  panel.x.title = "wavelength λ (nm)";
  panel.y.title = "reflectance";
  Series series;
  series.name = "gold";
  series.colour = series_colour(0);
  series.x = {400, 500, 600, 700};
  series.y = {0.4, 0.5, 0.9, 0.97};
  series.marker = Marker::kCircle;
  panel.series = {series};
  panel.spectrum_unit_nm = 1.0;
  chart.panels = {panel};
  return chart;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST_CASE("an SVG is well-formed and its labels are text", "[chart]") {
  const std::string svg = chart_svg(small_chart());
  CHECK(well_formed(svg));
  CHECK_THAT(svg, Contains("Silver &amp; gold &lt;Ag, Au&gt;") && Contains("wavelength λ (nm)") &&
                      Contains(">reflectance<") && Contains(">gold<") &&
                      Contains("λ in µm², at 60°"));
  CHECK(count_of(svg, "<circle") == 4 + 1);  // the points, and the legend's
  CHECK_THAT(svg, !Contains("nan") && !Contains("inf"));
  CHECK(svg.find(" id=") == std::string::npos);
}

TEST_CASE("the same chart is the same bytes, in either format", "[chart]") {
  const Folder folder;
  for (const char* name : {"a.svg", "a.png"}) {
    draw_chart(small_chart(), folder.file(name));
    const std::string first = bytes_of(folder.file(name));
    draw_chart(small_chart(), folder.file(name));
    CHECK(first.size() > 1000);
    CHECK(bytes_of(folder.file(name)) == first);
  }
  const Image png = read_image_header(folder.file("a.png"));
  CHECK(png.width == 1520);
  CHECK(png.height == 1040);
}

TEST_CASE("what cannot be drawn or written is refused with its reason", "[chart]") {
  const Folder folder;
  CHECK_THROWS_WITH(draw_chart(small_chart(), folder.file("a.pdf")),
                    Contains(".svg or .png") && Contains(".pdf"));
  CHECK_THROWS_AS(draw_chart(small_chart(), folder.file("no/a.svg")), RuntimeError);
  CHECK_THROWS_AS(draw_chart(small_chart(), folder.file("no/a.png")), RuntimeError);
  CHECK(fs::is_empty(folder.path));
  Chart uneven = small_chart();
  uneven.panels[0].series[0].y.pop_back();
  CHECK_THROWS_WITH(chart_svg(uneven), Contains("4 x, 3 y"));
  Chart reversed = small_chart();
  reversed.panels[0].x.min = 900.0;
  CHECK_THROWS_WITH(chart_svg(reversed), Contains("wavelength") && Contains("900"));
  Chart map = small_chart();
  HeatMap& heat = map.panels[0].map.emplace();
  heat.columns = 3, heat.rows = 2, heat.values = {1.0};
  CHECK_THROWS_WITH(chart_svg(map), Contains("3 columns and 2 rows"));
  CHECK_THROWS_AS(chart_svg(Chart()), InputError);
}

TEST_CASE("gaps, odd bytes and empty series do no harm", "[chart]") {
  Chart chart = small_chart();
  Series& series = chart.panels[0].series[0];
  series.name = "a \xff byte and a \x01 control";
  series.y[1] = std::nan("");
  series.y[3] = 0.0;
  chart.panels[0].y.log = true;
  chart.panels[0].series.emplace_back().name = "nothing";
  const std::string svg = chart_svg(chart);
  CHECK(well_formed(svg));
  CHECK_THAT(svg, !Contains("nan") && !Contains("inf") && !Contains("\xff") && Contains("nothing"));
  chart.panels[0].series.clear();
  CHECK(well_formed(chart_svg(chart)));
}

TEST_CASE("a map has a cell for every value and a bar with its unit", "[chart]") {
  Chart chart = small_chart();
  HeatMap map;
  map.columns = map.rows = 2;
  map.values = {0.0, 1.0, 2.0, std::nan("")};
  map.x_range = {400, 700};
  map.title = "error (%)";
  chart.panels[0].map = map;
  const std::string svg = chart_svg(chart);
  CHECK(well_formed(svg));
  CHECK_THAT(svg, Contains("error (%)") && Contains("M0 1h1v1h-1z") && Contains("M0 0h1v1h-1z"));
  CHECK_THAT(svg, Contains("#cccccc"));  // the value that is none
}

TEST_CASE("the colours of maps run evenly in lightness", "[chart]") {
  const auto lightness = [](double t, ColourMap map) {
    const Colour c = mapped_colour(t, map);
    const Rgb linear{srgb_decode(c.red), srgb_decode(c.green), srgb_decode(c.blue)};
    return lab_of_xyz(xyz_of_linear_srgb(linear), xyz_of_linear_srgb({1, 1, 1}))[0];
  };
  for (int i = 1; i <= 50; ++i) {
    const double step = lightness(i / 50.0, ColourMap::kSequential) -
                        lightness((i - 1) / 50.0, ColourMap::kSequential);
    CHECK(step == Approx(76.0 / 50.0).margin(0.6));  // where the gamut ends a little is lost
    const double t = i / 100.0;
    CHECK(lightness(t, ColourMap::kDiverging) ==
          Approx(lightness(1.0 - t, ColourMap::kDiverging)).margin(1.5));
  }
}

TEST_CASE("ticks are round and lie within their axis", "[chart]") {
  const auto texts = [](const Scale& scale) {
    std::string all;
    for (const Tick& tick : axis_ticks(scale, 50.0)) {
      if (!tick.text.empty()) all += tick.text + " ";
      CHECK(tick.value >= scale.min * (1 - 1e-9) - 1e-9);
      CHECK(tick.value <= scale.max * (1 + 1e-9) + 1e-9);
    }
    return all;
  };
  CHECK(texts({0.0, 1.0, false, 0.0, 300.0}) == "0 0.2 0.4 0.6 0.8 1.0 ");
  CHECK(texts({380.0, 780.0, false, 0.0, 500.0}) == "400 450 500 550 600 650 700 750 ");
  CHECK(texts({-0.3, 0.3, false, 0.0, 200.0}) == "−0.2 0 0.2 ");
  CHECK(texts({1.0, 1000.0, true, 0.0, 300.0}) == "1 10 100 1000 ");
  CHECK(texts({1e-8, 1e-2, true, 0.0, 200.0}) == "10⁻⁸ 10⁻⁶ 10⁻⁴ 10⁻² ");
}

TEST_CASE("karat nk plot draws tables and refuses what it does not know", "[chart]") {
  const Folder folder;
  const auto run = [](std::vector<std::string> words) {
    std::vector<const char*> argv{"karat", "nk", "plot"};
    for (const std::string& word : words) argv.push_back(word.c_str());
    return run_karat(static_cast<int>(argv.size()), argv.data());
  };
  const std::string file = folder.file("gold.svg");
  CHECK(run({"main/Au/Johnson", "-o", file}) == 0);
  const std::string gold = bytes_of(file);
  CHECK(well_formed(gold));
  CHECK_THAT(gold, Contains("main/Au/Johnson") && Contains("vacuum wavelength (nm)") &&
                       Contains("Christy") && Contains("49 measured rows"));
  CHECK(count_of(gold, "<circle") == 3 * 49);
  CHECK(run({"main/Au/Johnson", "main/SiO2/Malitson", "--nm", "300:900", "--angle", "60", "--log",
             "k", "-o", file}) == 0);
  CHECK_THAT(bytes_of(file), Contains("s-polarised") && Contains("reflectance, 60°"));
  CHECK(run({"main/Au/Johnson", "--nm", "1:2", "-o", file}) == 3);
  CHECK(run({"main/Au/Johnson", "--nm", "900:300", "-o", file}) == 2);
  CHECK(run({"main/Au/Johnson", "-o", folder.file("gold.gif")}) == 2);
  CHECK(run({"Au/Johnson", "-o", file}) == 0);
  CHECK(run({"Johnson", "-o", file}) == 3);
  CHECK(run({"main/Au/Johnson", "-o", folder.file("none/gold.svg")}) == 1);
}

}  // namespace
}  // namespace karat
