// Measured tables as people have them (CSV and other columns of text, SOPRA and IMD .nk files, the
// permittivity, the database's YAML) made into the text of an index table of the database.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "materials/index/import/format.h"

namespace karat {

struct IndexImportOptions {
  std::string format;               // a registered IndexFormat; "": the one the file looks like
  std::optional<AxisUnit> unit;     // instead of the one that the file states
  ColumnNames columns;              // instead of the file's own names; text columns only
  bool negate_k = false;            // the file writes n - ik with k <= 0
  bool accept_implausible = false;  // what would be refused becomes a warning
  std::string reference;            // REFERENCES; may be empty for YAML, which has its own
  std::string file_name;            // what COMMENTS call the file
  std::string date;                 // "2026-11-22", for COMMENTS; "": none
};

struct ValueRange {
  double min = 0.0, max = 0.0;
};

// What was understood, for people and machines.
struct IndexImport {
  std::string format;       // "columns of numbers"
  std::string description;  // "comma-separated text; column 1 wavelength, 2 n, 3 k"
  std::string unit;         // "nm (line 1)"; "" for YAML
  // Of the rows, each wavelength once; nothing for YAML.
  std::size_t rows = 0;
  std::size_t visible_rows = 0;  // in 380 to 780 nm
  std::optional<ValueRange> n, k;
  std::vector<std::string> warnings;
  std::string yaml;  // the table, which load_index_table_text reads
};

// Reads a table out of a file's text; `file` names it in messages, and its ending helps to tell the
// format. Digits stay as they were written wherever no formula changes a value; rows are in order
// of wavelength. Throws InputError naming file, line and column, what was found and what is
// allowed; and one that lists everything implausible (a unit that cannot be meant, the other sign
// convention, magnitudes no material has) together with the option that says what is meant.
IndexImport import_index_text(std::string_view text, const std::string& file,
                              const IndexImportOptions& options);

// The same of a file of at most 16 MiB.
IndexImport import_index_file(const std::string& path, const IndexImportOptions& options);

}  // namespace karat
