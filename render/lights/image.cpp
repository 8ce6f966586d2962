// An environment from a latitude-longitude image of scene-linear Rec.709 RGB.
//
// z is up: the image's upper border is +z, its middle faces +y, and +x is to the right of the
// middle, as a camera sees it that looks along +y. Texels are interpolated bilinearly. Directions
// are drawn in proportion to the mean luminance of each texel's cell, a hundredth of them evenly
// over the sphere.
#include <cctype>
#include <cmath>

#include "render/area_light.h"
#include "render/image_file.h"
#include "render/light.h"
#include "render/lights/direction_grid.h"
#include "render/lights/rgb_emission.h"
#include "spectral/colour.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

struct Texel {
  float r = 0.0f, g = 0.0f, b = 0.0f;
};
Texel operator+(Texel a, Texel b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
Texel operator*(Texel a, float s) { return {a.r * s, a.g * s, a.b * s}; }
float luminance(Texel c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; }

// Texels by (column, row); columns wrap, rows end at the poles.
class Panorama {
 public:
  Panorama(int width, int height, std::vector<Texel> texels)
      : width_(width), height_(height), texels_(std::move(texels)) {}

  int width() const { return width_; }
  int height() const { return height_; }

  Texel texel(int x, int y) const {
    x = x < 0 ? x + width_ : x >= width_ ? x - width_ : x;
    y = std::min(std::max(y, 0), height_ - 1);
    return texels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
  }

  Texel bilinear(Vec2 at) const {
    const float x = at.x * static_cast<float>(width_) - 0.5f;
    const float y = at.y * static_cast<float>(height_) - 0.5f;
    const float x0 = std::floor(x), y0 = std::floor(y);
    const int i = static_cast<int>(x0), j = static_cast<int>(y0);
    const float fx = x - x0, fy = y - y0;
    return (texel(i, j) * (1.0f - fx) + texel(i + 1, j) * fx) * (1.0f - fy) +
           (texel(i, j + 1) * (1.0f - fx) + texel(i + 1, j + 1) * fx) * fy;
  }

  // The mean of bilinear() over a texel's cell.
  Texel cell_mean(int x, int y) const {
    Texel mean;
    for (int j = -1; j <= 1; ++j) {
      const Texel row =
          texel(x - 1, y + j) * 0.125f + texel(x, y + j) * 0.75f + texel(x + 1, y + j) * 0.125f;
      mean = mean + row * (j == 0 ? 0.75f : 0.125f);
    }
    return mean;
  }

 private:
  int width_, height_;
  std::vector<Texel> texels_;
};

class ImageEnvironment final : public Light {
 public:
  ImageEnvironment(Panorama panorama, const LightContext& context, const std::string& file)
      : panorama_(std::move(panorama)),
        emission_(context.lattice),
        frame_{normalize(context.transform.x), normalize(context.transform.y),
               normalize(context.transform.z)} {
    const int width = panorama_.width(), height = panorama_.height();
    std::vector<float> weights;
    double sums[3] = {0, 0, 0};
    for (int y = 0; y < height; ++y) {
      const double share =
          std::sin(double{kPi} * (y + 0.5) / height) * std::sin(0.5 * double{kPi} / height) / width;
      for (int x = 0; x < width; ++x) {
        const Texel c = panorama_.cell_mean(x, y);
        weights.push_back(luminance(c));
        sums[0] += share * c.r, sums[1] += share * c.g, sums[2] += share * c.b;
      }
    }
    mean_radiance_ = static_cast<float>(sums[0]) * lattice_mean(emission_.red) +
                     static_cast<float>(sums[1]) * lattice_mean(emission_.green) +
                     static_cast<float>(sums[2]) * lattice_mean(emission_.blue);
    if (!(mean_radiance_ > 0.0f))
      throw InputError(file, "", "the image is black: it lights nothing");
    grid_ = DirectionGrid(width, height, weights);
  }

  std::optional<LightSample> sample(const Vec3&, const Vec2& u, int phase) const override {
    const DirectionGrid::Sample s = grid_.sample(u);
    if (!(s.pdf > 0.0f)) return std::nullopt;
    return LightSample{frame_.to_world(s.direction), std::numeric_limits<float>::infinity(), s.pdf,
                       seen(s.direction, phase)};
  }
  float pdf(const Vec3&, const Vec3& wi, const SurfaceHit*) const override {
    return grid_.pdf(frame_.to_local(wi));
  }
  SampledSpectrum radiance(const Vec3& wi, const SurfaceHit*, int phase) const override {
    return seen(frame_.to_local(wi), phase);
  }
  bool is_environment() const override { return true; }

  // Through a sphere around the scene: every direction's parallel light fills a disk, pi R^2.
  float power(float scene_radius) const override {
    return 4.0f * kPi * kPi * scene_radius * scene_radius * mean_radiance_;
  }

 private:
  SampledSpectrum seen(Vec3 local, int phase) const {
    const Texel c = panorama_.bilinear(latlong(local));
    return emission_(c.r, c.g, c.b, phase);
  }

  Panorama panorama_;
  RgbEmission emission_;
  Frame frame_;
  DirectionGrid grid_;
  float mean_radiance_ = 0.0f;
};

std::size_t channel_index(const Image& image, const std::string& file, const char* name) {
  const auto it = std::find(image.channels.begin(), image.channels.end(), name);
  if (it != image.channels.end()) return static_cast<std::size_t>(it - image.channels.begin());
  std::string found;
  for (const std::string& channel : image.channels) found += (found.empty() ? "" : ", ") + channel;
  throw InputError(file, "",
                   std::string("has no channel ") + name +
                       "; an environment needs R, G "
                       "and B. Found: " +
                       found);
}

// Pictures of integers hold values encoded for a display; radiance must be linear again.
bool is_encoded(const Image& image) {
  if (!image.from_integers) return false;
  const auto space = image.attributes.find("oiio:ColorSpace");
  std::string name = space == image.attributes.end() ? "" : space->second;
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name != "linear";
}

// What can be rendered, but is probably not what was meant.
void add_warnings(const Image& image, const std::string& file, std::vector<std::string>& warnings) {
  if (is_encoded(image)) {
    warnings.push_back(file +
                       ": a picture of 8 or 16 bits, decoded from sRGB; its lights end at 1, so "
                       "lamps and the sun are too dim: an EXR or HDR image holds them");
  }
  if (image.width != 2 * image.height) {
    warnings.push_back(file + ": " + std::to_string(image.width) + " x " +
                       std::to_string(image.height) +
                       " pixels, but a latitude-longitude image is twice as wide as high: the sky "
                       "is stretched");
  }
}

Panorama read_panorama(const std::string& file, float scale, std::vector<std::string>* warnings) {
  const Image image = read_image(file);
  const std::size_t channels[3] = {channel_index(image, file, "R"), channel_index(image, file, "G"),
                                   channel_index(image, file, "B")};
  const auto width = static_cast<std::size_t>(image.width);
  const std::size_t count = width * static_cast<std::size_t>(image.height);
  const bool encoded = is_encoded(image);
  std::vector<Texel> texels(count);
  std::size_t negative = 0;
  for (std::size_t i = 0; i < count; ++i) {
    float value[3];
    for (int c = 0; c < 3; ++c) {
      const float stored = image.values[i * image.channels.size() + channels[c]];
      value[c] = scale * (encoded ? static_cast<float>(srgb_decode(double{stored})) : stored);
      if (!std::isfinite(value[c])) {
        throw InputError(
            file, "texel (" + std::to_string(i % width) + ", " + std::to_string(i / width) + ")",
            "is not finite; radiance must be");
      }
      negative += value[c] < 0.0f;
      value[c] = std::max(value[c], 0.0f);
    }
    texels[i] = {value[0], value[1], value[2]};
  }
  if (warnings) add_warnings(image, file, *warnings);
  if (negative > 0 && warnings) {
    warnings->push_back(file + ": " + std::to_string(negative) +
                        " negative values (colours outside Rec.709) count as 0");
  }
  return Panorama(image.width, image.height, std::move(texels));
}

void check_rotation(const Transform& t) {
  const auto close = [](float a, float b) { return std::abs(a - b) <= 1e-4f; };
  const Vec3 x = normalize(t.x), y = normalize(t.y), z = normalize(t.z);
  if (close(dot(x, y), 0) && close(dot(y, z), 0) && close(dot(z, x), 0)) return;
  throw InputError("the transform of an environment may turn it, not shear it");
}

class ImageType final : public LightType {
 public:
  std::string description() const override {
    return "An environment from a latitude-longitude image; z is up, the image's middle faces +y.";
  }

  std::vector<ParameterInfo> parameters() const override {
    return {
        {.name = "file",
         .type = ParameterType::kPath,
         .description = "Scene-linear Rec.709 RGB image (EXR, HDR), twice as wide as high; 1 is a "
                        "radiance as bright as 1 W m^-2 sr^-1 nm^-1 at every wavelength. PNG and "
                        "JPEG are decoded from sRGB, with a warning.",
         .required = true},
        {.name = "scale",
         .description = "Factor on all values.",
         .default_json = "1",
         .min = 0,
         .exclusive_min = true}};
  }

  std::unique_ptr<const Light> create(const Parameters& parameters,
                                      const LightContext& context) const override {
    check_rotation(context.transform);
    const std::string& file = parameters.string("file");
    const auto scale = static_cast<float>(parameters.number("scale"));
    return std::make_unique<ImageEnvironment>(read_panorama(file, scale, context.warnings), context,
                                              file);
  }
};

KARAT_REGISTER(LightType, "image", ImageType);

}  // namespace
}  // namespace karat
