#include "spectral/support/data_path.h"

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "spectral/support/error.h"

namespace karat {

std::string data_path(const std::string& relative) {
  std::vector<std::filesystem::path> places;
  if (const char* folder = std::getenv("KARAT_DATA"); folder && *folder)
    places.emplace_back(folder);
  places.emplace_back(KARAT_SOURCE_DATA_DIR);
  places.emplace_back(KARAT_INSTALL_DATA_DIR);
  std::string tried;
  for (const auto& place : places) {
    std::error_code ignored;
    if (std::filesystem::exists(place / relative, ignored)) return (place / relative).string();
    tried += (tried.empty() ? "" : ", ") + place.string();
  }
  throw RuntimeError("data file \"" + relative + "\" is in none of: " + tried +
                     " (set KARAT_DATA to Karat's data folder)");
}

}  // namespace karat
