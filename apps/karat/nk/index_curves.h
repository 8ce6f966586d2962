// The curves of one index table, ready to be drawn.
#pragma once

#include <vector>

#include "materials/index/index_table.h"

namespace karat {

// Values at common wavelengths; not a number where the table has no index.
struct IndexCurves {
  std::vector<double> nm;
  std::vector<double> n, k;
  std::vector<double> r, rs, rp;  // reflectance from vacuum: unpolarised, s and p
  // Which of the wavelengths are rows of the table: of n, of k, and of both (for r).
  std::vector<std::size_t> n_rows, k_rows, r_rows;
};

// Over the part of `range` that the table covers: its rows, and `count` wavelengths between, spread
// evenly or, with `log`, evenly in their logarithm. Empty where the table covers none of it.
IndexCurves index_curves(const IndexTable& table, WavelengthRange range, double angle_deg,
                         int count, bool log);

}  // namespace karat
