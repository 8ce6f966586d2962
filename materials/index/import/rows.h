// The rows of a measured table on the way into the database's format.
#pragma once

#include <string>
#include <vector>

#include "materials/index/import/format.h"
#include "spectral/wavelengths.h"

namespace karat {

struct ImportRow {
  std::size_t line = 0;  // of the source
  WrittenNumber um, n, k;
};

// Rows in order of wavelength. `has_n` and `has_k`: what they list.
struct ImportSeries {
  bool has_n = false, has_k = false;
  std::vector<ImportRow> rows;

  WavelengthRange range_nm() const {
    return {rows.front().um.value * 1e3, rows.back().um.value * 1e3};
  }
};

// Converts one block: to micrometres, from the permittivity, to k >= 0 where `negate_k` says so;
// sorts, and leaves out rows that repeat another. Throws InputError for wavelengths that are not
// positive.
ImportSeries import_series(RawBlock block, AxisUnit unit, bool negate_k, const std::string& file,
                           std::vector<std::string>& warnings);

// One series of n and k where two have the same wavelengths, n in one and k in the other. Throws
// InputError where both list the same, or there is none of n.
std::vector<ImportSeries> joined_series(std::vector<ImportSeries> series, const std::string& file);

}  // namespace karat
