#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "spectral/ocio_view.h"
#include "spectral/support/data_path.h"
#include "spectral/support/error.h"

using namespace karat;

namespace {

std::string own_config() { return data_path("ocio/config.ocio"); }

std::array<float, 3> shown(const OcioView& view, std::array<float, 3> rgb) {
  view.apply(rgb.data(), 1);
  return rgb;
}

// A file of one test, removed afterwards.
struct TemporaryFile {
  std::string path;
  TemporaryFile(const std::string& name, const std::string& text)
      : path(
            (std::filesystem::temp_directory_path() / (std::to_string(getpid()) + name)).string()) {
    std::ofstream(path) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path); }
};

// $OCIO for the length of a test.
struct OcioVariable {
  explicit OcioVariable(const std::string& value) { setenv("OCIO", value.c_str(), 1); }
  ~OcioVariable() { unsetenv("OCIO"); }
};

const char* const kOtherConfig = R"(ocio_profile_version: 2
roles: {aces_interchange: linear in AP0, default: linear in AP0}
file_rules: [!<Rule> {name: Default, colorspace: default}]
displays: {Studio: [!<View> {name: Half, colorspace: half}]}
colorspaces:
  - !<ColorSpace> {name: linear in AP0}
  - !<ColorSpace>
    name: half
    from_scene_reference: !<MatrixTransform> {matrix: [0.5,0,0,0, 0,0.5,0,0, 0,0,0.5,0, 0,0,0,1]}
)";

const char* const kNoRole = R"(ocio_profile_version: 2
roles: {default: a}
file_rules: [!<Rule> {name: Default, colorspace: default}]
displays: {Studio: [!<View> {name: A, colorspace: a}]}
colorspaces: [!<ColorSpace> {name: a}]
)";

}  // namespace

TEST_CASE("The colorimetric view is the sRGB transfer function", "[ocio]") {
  const OcioView view(own_config());
  CHECK(view.display() == "sRGB");
  CHECK(view.view() == "Colorimetric");
  std::mt19937 random(2);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  for (int i = 0; i < 200; ++i) {
    std::array<float, 3> rgb{uniform(random), uniform(random), uniform(random)};
    if (i == 0) rgb = {0.18f, 0.18f, 0.18f};
    if (i == 1) rgb = {1.0f, 0.0f, 0.0f};
    if (i == 2) rgb = {1.5f, 0.2f, 1.2f};  // brighter than the display: still not clamped
    const auto out = shown(view, rgb);
    for (std::size_t c = 0; c < 3; ++c) {
      // Near 0 the curve's slope of 12.92 enlarges the rounding of the matrices.
      CHECK(out[c] == Approx(srgb_encode(rgb[c])).epsilon(0).margin(1e-4));
    }
  }
}

TEST_CASE("Exposure multiplies by powers of two", "[ocio]") {
  const OcioView two_up(own_config(), "", "", 2.0), plain(own_config());
  const auto a = shown(two_up, {0.1f, 0.05f, 0.02f}), b = shown(plain, {0.4f, 0.2f, 0.08f});
  for (std::size_t c = 0; c < 3; ++c) CHECK(a[c] == Approx(b[c]).epsilon(0).margin(1e-5));
  CHECK_THROWS_AS(OcioView(own_config(), "", "", std::nan("")), InputError);
  CHECK_THROWS_AS(OcioView(own_config(), "", "", 101.0), InputError);
}

TEST_CASE("Rec.709 goes to ACES2065-1 and back", "[ocio]") {
  // The matrix that the Academy's tools print for linear Rec.709 to AP0 with Bradford.
  const Matrix3 published{{{0.4396329, 0.3829887, 0.1773784},
                           {0.0897764, 0.8134394, 0.0967842},
                           {0.0175412, 0.1115466, 0.8709122}}};
  const Matrix3& m = aces2065_1_of_linear_srgb_matrix();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      CHECK(m[i][j] == Approx(published[i][j]).epsilon(0).margin(2e-5));
    }
    CHECK(m[i][0] + m[i][1] + m[i][2] == Approx(1.0).epsilon(1e-6));  // white stays white
  }
  // The raw view of a config whose only matrix is 1/2 shows what was handed over.
  const TemporaryFile file("_karat_ocio_half.ocio", kOtherConfig);
  const OcioView half(file.path);
  CHECK(half.display() == "Studio");
  for (std::size_t c = 0; c < 3; ++c) {
    std::array<float, 3> primary{};
    primary[c] = 1.0f;
    const auto aces = shown(half, primary);
    const auto back = transformed(inverse(m), {2.0 * aces[0], 2.0 * aces[1], 2.0 * aces[2]});
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(back[i] == Approx(primary[i]).epsilon(0).margin(1e-6));
    }
    const auto code = shown(OcioView(own_config()), primary);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(srgb_decode(code[i]) == Approx(primary[i]).epsilon(0).margin(1e-4));
    }
  }
}

