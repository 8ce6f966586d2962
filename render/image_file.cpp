#include "render/image_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "render/image_codec.h"
#include "render/replace_file.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

void require_consistent(const Image& image) {
  const auto pixels = static_cast<std::size_t>(std::max(image.width, 0)) *
                      static_cast<std::size_t>(std::max(image.height, 0));
  if (pixels == 0 || image.channels.empty() ||
      image.values.size() != pixels * image.channels.size()) {
    throw std::logic_error("an image needs width * height * channels values");
  }
}

Imf::Header exr_header(const Image& image, Imf::PixelType type) {
  using Imath::Box2i;
  using Imath::V2i;
  const int full_width = image.full_width > 0 ? image.full_width : image.x + image.width;
  const int full_height = image.full_height > 0 ? image.full_height : image.y + image.height;
  const Box2i display(V2i(0, 0), V2i(full_width - 1, full_height - 1));
  const Box2i data(V2i(image.x, image.y),
                   V2i(image.x + image.width - 1, image.y + image.height - 1));
  Imf::Header header(display, data);
  header.compression() = Imf::ZIP_COMPRESSION;
  // Rec. 709 primaries and its white, x = 0.3127, y = 0.3290 (ITU-R BT.709-6, table 1).
  Imf::addChromaticities(header, Imf::Chromaticities({0.64f, 0.33f}, {0.30f, 0.60f}, {0.15f, 0.06f},
                                                     {0.3127f, 0.3290f}));
  for (const auto& [name, text] : image.attributes) {
    header.insert(name, Imf::StringAttribute(text));
  }
  for (const auto& [name, number] : image.number_attributes) {
    header.insert(name, Imf::FloatAttribute(static_cast<float>(number)));
  }
  for (const auto& name : image.channels) header.channels().insert(name, Imf::Channel(type));
  return header;
}

// `T` is float or half; `values` holds all channels interleaved, which OpenEXR only reads.
template <typename T>
void write_exr_pixels(const std::string& path, const Image& image, Imf::PixelType type,
                      const T* values) {
  const std::size_t pixel_bytes = image.channels.size() * sizeof(T);
  const std::size_t row_bytes = pixel_bytes * static_cast<std::size_t>(image.width);
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < image.channels.size(); ++c) {
    const Imath::Box2i window({image.x, image.y},
                              {image.x + image.width - 1, image.y + image.height - 1});
    buffer.insert(image.channels[c],
                  Imf::Slice::Make(type, values + c, window, pixel_bytes, row_bytes));
  }
  Imf::OutputFile file(path.c_str(), exr_header(image, type));
  file.setFrameBuffer(buffer);
  file.writePixels(image.height);
}

// Numbers that half cannot hold become the largest that it can: an infinity in a scene-linear image
// spoils every filter that touches it.
std::vector<Imath::half> to_half(const std::vector<float>& values) {
  constexpr float kLargest = 65504.0f;
  std::vector<Imath::half> halves(values.size());
  std::transform(values.begin(), values.end(), halves.begin(),
                 [&](float v) { return Imath::half(std::clamp(v, -kLargest, kLargest)); });
  return halves;
}

Image read_file(const std::string& path, bool pixels) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw InputError(path, "", "no such file");
  if (std::filesystem::is_directory(path, error)) {
    throw InputError(path, "", "is a folder, not a file");
  }
  Image image;
  const std::string failure = image_codec().read(path, pixels, image);
  if (!failure.empty()) throw InputError(path, "", failure);
  return image;
}

}  // namespace

void write_exr(const std::string& path, const Image& image, bool half) {
  require_consistent(image);
  replace_file(path, [&](const std::string& temporary) {
    if (half) {
      write_exr_pixels(temporary, image, Imf::HALF, to_half(image.values).data());
    } else {
      write_exr_pixels(temporary, image, Imf::FLOAT, image.values.data());
    }
  });
}

void write_png(const std::string& path, const Image& image, int bits) {
  require_consistent(image);
  if (bits != 8 && bits != 16) throw std::logic_error("a PNG has 8 or 16 bits");
  Image clamped = image;
  for (float& v : clamped.values) v = v > 0.0f ? std::min(v, 1.0f) : 0.0f;
  replace_file(path, [&](const std::string& temporary) {
    const std::string failure = image_codec().write_png(temporary, clamped, bits);
    if (!failure.empty()) throw RuntimeError(failure);
  });
}

Image read_image_header(const std::string& path) { return read_file(path, false); }

Image read_image(const std::string& path) { return read_file(path, true); }

}  // namespace karat
