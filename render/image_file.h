// Image files: EXR with provenance, spectral EXR, PNG display views.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace karat {

// Scene-linear image, row by row from the top, channels interleaved.
struct Image {
  int width = 0, height = 0;
  std::vector<std::string> channels;  // "R", "G", "B", "normal.X", ...
  std::vector<float> values;
  std::map<std::string, std::string> attributes;    // written as strings
  std::map<std::string, double> number_attributes;  // written as floats
  // Where the pixels lie in the full image (data window and display window).
  int x = 0, y = 0, full_width = 0, full_height = 0;
  // Of a file that was read: its pixels were integers (PNG, JPEG), which hold encoded pictures
  // unless "oiio:ColorSpace" says otherwise. `values` are as the file holds them, from 0 to 1.
  bool from_integers = false;
};

// Writes an EXR (32-bit float, or half) through a temporary file that is renamed: the old file
// stays until the new one is whole. Throws RuntimeError.
void write_exr(const std::string& path, const Image& image, bool half = false);

// An 8- or 16-bit PNG of display-referred values in [0, 1] (clamped here, and only here).
void write_png(const std::string& path, const Image& image, int bits = 8);

// Reads any image that OpenImageIO reads, as float. Throws InputError.
Image read_image(const std::string& path);

// The same without the pixels: `values` is empty.
Image read_image_header(const std::string& path);

}  // namespace karat
