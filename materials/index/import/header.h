// What the names above the columns of a measured table mean.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "materials/index/import/format.h"

namespace karat {

// "Wavelength (nm)" is the axis, a wavelength, in nm.
struct ColumnMeaning {
  std::optional<Quantity> quantity;
  AxisKind axis = AxisKind::kUnknown;
  std::optional<AxisUnit> unit;
};

// The meaning of one name: "lambda_um", "λ/nm", "Photon energy [eV]", "n", "Re(n)", "eps2", "nm".
// Everything that is not known means nothing.
ColumnMeaning column_meaning(std::string_view name);

// The names of a header line that is separated like the rows, or by blanks: then "Wavelength (nm)"
// is one name. Nothing where the line cannot be split into `count` or more names.
std::vector<std::string> header_names(std::string_view line, char separator, std::size_t count);

// A list that --columns takes: "wavelength,n,-,k". Throws InputError listing what is allowed.
ColumnNames column_names(const std::vector<std::string>& names);

}  // namespace karat
