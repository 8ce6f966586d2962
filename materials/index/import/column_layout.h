// Which column of a text file holds what.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "materials/index/import/format.h"
#include "materials/index/import/text_lines.h"

namespace karat {

struct ColumnLayout {
  std::vector<std::size_t> columns;  // of the axis and of each quantity, from 0
  std::vector<Quantity> quantities;  // the axis first
  AxisKind axis = AxisKind::kUnknown;
  std::optional<AxisUnit> unit;
  std::string unit_source;
  std::vector<std::string> unused;  // "column 4 \"std\""

  std::string description() const;  // "column 1 wavelength, 2 n, 3 k; column 4 \"std\" not used"
};

// What stands above the first row of a block.
struct BlockHead {
  std::vector<TextLine> header;    // lines that are neither rows nor comments
  std::vector<TextLine> comments;  // some tools write the names into a comment
};

// By the caller's list; the unit is what the file says above the axis. Throws InputError where the
// list is longer than the row, or not a table.
ColumnLayout layout_of_names(const ColumnNames& names, const BlockHead& head, std::size_t count,
                             char separator, const IndexSource& source, std::size_t line);

// By the names above a row of `count` cells, or, where there are none, wavelength, n and perhaps k.
// Throws InputError where the names are not understood, or the count is not 2 or 3 without names.
ColumnLayout layout_of_head(const BlockHead& head, std::size_t count, char separator,
                            const IndexSource& source, std::size_t line);

}  // namespace karat
