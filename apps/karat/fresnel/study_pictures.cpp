// Pictures of a study: what each model renders, and how far it is from exact.
#include <algorithm>
#include <filesystem>

#include "apps/karat/chart.h"
#include "apps/karat/fresnel/study_report.h"
#include "spectral/colour.h"

namespace karat {
namespace {

Image coloured(const std::vector<float>& values, int width, int height, double largest) {
  Image image;
  image.width = width, image.height = height;
  image.channels = {"R", "G", "B"};
  for (const float value : values) {
    const Colour colour =
        mapped_colour(std::clamp(double{value} / largest, 0.0, 1.0), ColourMap::kSequential);
    for (const double part : {colour.red, colour.green, colour.blue}) {
      image.values.push_back(static_cast<float>(part));
    }
  }
  return image;
}

// sRGB without any view: the colorimetric rendering that the differences are computed from.
Image displayed(const Image& linear) {
  Image image;
  image.width = linear.width, image.height = linear.height;
  image.channels = {"R", "G", "B"};
  for (std::size_t i = 0; i < linear.values.size(); i += linear.channels.size()) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double value = std::clamp(double{linear.values[i + j]}, 0.0, 1.0);
      image.values.push_back(static_cast<float>(srgb_encode(value)));
    }
  }
  return image;
}

}  // namespace

void write_study_pictures(const std::string& folder, const FresnelRenders& renders) {
  const std::string pictures = folder + "/pictures";
  std::filesystem::create_directories(pictures);
  for (const FresnelRender& render : renders.models) {
    const std::string name = pictures + "/" + render.model;
    write_png(name + ".png", displayed(render.picture));
    write_png(name + "-difference.png",
              coloured(render.difference.delta_e, renders.width, renders.height, kPictureScale));
  }
  std::vector<float> scale;
  for (int i = 0; i < 256; ++i) scale.push_back(static_cast<float>(i) / 255.0f);
  write_png(pictures + "/scale.png", coloured(scale, 256, 1, 1.0));
}

}  // namespace karat
