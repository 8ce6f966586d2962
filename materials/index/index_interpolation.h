// How an index table is read between its samples.
#pragma once

#include <string>
#include <vector>

#include "materials/index/index_table.h"

namespace karat {

enum class Interpolation {
  kLinear,         // in wavelength, on n and on k: as refractiveindex.info's own site does
  kMonotoneCubic,  // in wavelength, on n and on k: Steffen 1990 (spectral/monotone_cubic.h)
};

// "linear" and "monotone-cubic", as scenes and options say it.
const std::vector<std::string>& interpolation_names();
// Throws InputError listing the names.
Interpolation interpolation_named(const std::string& name);
std::string name_of(Interpolation interpolation);

// "monotone cubic in wavelength on n and k (Steffen 1990)", for metadata and captions.
std::string description_of(Interpolation interpolation);

// The table with its samples joined in that way; parts without samples (formulas, mixtures) stay as
// they are. Range, source and warnings are the table's.
IndexTablePtr interpolated(const IndexTablePtr& table, Interpolation interpolation);

}  // namespace karat
