// The ranges of axes: what they ask for, otherwise what the values need with a little room.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/karat/chart/parts.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void hold(double value, bool log) {
    if (!std::isfinite(value) || (log && value <= 0.0)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool empty() const { return low > high; }
};

// `room`: the share of the range left free beyond the values.
Scale scale_of(const Axis& axis, Extent extent, double room) {
  if (extent.empty()) extent = axis.log ? Extent{0.1, 1.0} : Extent{0.0, 1.0};
  double low = extent.low, high = extent.high;
  if (axis.log) {
    const double factor = std::max(1.02, std::pow(high / low, room));
    if (room > 0.0) low /= factor, high *= factor;
    if (!(high > low)) low /= 1.5, high *= 1.5;
  } else {
    // An axis that nearly reaches 0 begins there.
    const bool from_zero = room > 0.0 && low >= 0.0 && low < 0.4 * high;
    const double margin = room * (high - low);
    low = from_zero ? 0.0 : low - margin;
    high += margin;
    if (!(high > low)) {
      const double half = std::max(1e-6, 0.05 * std::abs(high));
      low -= half, high += half;
    }
  }
  const Scale scale{axis.min.value_or(low), axis.max.value_or(high), axis.log, 0.0, 1.0};
  if (!(scale.max > scale.min) || (scale.log && !(scale.min > 0.0))) {
    throw InputError(fmt::format("the axis \"{}\" cannot run from {:g} to {:g}{}", axis.title,
                                 scale.min, scale.max, scale.log ? " logarithmically" : ""));
  }
  return scale;
}

}  // namespace

Scale scale_of_x(const std::vector<const Panel*>& panels) {
  const Axis& axis = panels.front()->x;
  Extent extent;
  bool points = false;
  for (const Panel* panel : panels) {
    for (const Series& series : panel->series) {
      for (const double x : series.x) extent.hold(x, axis.log);
      points = points || !(series.width > 0.0);
    }
    if (!panel->map) continue;
    for (const double x : panel->map->x_range) extent.hold(x, axis.log);
  }
  return scale_of(axis, extent, points ? 0.06 : 0.0);
}

Scale scale_of_y(const std::vector<const Panel*>& panels, const Scale& x) {
  const Axis& axis = panels.front()->y;
  Extent extent;
  bool map = false;
  for (const Panel* panel : panels) {
    for (const Series& series : panel->series) {
      for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (series.x[i] >= x.min && series.x[i] <= x.max) extent.hold(series.y[i], axis.log);
      }
    }
    if (!panel->map) continue;
    map = true;
    for (const double y : panel->map->y_range) extent.hold(y, axis.log);
  }
  return scale_of(axis, extent, map ? 0.0 : 0.05);
}

}  // namespace karat
