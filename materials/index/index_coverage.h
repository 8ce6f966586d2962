// Whether a table was measured where somebody asks.
#pragma once

#include "materials/index/index_table.h"

namespace karat {

// True where what was measured over `measured` counts as known over `needed`: all of it, but for at
// most 0.01 nm at each end (and at most 1e-4 of the wavelength), where the end value is held. Axes
// in eV or micrometres are rounded by that much: 3.2627 eV is meant to be 380 nm, and is 380.0052.
bool is_covered(WavelengthRange measured, WavelengthRange needed);

// True in the table's range, up to the rounding that is_covered allows.
inline bool covers_wavelength(const IndexTable& table, double wavelength_nm) {
  return require_coverage(table, {wavelength_nm, wavelength_nm}, RangePolicy::kClamp).empty();
}

}  // namespace karat
