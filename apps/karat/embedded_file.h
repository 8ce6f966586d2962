// Files that were built into the program: parts of reports, and the chart library that they use.
#pragma once

#include <string_view>

namespace karat {

// The bytes of a file that CMakeLists.txt names for embedding, by its name without the folder
// ("study.css"). Throws std::out_of_range for any other.
std::string_view embedded_file(std::string_view name);

}  // namespace karat
