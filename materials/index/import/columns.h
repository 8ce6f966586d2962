// Text with a row of numbers a line: CSV, TSV, blanks; what instruments and spreadsheets write.
#pragma once

#include "materials/index/import/format.h"

namespace karat {

// Separators, decimal commas, comments and names above the columns are found out; a further line of
// names begins a further block (refractiveindex.info exports n and k so). Throws InputError.
RawTable read_columns(const IndexSource& source, const ColumnNames& columns);

}  // namespace karat
