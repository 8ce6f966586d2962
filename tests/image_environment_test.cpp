#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "default_parameters.h"
#include "render/light.h"
#include "render/lights/direction_grid.h"
#include "render/lights/rgb_emission.h"
#include "spectral/support/error.h"

using namespace karat;

namespace {

constexpr double kPiD = 3.14159265358979323846;

using Texels = std::vector<float>;  // RGB, row by row

// Writes an EXR into a folder of its own and makes the light from it.
class ImageLight {
 public:
  ImageLight(int width, int height, const Texels& texels, const Transform& transform = {},
             double scale = 1.0, const std::string& ending = "exr") {
    std::string folder =
        (std::filesystem::temp_directory_path() / "karat_environment_XXXXXX").string();
    REQUIRE(mkdtemp(folder.data()));
    folder_ = folder;
    file_ = folder + "/sky." + ending;
    const auto output = OIIO::ImageOutput::create(file_);
    REQUIRE(output);
    REQUIRE(output->open(
        file_, OIIO::ImageSpec(width, height, 3,
                               ending == "exr" ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8)));
    REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, texels.data()));
    REQUIRE(output->close());
    transform_ = transform;
    scale_ = scale;
  }
  ~ImageLight() { std::filesystem::remove_all(folder_); }

  std::unique_ptr<const Light> make() {
    const LightType* type = Registry<LightType>::instance().find("image");
    REQUIRE(type);
    Parameters parameters = default_parameters(type->parameters());
    parameters.set("file", file_);
    parameters.set("scale", scale_);
    return type->create(parameters, {WavelengthLattice(), transform_, &warnings});
  }

  std::vector<std::string> warnings;

 private:
  std::filesystem::path folder_;
  std::string file_;
  Transform transform_;
  double scale_ = 1.0;
};

// A dim sky with a bright lamp of a few texels, some of them black.
Texels lamp_sky(int width, int height) {
  Texels texels;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool lamp = x >= 3 && x < 5 && y >= 2 && y<4, dark = y> height / 2;
      const float v = lamp ? 200.0f : dark ? 0.0f : 0.5f + 0.1f * static_cast<float>(x % 3);
      texels.insert(texels.end(), {v, 0.8f * v, 0.5f * v});
    }
  }
  return texels;
}

Vec3 direction(double longitude, double z) {
  const double angle = 2 * kPiD * longitude - kPiD, r = std::sqrt(1 - z * z);
  return {static_cast<float>(r * std::sin(angle)), static_cast<float>(r * std::cos(angle)),
          static_cast<float>(z)};
}

// Rows of "nm,a,b,c" as in the reference figures.
std::vector<std::vector<double>> read_csv(const std::string& path) {
  std::vector<std::vector<double>> rows;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] < '0' || line[0] > '9') continue;
    std::stringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

}  // namespace

TEST_CASE("emitted colours are the RGB that was asked for", "[image_environment]") {
  const auto observer = read_csv(KARAT_TEST_REFERENCE_DIR "/figures/cie/cie1931_2deg_1nm.csv");
  const auto d65 = read_csv(KARAT_TEST_REFERENCE_DIR "/figures/cie/illuminant_D65_1nm.csv");
  if (observer.empty() || d65.empty()) {
    WARN("skipped: no reference figures");
    return;
  }
  // 512 bins of 1 nm centred on whole nanometres from 360 on; the observer ends at 830 nm.
  const WavelengthLattice lattice({359.5, 871.5});
  const RgbEmission emission(lattice);
  const auto bin = [](const LatticeSpectrum& s, std::size_t i) {
    const int k = static_cast<int>(i);
    return double{s[k % kPhases][k / kPhases]};
  };
  // The table is linear over 5 nm: its values at the knots, where a bin's mean is not the value,
  // follow from the two bins beside.
  const auto at = [&](const LatticeSpectrum& s, std::size_t i) {
    if (i % 5 != 0) return bin(s, i);
    return i == 0 ? 2 * bin(s, 1) - bin(s, 2) : 2 * bin(s, i - 1) - bin(s, i - 2);
  };
  double y_sum = 0.0, white_luminance = 0.0;
  for (std::size_t i = 0; i < observer.size(); ++i) {
    REQUIRE(observer[i][0] == 360.0 + static_cast<double>(i));
    y_sum += observer[i][2];
    white_luminance += observer[i][2] * d65[i + 60][1];
  }
  const auto integrate = [&](const LatticeSpectrum& spectrum, std::size_t k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < observer.size(); ++i) sum += at(spectrum, i) * observer[i][k + 1];
    return sum / y_sum;
  };
  // Linear sRGB of XYZ (IEC 61966-2-1).
  const double m[3][3] = {{3.24096994, -1.53738318, -0.49861076},
                          {-0.96924364, 1.8759675, 0.04155506},
                          {0.05563008, -0.20397696, 1.05697151}};
  double rgb_of_d65[3] = {0, 0, 0};
  for (std::size_t i = 0; i < observer.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < 3; ++k) {
        rgb_of_d65[c] += m[c][k] * observer[i][k + 1] * d65[i + 60][1] / white_luminance;
      }
    }
  }
  const LatticeSpectrum* basis[3] = {&emission.red, &emission.green, &emission.blue};
  for (int c = 0; c < 3; ++c) {
    double colour[3];
    for (std::size_t k = 0; k < 3; ++k) colour[k] = integrate(*basis[c], k);
    for (int k = 0; k < 3; ++k) {
      const double value = m[k][0] * colour[0] + m[k][1] * colour[1] + m[k][2] * colour[2];
      // The primaries add up to D65 itself, not to the rounded (0.3127, 0.3290) of sRGB: its blue
      // is 0.99976. Floats leave 1e-6.
      CHECK(value == Approx(k == c ? rgb_of_d65[k] : 0.0).margin(1e-6));
    }
  }
  // Together they are D65 with the luminance of an equal-energy spectrum, and none is negative.
  for (std::size_t i = 0; i < observer.size(); ++i) {
    double sum = 0.0;
    for (const LatticeSpectrum* b : basis) {
      CHECK(bin(*b, i) >= 0.0);
      sum += at(*b, i);
    }
    CHECK(sum == Approx(d65[i + 60][1] * y_sum / white_luminance).epsilon(1e-5));
  }
}

