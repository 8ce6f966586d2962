// Colours for people to look at: bytes, hexadecimal text, patches on a terminal.
#pragma once

#include <array>
#include <string>

#include "spectral/colour.h"

namespace karat {

// A display's nearest colour: gold's red lies above 1, where no display can follow.
std::array<int, 3> display_bytes(const Rgb& linear);

// "#rrggbb" of the same.
std::string display_hex(const Rgb& linear);

// Two spaces and a patch of the colour where standard output is a terminal that shows 24-bit
// colours and NO_COLOR is not set; otherwise nothing.
std::string swatch(const Rgb& linear);

}  // namespace karat
