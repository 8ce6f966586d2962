// OpenImageIO, loaded when the first image is read or a PNG is written.
//
// Debian's OpenImageIO brings 250 shared libraries with it (OpenCV, GDAL, ffmpeg), whose linking
// took most of the time that every command needed to start. All calls of it are therefore in a
// shared module beside the program. This is no plugin system: there is one module, built and
// installed with the program, and it opens to nothing else.
#pragma once

#include <string>

#include "render/image_file.h"

namespace karat {

// What the module offers. The functions return an empty text, or what went wrong; no exception and
// no symbol of Karat's crosses its border.
struct ImageCodec {
  const char* version;  // Karat's, which must be the program's own
  // Header, and values as float where `pixels` is set.
  std::string (*read)(const std::string& path, bool pixels, Image& image);
  // 8 or 16 bits of values in [0, 1].
  std::string (*write_png)(const std::string& path, const Image& image, int bits);
};

// Throws RuntimeError, naming the places, where the module is missing, is not of this version, or
// cannot be linked. Thread-safe.
const ImageCodec& image_codec();

// Throws the same where no file of the module's name lies in any of the places: cheap, so that a
// render knows before its first ray.
void require_image_codec();

}  // namespace karat
