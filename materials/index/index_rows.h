// The rows of numbers in an index file's `data` blocks, and the curves that they make.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spectral/spectrum.h"

namespace karat {

// A finite number as the files write them: "0.5", ".5", "+5", "1e5", and Fortran's "1.80-17" and
// "1.8D-17". Nothing where the text is anything else.
std::optional<double> index_number(std::string_view text);

// The numbers of one line, separated by blanks and tabs. Throws InputError (at `origin`, `place`)
// that quotes what is not a number.
std::vector<double> index_numbers(std::string_view line, const std::string& origin,
                                  const std::string& place);

// Where a block stands in its file, for messages.
struct BlockPlace {
  std::string origin;  // the file, or the table's name
  std::string block;   // "DATA block 1"
  int first_line = 0;  // the file's line of the block's first row, from 1; 0 where unknown

  std::string row(std::size_t row_index) const;  // "DATA block 1, line 13"
};

// Rows of a wavelength in micrometres and one or two values, sorted by wavelength.
struct IndexRows {
  std::vector<double> wavelengths_nm;
  std::vector<double> first;
  std::vector<double> second;  // empty where a row has two numbers
};

// Reads `columns` (2 or 3) numbers a row; appends what is odd but usable (unsorted, duplicated,
// negative) to `warnings`. `names` are the value columns, "n", "k" or "nk". Throws InputError.
IndexRows index_rows(std::string_view text, std::string_view names, const BlockPlace& place,
                     std::vector<std::string>& warnings);

// Piecewise linear. Wavelengths do not decrease; where one is repeated the last row's value holds
// at it and the first row's ends the interval below.
SpectrumPtr rows_curve(std::vector<double> wavelengths_nm, std::vector<double> values);

}  // namespace karat
