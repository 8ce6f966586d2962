// The module karat_images.so: see render/image_codec.h.
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "render/image_codec.h"

namespace karat {
namespace {

constexpr std::size_t kMaxImageFloats = std::size_t{1} << 32;

Image header_of(const OIIO::ImageSpec& spec) {
  Image image;
  image.width = spec.width, image.height = spec.height;
  image.channels = spec.channelnames;
  image.x = spec.x - spec.full_x, image.y = spec.y - spec.full_y;
  image.full_width = spec.full_width, image.full_height = spec.full_height;
  image.from_integers = !spec.format.is_floating_point();
  for (const auto& attribute : spec.extra_attribs) {
    const std::string name = attribute.name().string();
    if (attribute.type() == OIIO::TypeFloat) {
      image.number_attributes[name] = static_cast<double>(attribute.get_float());
    } else {
      image.attributes[name] = attribute.get_string();
    }
  }
  return image;
}

std::string read_file(const std::string& path, bool pixels, Image& image) try {
  const auto input = OIIO::ImageInput::open(path);
  if (!input) return "not a readable image: " + OIIO::geterror();
  const OIIO::ImageSpec& spec = input->spec();
  image = header_of(spec);
  if (!pixels) return {};
  const auto floats =
      static_cast<std::size_t>(spec.image_pixels()) * static_cast<std::size_t>(spec.nchannels);
  if (spec.depth > 1 || floats > kMaxImageFloats) {
    return "too large: at most 2^32 values in two dimensions are read";
  }
  image.values.resize(floats);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data())) {
    return "damaged image: " + input->geterror();
  }
  return {};
} catch (const std::exception& failure) {
  return failure.what();
}

std::string write_file(const std::string& path, const Image& image, int bits) try {
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                       bits == 8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16);
  for (const auto& [name, text] : image.attributes) spec.attribute(name, text);
  // PNG knows text only.
  for (const auto& [name, number] : image.number_attributes) {
    spec.attribute(name, fmt::format("{:.9g}", number));
  }
  const auto output = OIIO::ImageOutput::create("png");
  if (!output) return "OpenImageIO was built without PNG";
  const bool written = output->open(path, spec) &&
                       output->write_image(OIIO::TypeDesc::FLOAT, image.values.data()) &&
                       output->close();
  return written ? "" : output->geterror();
} catch (const std::exception& failure) {
  return failure.what();
}

}  // namespace
}  // namespace karat

extern "C" __attribute__((visibility("default"))) const karat::ImageCodec karat_image_codec;
const karat::ImageCodec karat_image_codec{KARAT_VERSION, karat::read_file, karat::write_file};