TEST_CASE("the image's middle faces +y and +x is to its right", "[image_environment]") {
  // Left half red, right half green, the upper border blue.
  Texels texels;
  const int width = 32, height = 16;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float blue = y < 2 ? 1.0f : 0.0f, left = x < width / 2 ? 1.0f : 0.0f;
      texels.insert(texels.end(), {(1 - blue) * left, (1 - blue) * (1 - left), blue});
    }
  }
  const RgbEmission emission{WavelengthLattice()};
  const auto equal = [](const SampledSpectrum& a, const SampledSpectrum& b) {
    return max_lane(a - b) < 1e-5f && max_lane(b - a) < 1e-5f;
  };
  ImageLight image(width, height, texels, {}, 3.0);
  const auto light = image.make();
  CHECK(equal(light->radiance({1, 0, 0}, nullptr, 5), emission(0, 3, 0, 5)));
  CHECK(equal(light->radiance({-1, 0, 0}, nullptr, 5), emission(3, 0, 0, 5)));
  CHECK(equal(light->radiance({0, 0, 1}, nullptr, 5), emission(0, 0, 3, 5)));
  CHECK(equal(light->radiance({0, 1, 0}, nullptr, 5), emission(1.5f, 1.5f, 0, 5)));
  // A quarter turn about z takes what was at +x to +y.
  ImageLight turned_image(width, height, texels, Transform::rotate({0, 0, 1}, 0.5f * kPi));
  const auto turned = turned_image.make();
  CHECK(equal(turned->radiance({0, 1, 0}, nullptr, 5), emission(0, 1, 0, 5)));
  CHECK(equal(turned->radiance({0, -1, 0}, nullptr, 5), emission(1, 0, 0, 5)));
}

TEST_CASE("image samples follow the density, and the density the image", "[image_environment]") {
  const int width = 24, height = 12, n = 100000;
  const Transform turn = Transform::rotate({1, 2, 3}, 0.9f);
  ImageLight image(width, height, lamp_sky(width, height), turn);
  const auto light = image.make();

  // The density integrates to 1, exactly cell by cell.
  std::vector<double> expected, counted(width * height);
  double integral = 0.0;
  for (int y = 0; y < height; ++y) {
    const double z0 = std::cos(kPiD * y / height), z1 = std::cos(kPiD * (y + 1) / height);
    for (int x = 0; x < width; ++x) {
      const Vec3 wi = turn.vector(direction((x + 0.5) / width, 0.5 * (z0 + z1)));
      const double mass = light->pdf({}, wi, nullptr) * (z0 - z1) * 2 * kPiD / width;
      CHECK(mass > 0.0);
      expected.push_back(mass * n);
      integral += mass;
    }
  }
  CHECK(integral == Approx(1.0).epsilon(1e-5));

  std::mt19937 engine(11);
  std::uniform_real_distribution<float> uniform(0.0f, 0.9999999f);
  double estimate = 0.0, squares = 0.0, most = 0.0;
  int inconsistent = 0;
  for (int i = 0; i < n; ++i) {
    const float u = uniform(engine);
    const auto s = light->sample({}, {u, uniform(engine)}, 0);
    REQUIRE(s);
    const Vec3 local{dot(s->wi, turn.x), dot(s->wi, turn.y), dot(s->wi, turn.z)};
    const Vec2 at = latlong(local);
    const int x = std::min(static_cast<int>(at.x * width), width - 1);
    const int y = std::min(static_cast<int>(at.y * height), height - 1);
    ++counted[static_cast<std::size_t>(y * width + x)];
    inconsistent += std::abs(light->pdf({}, s->wi, nullptr) / s->pdf - 1.0f) > 1e-4f;
    const double value = double{s->radiance[3]} / double{s->pdf};
    estimate += value, squares += value * value, most = std::max(most, value);
  }
  CHECK(inconsistent < n / 1000);  // only at the cells' borders
  double chi2 = 0.0, pooled_expected = 0.0, pooled_counted = 0.0, cells = -1;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    pooled_expected += expected[i], pooled_counted += counted[i];
    if (pooled_expected < 25.0) continue;
    chi2 += std::pow(pooled_counted - pooled_expected, 2) / pooled_expected;
    ++cells;
    pooled_expected = pooled_counted = 0.0;
  }
  REQUIRE(cells > 20);
  const double deviate =
      (std::cbrt(chi2 / cells) - (1 - 2 / (9 * cells))) / std::sqrt(2 / (9 * cells));
  CHECK(deviate < 4.0);

  // The estimate of the integral of radiance, against quadrature.
  double quadrature = 0.0;
  const int fine = 20;
  for (int y = 0; y < height * fine; ++y) {
    const double z0 = std::cos(kPiD * y / (height * fine));
    const double z1 = std::cos(kPiD * (y + 1) / (height * fine));
    for (int x = 0; x < width * fine; ++x) {
      const Vec3 wi = turn.vector(direction((x + 0.5) / (width * fine), 0.5 * (z0 + z1)));
      quadrature +=
          double{light->radiance(wi, nullptr, 0)[3]} * (z0 - z1) * 2 * kPiD / (width * fine);
    }
  }
  const double mean = estimate / n, error = std::sqrt((squares / n - mean * mean) / n);
  CHECK(std::abs(mean - quadrature) < 4 * error + 1e-3 * quadrature);
  // Importance sampling at work: in a cell that touches a lamp with its corner alone the radiance
  // rises to 16 times its mean, and a hundredth of the samples is spread evenly. A uniform density
  // would give the lamp's radiance times 4 pi, some 60 times the integral.
  CHECK(most < 16.0 / 0.99 * 1.001 * quadrature);
}

