#include "render/alloy_presets.h"

#include <map>

#include "materials/index/index_path.h"
#include "spectral/spectrum_file.h"
#include "spectral/support/data_path.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

namespace fs = std::filesystem;

void add_users(std::map<std::string, AlloyPreset>& presets) {
  std::error_code error;
  for (fs::directory_iterator it(user_alloy_folder(), error), end; !error && it != end;
       it.increment(error)) {
    const fs::path& file = it->path();
    if (file.extension() != ".json") continue;
    const std::string name = file.stem().string();
    presets.emplace(name, AlloyPreset{name, file.string(), false});
  }
}

}  // namespace

fs::path user_alloy_folder() {
  const fs::path tables = user_index_folder();
  return tables.empty() ? tables : tables.parent_path() / "alloys";
}

std::vector<AlloyPreset> alloy_presets() {
  std::map<std::string, AlloyPreset> presets;
  for (const std::string& name : data_names("alloys")) {
    presets.emplace(name, AlloyPreset{name, data_path("alloys/" + name + ".json"), true});
  }
  add_users(presets);
  std::vector<AlloyPreset> sorted;
  for (auto& [name, preset] : presets) sorted.push_back(std::move(preset));
  return sorted;
}

std::vector<std::string> alloy_names() {
  std::vector<std::string> names;
  for (AlloyPreset& preset : alloy_presets()) names.push_back(std::move(preset.name));
  return names;
}

std::string alloy_file(const std::string& name) {
  for (AlloyPreset& preset : alloy_presets()) {
    if (preset.name == name) return std::move(preset.file);
  }
  throw InputError(unknown_name_message("alloy", name, alloy_names()));
}

}  // namespace karat
