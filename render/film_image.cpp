#include "render/film_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "materials/index/index_interpolation.h"
#include "render/version.h"
#include "spectral/colour.h"

namespace karat {
namespace {

bool asked_for(const Scene& scene, const char* channel) {
  const auto& channels = scene.settings.channels;
  return std::find(channels.begin(), channels.end(), channel) != channels.end();
}

Image empty_image(const Scene& scene, const Film& film) {
  Image image;
  const Crop crop = film.crop();
  image.x = crop.x0, image.y = crop.y0;
  image.width = crop.x1 - crop.x0, image.height = crop.y1 - crop.y0;
  image.full_width = scene.settings.width, image.full_height = scene.settings.height;
  return image;
}

// XYZ of the film to linear Rec. 709 under the scene's white.
Matrix3 rgb_matrix(const Scene& scene) {
  const Matrix3 adaptation = adaptation_to_d65(
      scene.settings.white, observer(scene.settings.observer), Adaptation::kCat16);
  return product(linear_srgb_of_xyz_matrix(), adaptation);
}

// Albedo is a reflectance: its white is equal energy, whatever lights the scene.
Matrix3 albedo_matrix(const Scene& scene) {
  return product(linear_srgb_of_xyz_matrix(),
                 adaptation_to_d65("E", observer(scene.settings.observer), Adaptation::kCat16));
}

// Appends values to an image's pixels in the order in which its channels were named.
class PixelWriter {
 public:
  explicit PixelWriter(Image& image) : image_(image) {}
  void add(double value) { image_.values.push_back(static_cast<float>(value)); }
  void add(const std::array<double, 3>& values) {
    for (const double value : values) add(value);
  }

 private:
  Image& image_;
};

void name_channels(const Scene& scene, Image& image) {
  auto& names = image.channels;
  names = {"R", "G", "B"};
  const auto layer = [&](const char* channel, std::initializer_list<const char*> suffixes) {
    if (!asked_for(scene, channel)) return;
    for (const char* suffix : suffixes) names.push_back(std::string(channel) + "." + suffix);
  };
  layer("albedo", {"R", "G", "B"});
  layer("normal", {"X", "Y", "Z"});
  layer("depth", {"Z"});
  layer("shape", {"id"});
  layer("samples", {"N"});
  layer("variance", {"Y"});
}

std::string lines(const std::vector<std::string>& items) {
  return fmt::format("{}", fmt::join(items, "\n"));
}

}  // namespace

Image film_image(const Scene& scene, const Film& film) {
  Image image = empty_image(scene, film);
  name_channels(scene, image);
  image.values.reserve(image.channels.size() * static_cast<std::size_t>(image.width) *
                       static_cast<std::size_t>(image.height));
  const Matrix3 to_rgb = rgb_matrix(scene), albedo_to_rgb = albedo_matrix(scene);
  const bool albedo = asked_for(scene, "albedo"), normal = asked_for(scene, "normal");
  const bool depth = asked_for(scene, "depth"), shape = asked_for(scene, "shape");
  const bool samples = asked_for(scene, "samples"), variance = asked_for(scene, "variance");
  PixelWriter write(image);
  for (int y = film.crop().y0; y < film.crop().y1; ++y) {
    for (int x = film.crop().x0; x < film.crop().x1; ++x) {
      const PixelValue value = film.pixel(x, y);
      const auto features = film.channels().features ? film.features(x, y) : Film::Features{};
      write.add(transformed(to_rgb, value.xyz));
      if (albedo) write.add(transformed(albedo_to_rgb, features.albedo_xyz));
      if (normal) write.add(features.normal);
      if (depth) write.add(features.depth);
      if (shape) write.add(features.shape);
      if (samples) write.add(value.samples);
      if (variance) write.add(value.variance_of_mean);
    }
  }
  return image;
}

Image spectral_image(const Scene& scene, const Film& film) {
  Image image = empty_image(scene, film);
  const int bins = film.channels().spectral_bins;
  const WavelengthRange range = scene.lattice.range();
  image.channels = {"R", "G", "B"};
  for (int bin = 0; bin < bins; ++bin) {
    std::string nm = fmt::format("{:.6f}", range.min_nm + (bin + 0.5) * range.width_nm() / bins);
    std::replace(nm.begin(), nm.end(), '.', ',');
    image.channels.push_back("S0." + nm + "nm");
  }
  image.attributes["spectralLayoutVersion"] = "1.0";
  image.attributes["emissiveUnits"] = "W.m^-2.sr^-1";
  const Matrix3 to_rgb = rgb_matrix(scene);
  PixelWriter write(image);
  for (int y = film.crop().y0; y < film.crop().y1; ++y) {
    for (int x = film.crop().x0; x < film.crop().x1; ++x) {
      write.add(transformed(to_rgb, film.pixel(x, y).xyz));
      for (int bin = 0; bin < bins; ++bin) write.add(film.spectral(x, y, bin));
    }
  }
  return image;
}

void add_provenance(Image& image, const Scene& scene, int samples, const RunFacts* facts) {
  auto& text = image.attributes;
  auto& number = image.number_attributes;
  const RenderSettings& settings = scene.settings;
  text["karat:version"] = version();
  if (!commit().empty()) text["karat:commit"] = commit();
  text["karat:scene"] = std::filesystem::path(scene.file).filename().string();
  text["karat:scene_hash"] = fmt::format("{:016x}", scene.content_hash);
  text["karat:observer"] = settings.observer;
  text["karat:white"] = settings.white;
  text["karat:seed"] = std::to_string(settings.seed);
  text["karat:sampler"] = settings.sampler;
  text["karat:integrator"] =
      fmt::format("{}, max_depth {}", settings.integrator, settings.max_depth);
  text["karat:wavelengths"] =
      fmt::format("{:g} to {:g} nm", scene.lattice.range().min_nm, scene.lattice.range().max_nm);
  text["karat:fresnel"] = scene.fresnel;
  std::vector<std::string> tables;
  for (const auto& table : scene.tables) tables.push_back(table.name + ": " + table.reference);
  text["karat:tables"] = lines(tables);
  text["karat:interpolation"] = description_of(interpolation_named(settings.interpolation));
  text["karat:warnings"] = lines(scene.warnings);
  number["karat:spp"] = samples;
  if (facts) {
    number["karat:render_seconds"] = facts->seconds;
    number["karat:threads"] = facts->threads;
  }
}

}  // namespace karat
