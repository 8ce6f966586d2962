// The report's figures as SVG files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "apps/karat/chart.h"
#include "apps/karat/fresnel/study_report.h"

namespace karat {
namespace {

std::size_t nearest(const std::vector<double>& values, double wanted) {
  const auto found = std::min_element(values.begin(), values.end(), [&](double a, double b) {
    return std::abs(a - wanted) < std::abs(b - wanted);
  });
  return static_cast<std::size_t>(found - values.begin());
}

constexpr std::size_t kColours = 6;  // of series_colour(), before its black

// The same colour and dash for a model in all figures; exact is black.
Series series_of(const StudyReport& report, const std::string& model) {
  Series series;
  series.name = model;
  if (model == "exact") {
    series.width = 2.2;
    return series;
  }
  const auto& models = report.options.models;
  auto place =
      static_cast<std::size_t>(std::find(models.begin(), models.end(), model) - models.begin());
  if (place > 0 && models.front() == "exact") --place;
  static constexpr Dash kDashes[]{Dash::kSolid, Dash::kDashed, Dash::kDotted, Dash::kDashDotted};
  series.colour = series_colour(place % kColours);
  series.dash = kDashes[place / kColours % 4];
  return series;
}

class Curves {
 public:
  Curves(const StudyReport& report, const FresnelMaterialStudy& material)
      : report_(report), material_(material), grid_(report.options.grid) {}

  Chart chart() const {
    Chart chart;
    chart.title = short_name(material_) + ": reflectance, exact and approximated";
    chart.caption = material_.table->provenance().reference;
    chart.columns = 2, chart.share_x = false;
    chart.width = 980.0, chart.height = 1180.0;
    const double first = grid_.range().min_nm, width = grid_.range().width_nm();
    const double middle = first + 0.425 * width;  // 550 nm of the visible
    chart.panels = {over_angle(first + 0.175 * width, &FresnelCurves::unpolarised, ""),
                    over_wavelength(0.0),
                    over_angle(middle, &FresnelCurves::unpolarised, ""),
                    over_wavelength(60.0),
                    over_angle(first + 0.675 * width, &FresnelCurves::unpolarised, ""),
                    over_wavelength(80.0),
                    over_angle(middle, &FresnelCurves::s, ", s polarised"),
                    over_angle(middle, &FresnelCurves::p, ", p polarised")};
    return chart;
  }

 private:
  using Values = GridValues FresnelCurves::*;

  template <typename Pick>
  Panel panel(const std::vector<double>& x, Values values, Pick&& pick) const {
    Panel panel;
    panel.y.title = "reflectance";
    const auto add = [&](Series series, const FresnelCurves& curves) {
      if ((curves.*values).empty()) return;
      series.x = x;
      for (std::size_t i = 0; i < x.size(); ++i) series.y.push_back((curves.*values)[pick(i)]);
      panel.series.push_back(std::move(series));
    };
    for (const auto& study : material_.models) {
      if (study.model != "exact") add(series_of(report_, study.model), study.curves);
    }
    add(series_of(report_, "exact"), material_.exact);
    return panel;
  }
  Panel over_angle(double wanted_nm, Values values, const std::string& note) const {
    const std::size_t nm = nearest(grid_.wavelengths_nm, wanted_nm);
    Panel result = panel(grid_.angles_deg, values,
                         [&](std::size_t i) { return i * grid_.wavelengths_nm.size() + nm; });
    result.title = fmt::format("{:g} nm{}", grid_.wavelengths_nm[nm], note);
    result.x.title = "angle (degrees)";
    return result;
  }
  Panel over_wavelength(double wanted_deg) const {
    const std::size_t angle = nearest(grid_.angles_deg, wanted_deg);
    Panel result = panel(grid_.wavelengths_nm, &FresnelCurves::unpolarised,
                         [&](std::size_t i) { return angle * grid_.wavelengths_nm.size() + i; });
    result.title = fmt::format("{:g} degrees", grid_.angles_deg[angle]);
    result.x.title = "wavelength (nm)";
    return result;
  }

