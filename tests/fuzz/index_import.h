// What every format of measured tables must keep for any bytes.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "materials/index/index_import.h"
#include "materials/index/index_table_file.h"
#include "spectral/support/error.h"

namespace karat {

// Any bytes are a table or an InputError. A table that was accepted is one of the database: it
// loads, is finite throughout its range, and, unless the caller insisted, has neither n < 0 nor k <
// 0.
inline int fuzz_import(const char* format, const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  IndexImportOptions options;
  options.format = format;
  options.reference = "fuzz";
  options.file_name = "fuzz.csv";
  // The first byte chooses the options, so that the paths behind them are met.
  const unsigned choice = bytes[0];
  options.accept_implausible = (choice & 1) != 0;
  options.negate_k = (choice & 2) != 0;
  if ((choice & 4) != 0) {
    options.unit = kAxisUnits[(choice >> 3) % kAxisUnits.size()];
  } else if ((choice & 64) != 0) {
    options.format.clear();  // what the bytes look like
  }
  if ((choice & 128) != 0) {
    options.columns = {Quantity::kAxis, std::nullopt, Quantity::kEps1, Quantity::kEps2};
  }
  const std::string text(reinterpret_cast<const char*>(bytes + 1), size - 1);
  IndexImport import;
  try {
    import = import_index_text(text, "fuzz.csv", options);
  } catch (const InputError&) {
    return 0;
  }
  if (import.unit.empty()) return 0;  // YAML: index_table_fuzz looks into these
  const IndexTablePtr table = load_index_table_text(import.yaml, "fuzz");
  const WavelengthRange range = table->range();
  for (int i = 0; i <= 32; ++i) {
    const ComplexIndex index = table->at(range.min_nm + range.width_nm() * i / 32.0);
    if (!std::isfinite(index.n) || !std::isfinite(index.k)) std::abort();
    if (!options.accept_implausible && (index.n < 0.0 || index.k < 0.0)) std::abort();
  }
  return 0;
}

}  // namespace karat
