// Alloys by name: Karat's own in data/alloys, and the user's.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace karat {

// $XDG_DATA_HOME/karat/alloys, or ~/.local/share/karat/alloys, beside the user's tables; empty
// where neither variable is set.
std::filesystem::path user_alloy_folder();

// A preset: NAME.json holds "description", "source" and "nk", an index as scenes write it.
struct AlloyPreset {
  std::string name;
  std::string file;
  bool own = true;  // Karat's, not the user's
};

// All presets in alphabetical order. Karat's own are asked first: a user's file of the same name is
// left out.
std::vector<AlloyPreset> alloy_presets();

// Their names.
std::vector<std::string> alloy_names();

// The file of a preset. Throws InputError with the nearest name and the names there are.
std::string alloy_file(const std::string& name);

}  // namespace karat
