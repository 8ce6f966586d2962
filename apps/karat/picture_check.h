// The check of options that name a drawing to be written.
#pragma once

#include <string>

namespace karat {

// "" where charts and swatches can be written as that file, else what is allowed (for CLI11).
inline std::string picture_check(const std::string& file) {
  if (file.ends_with(".png") || file.ends_with(".svg")) return "";
  return "found \"" + file + "\", allowed: a file ending in .png or .svg";
}

}  // namespace karat
