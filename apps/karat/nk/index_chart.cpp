#include "apps/karat/nk/index_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/karat/nk/index_argument.h"
#include "apps/karat/nk/index_curves.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr double kNearInfrared = 20000.0;  // nm; ranges beyond are drawn in micrometres
constexpr std::size_t kMostMarkers = 90;   // along one curve: more of them merge

struct View {
  WavelengthRange range;
  WavelengthRange shown;  // a little more, where the range was not asked for
  double unit_nm = 1.0;   // of the axis
  bool log = false;
};

struct Curve {
  const IndexTable* table = nullptr;
  IndexCurves values;
  Colour colour;
};

WavelengthRange joint_range(const std::vector<IndexTablePtr>& tables) {
  WavelengthRange all{std::numeric_limits<double>::infinity(), 0.0};
  for (const IndexTablePtr& table : tables) {
    all.min_nm = std::min(all.min_nm, table->range().min_nm);
    all.max_nm = std::max(all.max_nm, table->range().max_nm);
  }
  if (all.max_nm == std::numeric_limits<double>::infinity()) return kVisible;  // constants
  if (!(all.width_nm() > 0.0)) return {0.98 * all.min_nm, 1.02 * all.max_nm};  // a single row
  return all;
}

bool asked_for(const IndexChartOptions& options, const std::string& axis, bool otherwise) {
  if (!options.log_axes) return otherwise;
  const auto& axes = *options.log_axes;
  return std::find(axes.begin(), axes.end(), axis) != axes.end();
}

View view_of(const std::vector<IndexTablePtr>& tables, const IndexChartOptions& options) {
  View view;
  view.range = options.range.value_or(joint_range(tables));
  view.unit_nm = view.range.max_nm > kNearInfrared ? 1000.0 : 1.0;
  view.log = asked_for(options, "wavelength", view.range.max_nm > 12.0 * view.range.min_nm);
  view.shown = view.range;
  if (!options.range) {
    // Room for the dots at the ends.
    const double margin = 0.012 * view.range.width_nm();
    const double factor = std::pow(view.range.max_nm / view.range.min_nm, 0.012);
    view.shown.min_nm = view.log ? view.range.min_nm / factor : view.range.min_nm - margin;
    view.shown.max_nm = view.log ? view.range.max_nm * factor : view.range.max_nm + margin;
  }
  return view;
}

std::vector<Curve> curves_of(const std::vector<IndexTablePtr>& tables, const View& view,
                             double angle_deg) {
  constexpr int kPoints = 500;
  std::vector<Curve> curves;
  std::string ranges;
  for (const IndexTablePtr& table : tables) {
    curves.push_back({table.get(), index_curves(*table, view.range, angle_deg, kPoints, view.log),
                      series_colour(curves.size())});
    ranges += fmt::format("{}{} {:.7g} to {:.7g} nm", ranges.empty() ? "" : ", ",
                          table->provenance().name, table->range().min_nm, table->range().max_nm);
  }
  const bool empty = std::all_of(curves.begin(), curves.end(),
                                 [](const Curve& curve) { return curve.values.nm.empty(); });
  if (empty) {
    throw InputError(fmt::format(
        "nothing is known from {:.7g} to {:.7g} nm; the tables cover: {}{}", view.range.min_nm,
        view.range.max_nm, ranges, unit_hint("--nm", view.range, tables.front()->range())));
  }
  return curves;
}

// Of many rows every second, fifth, ... is marked, the first and the last always.
std::vector<std::size_t> thinned(const std::vector<std::size_t>& rows) {
  const std::size_t step = (rows.size() + kMostMarkers - 1) / kMostMarkers;
  if (step <= 1) return rows;
  std::vector<std::size_t> few;
  for (std::size_t i = 0; i < rows.size(); i += step) few.push_back(rows[i]);
  if (few.back() != rows.back()) few.push_back(rows.back());
  return few;
}

