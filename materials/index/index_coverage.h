// Whether a table was measured where somebody asks.
#pragma once

#include "materials/index/index_table.h"

namespace karat {

// True in the table's range, up to the rounding of micrometres to nanometres.
inline bool covers_wavelength(const IndexTable& table, double wavelength_nm) {
  return require_coverage(table, {wavelength_nm, wavelength_nm}, RangePolicy::kClamp).empty();
}

}  // namespace karat