  const StudyReport& report_;
  const FresnelMaterialStudy& material_;
  const FresnelGrid& grid_;
};

// Half a step beyond the first and the last: cells are around grid points.
std::array<double, 2> edges(const std::vector<double>& values) {
  const double step = values.size() > 1 ? values[1] - values[0] : 1.0;
  return {values.front() - 0.5 * step, values.back() + 0.5 * step};
}

// One bad model would leave the maps of all others white.
constexpr double kMapLimit = 0.1;
constexpr double kColourLimit = 12.0;

Chart error_maps(const StudyReport& report, const FresnelMaterialStudy& material) {
  const FresnelGrid& grid = report.options.grid;
  double largest = 1e-9;
  for (const auto& study : material.models) largest = std::max(largest, study.error.max_abs);
  largest = std::min(largest, kMapLimit);
  Chart chart;
  chart.title = short_name(material) + ": model minus exact, unpolarised";
  chart.columns = 3;
  for (const auto& study : material.models) {
    if (study.model == "exact" && material.models.size() > 1) continue;
    HeatMap map;
    map.columns = grid.wavelengths_nm.size(), map.rows = grid.angles_deg.size();
    for (std::size_t i = 0; i < grid.size(); ++i) {
      map.values.push_back(study.curves.unpolarised[i] - material.exact.unpolarised[i]);
    }
    map.x_range = edges(grid.wavelengths_nm), map.y_range = edges(grid.angles_deg);
    map.min = -largest, map.max = largest;
    map.map = ColourMap::kDiverging;
    map.title = "error";
    Panel panel;
    panel.title = study.model;
    panel.x.title = "wavelength (nm)", panel.y.title = "angle (degrees)";
    panel.map = std::move(map);
    chart.panels.push_back(std::move(panel));
  }
  chart.share_x = chart.share_y = true;
  chart.width = 1080.0;
  chart.height = 90.0 + 230.0 * std::ceil(static_cast<double>(chart.panels.size()) / 3.0);
  return chart;
}

Chart colour_errors(const StudyReport& report, const FresnelMaterialStudy& material) {
  Chart chart;
  chart.title = fmt::format("{}: colour difference from exact under {}", short_name(material),
                            report.options.viewing.illuminant);
  Panel panel;
  panel.x.title = "angle (degrees)", panel.y.title = "CIEDE2000";
  for (const auto& study : material.models) {
    Series series = series_of(report, study.model);
    series.x = report.options.grid.angles_deg, series.y = study.colour_error.delta_e;
    // Nobody needs to know how wrong something is beyond that; the page has the whole range.
    if (study.colour_error.max > kColourLimit) panel.y.max = kColourLimit;
    panel.series.push_back(std::move(series));
  }
  panel.y.min = 0.0;
  chart.panels = {panel};
  return chart;
}

Chart pareto(const StudyReport& report) {
  Chart chart;
  chart.title = "Error against cost, all materials";
  chart.subtitle = processor_name() + "; models on the dashed line are beaten by no other in both";
  chart.width = 900.0, chart.height = 620.0;
  Panel panel;
  panel.x.title = "cost relative to exact", panel.x.log = true;
  panel.y.title = "CIEDE2000 from exact, mean over angles and materials", panel.y.log = true;
  Series front;
  front.dash = Dash::kDashed, front.width = 1.0;
  std::vector<FresnelRank> ranks = report.ranking;
  std::sort(ranks.begin(), ranks.end(),
            [](const auto& a, const auto& b) { return a.cost_relative < b.cost_relative; });
  for (const FresnelRank& rank : ranks) {
    Series point = series_of(report, rank.model);
    point.name.clear();
    point.x = {rank.cost_relative}, point.y = {rank.delta_e_mean};
    point.width = 0.0, point.marker = Marker::kCircle, point.marker_size = 8.0;
    point.labels = {rank.model};
    panel.series.push_back(std::move(point));
    if (rank.efficient) front.x.push_back(rank.cost_relative), front.y.push_back(rank.delta_e_mean);
  }
  panel.series.insert(panel.series.begin(), std::move(front));
  panel.x.min = 0.8 * ranks.front().cost_relative, panel.x.max = 1.4 * ranks.back().cost_relative;
  chart.panels = {panel};
  return chart;
}

}  // namespace

void write_study_figures(const std::string& folder, const StudyReport& report) {
  const std::string figures = folder + "/figures";
  std::filesystem::create_directories(figures);
  for (const auto& material : report.materials) {
    const std::string name = file_name(material);
    draw_chart(Curves(report, material).chart(), figures + "/reflectance-" + name + ".svg");
    draw_chart(error_maps(report, material), figures + "/error-maps-" + name + ".svg");
    draw_chart(colour_errors(report, material), figures + "/colour-" + name + ".svg");
  }
  draw_chart(pareto(report), figures + "/error-against-cost.svg");
}

}  // namespace karat