Series series_of(const Curve& curve, const std::vector<double>& values, const View& view) {
  Series series;
  series.name = curve.table->provenance().name;
  for (const double nm : curve.values.nm) series.x.push_back(nm / view.unit_nm);
  series.y = values;
  series.colour = curve.colour;
  return series;
}

// The curve with its rows as dots, or bars at its ends where no row was measured.
void add_curve(Panel& panel, const Curve& curve, const std::vector<double>& values,
               const std::vector<std::size_t>& rows, const View& view) {
  if (values.empty()) return;
  Series series = series_of(curve, values, view);
  series.marker = rows.empty() ? Marker::kBar : Marker::kCircle;
  series.marker_size = rows.empty() ? 11.0 : rows.size() > 40 ? 3.6 : 4.8;
  series.marked = thinned(rows);
  if (rows.empty()) series.marked = {0, values.size() - 1};
  panel.series.push_back(std::move(series));
}

// Where nothing was measured is said in the picture; with several tables their ends say it.
void add_bands(Panel& panel, const std::vector<IndexTablePtr>& tables, const View& view,
               bool named) {
  const auto band = [&](double from, double to, double alpha, const char* label) {
    panel.bands.push_back(
        {from / view.unit_nm, to / view.unit_nm, {0.0, 0.0, 0.0, alpha}, named ? label : ""});
  };
  const WavelengthRange all = joint_range(tables);
  if (view.range.min_nm < all.min_nm) band(view.range.min_nm, all.min_nm, 0.14, "not measured");
  if (view.range.max_nm > all.max_nm) band(all.max_nm, view.range.max_nm, 0.14, "not measured");
  if (!kVisible.covers(view.range)) band(kVisible.min_nm, kVisible.max_nm, 0.045, "visible");
}

Panel panel_of(const std::vector<IndexTablePtr>& tables, const View& view,
               const std::string& title) {
  Panel panel;
  panel.x.title = view.unit_nm > 1.0 ? "vacuum wavelength (µm)" : "vacuum wavelength (nm)";
  panel.x.log = view.log;
  panel.x.min = view.shown.min_nm / view.unit_nm;
  panel.x.max = view.shown.max_nm / view.unit_nm;
  panel.y.title = title;
  add_bands(panel, tables, view, false);
  return panel;
}

