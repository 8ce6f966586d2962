// Index tables as text in the YAML format of refractiveindex.info.
#pragma once

#include <string>
#include <vector>

#include "materials/index/import/rows.h"

namespace karat {

// REFERENCES, COMMENTS (a line each) and the series as `tabulated nk`, `tabulated n`, `tabulated
// k`. Text is made valid UTF-8 without control characters; bytes that are not UTF-8 are taken for
// Latin-1.
std::string database_text(const std::string& reference, const std::vector<std::string>& comments,
                          const std::vector<ImportSeries>& series);

// A block "KEY: |" of the format, indented; "" for no text.
std::string database_block(const std::string& key, const std::vector<std::string>& lines);

}  // namespace karat
