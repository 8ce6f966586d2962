// n, k and reflectance of index tables over wavelength, as a chart.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/karat/chart.h"
#include "materials/index/index_table.h"

namespace karat {

struct IndexChartOptions {
  std::optional<WavelengthRange> range;  // nm; otherwise what the tables cover
  double angle_deg = 0.0;                // of incidence, for the reflectance
  // Axes that are logarithmic: "wavelength", "n", "k", "reflectance"; not given: wavelengths that
  // span more than a factor of 12, k that spans more than 1000, n that spans more than 300.
  std::optional<std::vector<std::string>> log_axes;
  double width = 760.0, height = 640.0;  // pixels
};

// Panels of n, k (where a table has any) and the reflectance from vacuum. Curves end where the
// tables do; the measured rows are marked. The caption holds the references. Throws InputError
// where no table has a value in the range.
Chart index_chart(const std::vector<IndexTablePtr>& tables, const IndexChartOptions& options);

}  // namespace karat
