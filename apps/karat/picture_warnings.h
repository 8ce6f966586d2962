// Pictures that are seldom meant: black ones, and those that the display cannot show.
#pragma once

#include <string>
#include <vector>

#include "render/image_file.h"
#include "spectral/ocio_view.h"

namespace karat {

// At most one warning about a picture whose first channels are linear R, G, B:
//  - every pixel is exactly 0 (not where feature layers were asked for: those are the picture);
//  - with a display view (its exposure included), more than half of the pixels lie clearly above
//  its white, or the brightest
//    stays below a few per cent of it; with the --exposure that would show it.
// Crops are parts of pictures and say nothing about the whole; flat areas, as those of a mask, have
// nothing that another exposure would show.
std::vector<std::string> picture_warnings(const Image& image, const OcioView* view);

}  // namespace karat
