// Index tables in the YAML format of refractiveindex.info (docs/tables.md describes it).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "materials/index/index_table.h"

namespace karat {

// Reads a table from a file, or from a file's text. `name` is what the table is called in messages
// and in images. Of n and k the first DATA block that lists each counts. Throws InputError naming
// file (or name) and line for anything that is not a table of n, or of n and k. Problems that leave
// the data usable are in warnings(); negative values are kept as they stand (see on_lattice).
IndexTablePtr load_index_table_file(const std::string& path, const std::string& name);
IndexTablePtr load_index_table_text(const std::string& text, const std::string& name);

// The text of a file that is to be a table. Throws InputError naming the file where it is none, a
// folder, unreadable, or larger than 16 MiB.
std::string read_index_file(const std::string& path);

// A DATA block as a file lists it.
struct IndexBlock {
  std::string type;      // "tabulated nk", "formula 2"
  std::size_t rows = 0;  // 0 for a formula
  WavelengthRange range;
};

// As above, and tells of every block, also where the file is no table because it lists k alone.
IndexTablePtr load_index_table_file(const std::string& path, const std::string& name,
                                    std::vector<IndexBlock>& blocks);

}  // namespace karat
