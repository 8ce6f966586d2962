// The picture of karat nk compare.
#pragma once

#include <string>
#include <vector>

#include "spectral/colour.h"

namespace karat {

// A patch of colour with text on it. Patches without a colour are hatched.
struct Swatch {
  bool has_colour = false;
  Rgb linear_srgb{};
  std::string name;                // in bold
  std::vector<std::string> lines;  // below it
};

// Draws the patches edge to edge, row by row, below a heading and a line of small print, as PNG or
// SVG by the ending of `file`. All colours are scaled by one factor where a channel exceeds 1, so
// that none is cut off, and the picture says by how much. Throws RuntimeError where the file cannot
// be written.
void write_swatches(const std::string& file, const std::string& heading,
                    const std::string& small_print, const std::vector<Swatch>& swatches);

}  // namespace karat