TEST_CASE("The ACES view differs and compresses highlights", "[ocio]") {
  const OcioView aces(own_config(), "sRGB", "ACES SDR"), plain(own_config());
  const std::array<float, 3> gold{1.0377f, 0.7283f, 0.3645f};
  const auto a = shown(aces, gold), p = shown(plain, gold);
  CHECK(std::abs(a[0] - p[0]) > 0.05f);
  // A saturated highlight may lie a few percent outside the gamut of sRGB; the file clamps there.
  for (const float exposure : {0.001f, 0.18f, 1.0f, 16.0f, 1000.0f}) {
    const auto out = shown(aces, {gold[0] * exposure, gold[1] * exposure, gold[2] * exposure});
    for (const float v : out) {
      CHECK(v >= 0.0f);
      CHECK(v <= 1.05f);
    }
  }
  // ACES 1.0 shows a grey of 0.18 at 10 % of the SDR white.
  const auto grey = shown(aces, {0.18f, 0.18f, 0.18f});
  CHECK(srgb_decode(grey[0]) == Approx(0.10).epsilon(0).margin(0.005));
  CHECK(grey[0] == Approx(grey[2]).epsilon(0).margin(1e-3));
}

TEST_CASE("The other displays show the same colour in their own primaries", "[ocio]") {
  const std::array<float, 3> rgb{0.7f, 0.3f, 0.1f};
  const Xyz xyz = xyz_of_linear_srgb({rgb[0], rgb[1], rgb[2]});
  const Primaries p3{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.3127, 0.3290}};
  const auto in_p3 = transformed(inverse(xyz_of_rgb_matrix(p3)), xyz);
  const auto on_p3 = shown(OcioView(own_config(), "Display P3"), rgb);
  const auto on_video = shown(OcioView(own_config(), "Rec.1886 Rec.709"), rgb);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(on_p3[i] == Approx(srgb_encode(in_p3[i])).epsilon(0).margin(1e-4));
    CHECK(on_video[i] == Approx(std::pow(rgb[i], 1.0 / 2.4)).epsilon(0).margin(1e-4));
  }
  const OcioView view(own_config());
  CHECK(view.displays() == std::vector<std::string>{"sRGB", "Display P3", "Rec.1886 Rec.709"});
  for (const std::string& display : view.displays()) {
    for (const std::string& name : view.views(display)) {
      const OcioView each(own_config(), display, name);
      CHECK(std::isfinite(shown(each, rgb)[0]));
      CHECK(each.description().find(display) != std::string::npos);
      CHECK(each.description().find(name) != std::string::npos);
    }
  }
}

TEST_CASE("A large image is the same as its pixels one by one", "[ocio]") {
  const OcioView view(own_config(), "sRGB", "ACES SDR");
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.0f, 4.0f);
  std::vector<float> image(3 * 10001);
  for (float& v : image) v = uniform(random);
  std::vector<float> whole = image;
  view.apply(whole.data(), 10001);
  for (std::size_t i = 0; i < 10001; i += 97) {
    const auto one = shown(view, {image[3 * i], image[3 * i + 1], image[3 * i + 2]});
    for (std::size_t c = 0; c < 3; ++c) CHECK(whole[3 * i + c] == one[c]);
  }
  view.apply(nullptr, 0);
}

TEST_CASE("The configuration comes from the argument, then $OCIO, then Karat", "[ocio]") {
  const TemporaryFile file("_karat_ocio_order.ocio", kOtherConfig);
  CHECK(OcioView().config_path() == own_config());
  const OcioVariable variable(file.path);
  CHECK(OcioView().config_path() == file.path);
  CHECK(OcioView().display() == "Studio");
  CHECK(OcioView(own_config()).display() == "sRGB");
}

TEST_CASE("Errors of the view name the choices", "[ocio]") {
  CHECK_THROWS_WITH(OcioView(own_config(), "srgb"),
                    Catch::Contains("did you mean \"sRGB\"") && Catch::Contains("Display P3"));
  CHECK_THROWS_WITH(OcioView(own_config(), "sRGB", "colorimetric"),
                    Catch::Contains("Colorimetric") && Catch::Contains("ACES SDR"));
  CHECK_THROWS_AS(OcioView(own_config()).views("none"), InputError);
  CHECK_THROWS_WITH(OcioView("/nonexistent/config.ocio"),
                    Catch::Contains("/nonexistent/config.ocio"));
  const TemporaryFile no_role("_karat_ocio_no_role.ocio", kNoRole);
  CHECK_THROWS_WITH(OcioView(no_role.path), Catch::Contains("aces_interchange"));
  const TemporaryFile garbage("_karat_ocio_garbage.ocio", "{]");
  CHECK_THROWS_AS(OcioView(garbage.path), InputError);
}

TEST_CASE("The colorimetric view is ready in 50 ms", "[ocio]") {
  const auto start = std::chrono::steady_clock::now();
  const OcioView view(own_config());
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  CHECK(seconds.count() < 0.05);
}
