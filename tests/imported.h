// Measured files in tests: imported, and read back as the table that they became.
#pragma once

#include <string>
#include <vector>

#include "materials/index/import/header.h"
#include "materials/index/index_import.h"
#include "materials/index/index_table_file.h"
#include "spectral/support/error.h"

namespace karat {

// Plausible glass-like rows in nm: "400,1.53,0.002" ... 780, in steps of 20.
inline std::string glass_rows(const std::string& separator = ",", bool decimal_comma = false) {
  std::string text;
  for (int nm = 380; nm <= 780; nm += 20) {
    std::string n = "1." + std::to_string(5400 - nm / 2), k = "0.00" + std::to_string(nm);
    if (decimal_comma) n[1] = k[1] = ',';
    text += std::to_string(nm) + separator + n + separator + k + "\n";
  }
  return text;
}

inline IndexImport imported(const std::string& text, const IndexImportOptions& options = {},
                            const std::string& file = "film.csv") {
  IndexImportOptions with_reference = options;
  if (with_reference.reference.empty()) with_reference.reference = "A. Author, 2026";
  if (with_reference.file_name.empty()) with_reference.file_name = file;
  return import_index_text(text, file, with_reference);
}

inline IndexTablePtr table_of(const IndexImport& import) {
  return load_index_table_text(import.yaml, "my/test/film");
}

inline IndexTablePtr imported_table(const std::string& text, const IndexImportOptions& options = {},
                                    const std::string& file = "film.csv") {
  return table_of(imported(text, options, file));
}

// The message of the InputError that the import throws; "" where it throws none.
inline std::string import_error(const std::string& text, const IndexImportOptions& options = {},
                                const std::string& file = "film.csv") {
  try {
    imported(text, options, file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

inline IndexImportOptions with_columns(const std::vector<std::string>& names) {
  IndexImportOptions options;
  options.columns = column_names(names);
  return options;
}

inline IndexImportOptions with_unit(AxisUnit unit) {
  IndexImportOptions options;
  options.unit = unit;
  return options;
}

}  // namespace karat