// Whether positive values spread so far that a linear axis would hide most of them.
bool spans_decades(const std::vector<Curve>& curves, std::vector<double> IndexCurves::*quantity,
                   double factor) {
  double low = std::numeric_limits<double>::infinity(), high = 0.0;
  for (const Curve& curve : curves) {
    for (const double value : curve.values.*quantity) {
      if (!(value > 0.0)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return high > factor * low;
}

Panel n_panel(const std::vector<IndexTablePtr>& tables, const std::vector<Curve>& curves,
              const View& view, const IndexChartOptions& options) {
  Panel panel = panel_of(tables, view, "index n");
  panel.bands.clear();
  add_bands(panel, tables, view, true);
  panel.y.log = asked_for(options, "n", spans_decades(curves, &IndexCurves::n, 300.0));
  for (const Curve& curve : curves) {
    add_curve(panel, curve, curve.values.n, curve.values.n_rows, view);
  }
  return panel;
}

Panel k_panel(const std::vector<IndexTablePtr>& tables, const std::vector<Curve>& curves,
              const View& view, const IndexChartOptions& options) {
  Panel panel = panel_of(tables, view, "extinction k");
  panel.y.log = asked_for(options, "k", spans_decades(curves, &IndexCurves::k, 1000.0));
  for (const Curve& curve : curves) {
    if (!curve.table->has_k()) continue;
    add_curve(panel, curve, curve.values.k, curve.values.k_rows, view);
  }
  return panel;
}

// A grey line that stands in the legend alone.
Series legend_line(const std::string& name, Dash dash) {
  Series series;
  series.name = name;
  series.colour = {0.4, 0.4, 0.4, 1.0};
  series.dash = dash;
  series.width = 1.1;
  return series;
}

Panel reflectance_panel(const std::vector<IndexTablePtr>& tables, const std::vector<Curve>& curves,
                        const View& view, const IndexChartOptions& options) {
  Panel panel = panel_of(tables, view, fmt::format("reflectance, {:g}°", options.angle_deg));
  panel.y.log = asked_for(options, "reflectance", false);
  panel.spectrum_unit_nm = view.unit_nm;
  const auto polarised = [&](const Curve& curve, const std::vector<double>& values, Dash dash) {
    Series series = series_of(curve, values, view);
    series.name.clear();
    series.dash = dash;
    series.width = 1.1;
    panel.series.push_back(std::move(series));
  };
  for (const Curve& curve : curves) {
    if (options.angle_deg > 0.0) {
      polarised(curve, curve.values.rs, Dash::kDashed);
      polarised(curve, curve.values.rp, Dash::kDotted);
    }
    add_curve(panel, curve, curve.values.r, curve.values.r_rows, view);
  }
  if (options.angle_deg > 0.0) {
    panel.series.push_back(legend_line("s-polarised", Dash::kDashed));
    panel.series.push_back(legend_line("p-polarised", Dash::kDotted));
  }
  return panel;
}

std::string range_text(WavelengthRange range) {
  if (range.max_nm == std::numeric_limits<double>::infinity()) return "every wavelength";
  if (range.max_nm <= kNearInfrared) {
    return fmt::format("{:.6g} to {:.6g} nm", range.min_nm, range.max_nm);
  }
  return fmt::format("{:.6g} to {:.6g} µm", range.min_nm / 1000.0, range.max_nm / 1000.0);
}

std::string rows_text(const IndexTable& table, const Curve& curve) {
  const std::size_t rows = std::max(curve.values.n_rows.size(), curve.values.k_rows.size());
  if (rows == 0) return table.provenance().file.empty() ? "calculated" : "dispersion formula";
  std::string text = fmt::format("{} measured rows", rows);
  const std::size_t shown = thinned(curve.values.n_rows).size();
  if (shown < curve.values.n_rows.size()) text += fmt::format(" ({} marked)", shown);
  if (table.n_samples().empty()) text += " of k, n by a formula";
  return text;
}

void add_words(Chart& chart, const std::vector<Curve>& curves) {
  for (const Curve& curve : curves) {
    const Provenance& source = curve.table->provenance();
    if (!chart.title.empty()) chart.title += ", ";
    chart.title += source.name;
    const std::string facts =
        range_text(curve.table->range()) + ", " + rows_text(*curve.table, curve);
    if (curves.size() == 1) chart.subtitle = facts;
    chart.caption +=
        fmt::format("{}{}{}", curves.size() > 1 ? source.name + " (" + facts + "): " : "",
                    source.reference, "\n");
    if (curves.size() == 1 && !source.conditions.empty()) chart.caption += source.conditions + "\n";
  }
  chart.caption += "Reflectance of a smooth interface from vacuum: exact Fresnel equations.";
}

}  // namespace

Chart index_chart(const std::vector<IndexTablePtr>& tables, const IndexChartOptions& options) {
  const View view = view_of(tables, options);
  const std::vector<Curve> curves = curves_of(tables, view, options.angle_deg);
  Chart chart;
  chart.width = options.width;
  chart.height = options.height;
  add_words(chart, curves);
  chart.panels.push_back(n_panel(tables, curves, view, options));
  const bool any_k = std::any_of(tables.begin(), tables.end(),
                                 [](const IndexTablePtr& table) { return table->has_k(); });
  if (any_k) chart.panels.push_back(k_panel(tables, curves, view, options));
  chart.panels.push_back(reflectance_panel(tables, curves, view, options));
  if (curves.size() == 1 && options.angle_deg == 0.0) {
    for (Panel& panel : chart.panels) {
      for (Series& series : panel.series) series.name.clear();
    }
  }
  return chart;
}

}  // namespace karat