TEST_CASE("a white image is the constant environment of D65", "[image_environment]") {
  ImageLight image(8, 4, Texels(8 * 4 * 3, 2.0f));
  const auto light = image.make();
  const RgbEmission emission{WavelengthLattice()};
  double mean_white = 0.0;
  for (int p = 0; p < kPhases; ++p) mean_white += double{mean(emission(2, 2, 2, p))} / kPhases;
  CHECK(light->power(3) == Approx(4 * kPiD * kPiD * 9 * mean_white).epsilon(1e-5));
  CHECK(light->pdf({}, {0, 0, 1}, nullptr) == Approx(1 / (4 * kPiD)).epsilon(1e-5));
  CHECK(light->is_environment());
}

TEST_CASE("a picture of 8 bits is decoded from sRGB, and says so", "[image_environment]") {
  // 188 of 255 is linear 0.5029 (IEC 61966-2-1).
  const double decoded = std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4);
  ImageLight linear(16, 8, Texels(16 * 8 * 3, static_cast<float>(decoded)));
  for (const char* ending : {"png", "jpg"}) {
    INFO(ending);
    ImageLight picture(16, 8, Texels(16 * 8 * 3, 188.0f / 255.0f), {}, 1.0, ending);
    const Vec3 up{0.0f, 0.0f, 1.0f};
    CHECK(picture.make()->radiance(up, nullptr, 0)[7] ==
          Approx(linear.make()->radiance(up, nullptr, 0)[7]).epsilon(1e-4));
    REQUIRE(picture.warnings.size() == 1);
    CHECK_THAT(picture.warnings[0],
               Catch::Contains("sky." + std::string(ending)) && Catch::Contains("sRGB"));
  }
  CHECK(linear.warnings.empty());
}

TEST_CASE("an image that is not twice as wide as high is warned of", "[image_environment]") {
  ImageLight square(8, 8, Texels(8 * 8 * 3, 1.0f));
  CHECK(square.make());
  REQUIRE(square.warnings.size() == 1);
  CHECK_THAT(square.warnings[0], Catch::Contains("8 x 8") && Catch::Contains("twice as wide"));
}

TEST_CASE("environment images that cannot be used are refused", "[image_environment]") {
  Texels texels(8 * 4 * 3, 1.0f);
  texels[3 * 10] = std::numeric_limits<float>::infinity();
  CHECK_THROWS_WITH(ImageLight(8, 4, texels).make(),
                    Catch::Contains("sky.exr") && Catch::Contains("texel (2, 1)"));
  CHECK_THROWS_AS(ImageLight(8, 4, Texels(8 * 4 * 3, 0.0f)).make(), InputError);
  CHECK_THROWS_AS(ImageLight(8, 4, Texels(96, 1.0f), {{1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {}}).make(),
                  InputError);
  texels[3 * 10] = -1.0f;
  ImageLight negative(8, 4, texels);
  CHECK(negative.make());
  REQUIRE(negative.warnings.size() == 1);
  CHECK_THAT(negative.warnings[0], Catch::Contains("1 negative"));
}
