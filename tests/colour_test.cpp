#include "spectral/colour.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "spectral/illuminant.h"
#include "spectral/support/error.h"

using namespace karat;

namespace {

double largest_difference(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

// The public reference figures, or null where they are not installed.
nlohmann::json reference() {
  std::ifstream file(KARAT_TEST_REFERENCE_DIR "/reference/spectral_colour_public.json");
  if (!file) {
    WARN("skipped: no reference/spectral_colour_public.json");
    return nullptr;
  }
  return nlohmann::json::parse(file);
}

Xyz triple(const nlohmann::json& json) { return {json[0], json[1], json[2]}; }

}  // namespace

TEST_CASE("A constant reflectance scales the white", "[colour]") {
  for (const std::string& name : observer_names()) {
    for (const char* light : {"D65", "A", "E", "FL11", "LED-B3"}) {
      const Xyz white = white_xyz(light, observer(name));
      CHECK(white[1] == Approx(1.0).epsilon(1e-14));
      const Xyz grey =
          xyz_of_reflectance(*constant_spectrum(0.18), *illuminant(light), observer(name));
      for (std::size_t i = 0; i < 3; ++i) CHECK(grey[i] == Approx(0.18 * white[i]).epsilon(1e-13));
    }
  }
}

TEST_CASE("A monochromatic band has the chromaticity of the spectral locus", "[colour]") {
  const Observer& o = observer("cie1931");
  const auto band = [](double nm) { return std::abs(nm - 550.0) < 0.5 ? 1.0 : 0.0; };
  const Xyz xyz = xyz_of_reflectance(band, *illuminant("D65"), o);
  const auto xyy = xyy_of_xyz(xyz);
  // CIE 015, chromaticity of 550 nm.
  CHECK(xyy[0] == Approx(0.301604).epsilon(1e-5));
  CHECK(xyy[1] == Approx(0.692308).epsilon(1e-5));
  CHECK(largest_difference(xyz_of_xyy(xyy), xyz) < 1e-15);
}

TEST_CASE("Emission in its own unit", "[colour]") {
  const Observer& o = observer("cie1931");
  const Xyz xyz = xyz_of_emission(*constant_spectrum(3.0), o);
  CHECK(xyz[0] == Approx(3.0 * 106.86546949 / 106.85691710).epsilon(1e-9));
  CHECK(xyz[1] == Approx(3.0).epsilon(1e-14));
  CHECK(xyz[2] == Approx(3.0 * 106.89225128 / 106.85691710).epsilon(1e-9));
}

TEST_CASE("Reflectance needs light that the observer sees", "[colour]") {
  const Observer& o = observer("cie1931");
  CHECK_THROWS_AS(xyz_of_reflectance(*constant_spectrum(1.0), *constant_spectrum(0.0), o),
                  InputError);
  CHECK_THROWS_AS(
      xyz_of_reflectance(*constant_spectrum(1.0), *illuminant("D65"), o, {900.0, 1000.0}),
      InputError);
}

TEST_CASE("Whites, matrix and adaptation agree with the reference figures", "[colour]") {
  const nlohmann::json r = reference();
  if (r.is_null()) return;
  const Xyz d65 = white_xyz("D65"), e = white_xyz("E");
  CHECK(largest_difference(d65, triple(r["white_D65"])) < 1e-12);
  CHECK(largest_difference(e, triple(r["white_E"])) < 1e-12);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(largest_difference(linear_srgb_of_xyz_matrix()[i], triple(r["XYZ_to_linear_sRGB"][i])) <
          1e-12);
  }
  const Matrix3 to_d65 = adaptation_to_d65("E", observer("cie1931"));
  for (const auto& m : r["materials"]) {
    INFO(m["material"]);
    const Xyz xyz = triple(m["D65"]["XYZ"]), under_e = triple(m["E"]["XYZ"]);
    CHECK(largest_difference(linear_srgb_of_xyz(xyz),
                             triple(m["D65"]["linear_sRGB_no_adaptation"])) < 1e-12);
    CHECK(largest_difference(lab_of_xyz(xyz, d65), triple(m["D65"]["Lab"])) < 1e-9);
    CHECK(largest_difference(lab_of_xyz(under_e, e), triple(m["E"]["Lab"])) < 1e-9);
    CHECK(largest_difference(linear_srgb_of_xyz(transformed(to_d65, under_e)),
                             triple(m["E"]["linear_sRGB_bradford_to_D65"])) < 1e-9);
  }
}

TEST_CASE("Linear sRGB", "[colour]") {
  const Matrix3 printed{{{3.24096994, -1.53738318, -.49861076},
                         {-.96924364, 1.8759675, .04155506},
                         {.05563008, -.20397696, 1.05697151}}};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(largest_difference(linear_srgb_of_xyz_matrix()[i], printed[i]) < 5e-9);
  }
  const Rgb gold{1.0377, 0.7283, -0.3645};  // outside [0, 1]: nothing may clamp
  CHECK(largest_difference(linear_srgb_of_xyz(xyz_of_linear_srgb(gold)), gold) < 1e-14);
  CHECK(largest_difference(xyz_of_linear_srgb({1, 1, 1}), xyz_of_xyy({.3127, .3290, 1.0})) < 1e-15);
}

TEST_CASE("sRGB transfer function", "[colour]") {
  CHECK(srgb_encode(0.0) == 0.0);
  CHECK(srgb_encode(1.0) == Approx(1.0).epsilon(1e-15));
  CHECK(srgb_encode(0.18) == Approx(0.46135612950044164).epsilon(1e-12));
  // The standard's own 0.0031308 leaves a step of less than 1e-7 between line and curve.
  CHECK(srgb_encode(0.0031308) == Approx(srgb_encode(0.0031308 + 1e-12)).epsilon(0).margin(1e-7));
  for (double v = -2.0; v <= 2.0; v += 0.01) {
    CHECK(srgb_decode(srgb_encode(v)) == Approx(v).epsilon(0).margin(1e-7));
    CHECK(srgb_encode(-v) == -srgb_encode(v));
  }
}

TEST_CASE("CIELAB there and back", "[colour]") {
  const Xyz white = white_xyz("D65");
  CHECK(largest_difference(lab_of_xyz(white, white), {100, 0, 0}) < 1e-12);
  CHECK(largest_difference(lab_of_xyz({0, 0, 0}, white), {0, 0, 0}) < 1e-12);
  // Grey of Y = 0.18: L* = 116 * 0.18^(1/3) - 16.
  CHECK(lab_of_xyz({0.18 * white[0], 0.18, 0.18 * white[2]}, white)[0] ==
        Approx(116.0 * std::cbrt(0.18) - 16.0).epsilon(1e-14));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.2);
  for (int i = 0; i < 1000; ++i) {
    Xyz xyz{uniform(random), uniform(random), uniform(random)};
    if (i % 2) xyz = {xyz[0] * 0.01, xyz[1] * 0.01, xyz[2] * 0.01};  // the linear part
    CHECK(largest_difference(xyz_of_lab(lab_of_xyz(xyz, white), white), xyz) < 1e-13);
  }
}

// Table 1 of Sharma, Wu and Dalal 2005: chosen so that each branch and discontinuity of the formula
// decides at least one pair.
TEST_CASE("CIEDE2000 of the published test pairs", "[colour]") {
  struct Pair {
    Lab a, b;
    double delta_e;
  };
  const Pair pairs[] = {{{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
                        {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
                        {{50, 2.8361, -74.0200}, {50, 0, -82.7485}, 3.4412},
                        {{50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1.0000},
                        {{50, -1.1848, -84.8006}, {50, 0, -82.7485}, 1.0000},
                        {{50, -0.9009, -85.5211}, {50, 0, -82.7485}, 1.0000},
                        {{50, 0, 0}, {50, -1, 2}, 2.3669},
                        {{50, -1, 2}, {50, 0, 0}, 2.3669},
                        {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0009}, 7.1792},
                        {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0010}, 7.1792},
                        {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0011}, 7.2195},
                        {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0012}, 7.2195},
                        {{50, -0.0010, 2.4900}, {50, 0.0009, -2.4900}, 4.8045},
                        {{50, -0.0010, 2.4900}, {50, 0.0010, -2.4900}, 4.8045},
                        {{50, -0.0010, 2.4900}, {50, 0.0011, -2.4900}, 4.7461},
                        {{50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
                        {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
                        {{50, 2.5, 0}, {61, -5, 29}, 22.8977},
                        {{50, 2.5, 0}, {56, -27, -3}, 31.9030},
                        {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
                        {{50, 2.5, 0}, {50, 3.1736, 0.5854}, 1.0000},
                        {{50, 2.5, 0}, {50, 3.2972, 0}, 1.0000},
                        {{50, 2.5, 0}, {50, 1.8634, 0.5757}, 1.0000},
                        {{50, 2.5, 0}, {50, 3.2592, 0.3350}, 1.0000},
                        {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
                        {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
                        {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
                        {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
                        {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
                        {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
                        {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
                        {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
                        {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
                        {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082}};
  CHECK(std::size(pairs) == 34);
  for (const Pair& p : pairs) {
    INFO("pair " << (&p - pairs) + 1);
    CHECK(delta_e_2000(p.a, p.b) == Approx(p.delta_e).epsilon(0).margin(5e-5));
    CHECK(delta_e_2000(p.b, p.a) == Approx(p.delta_e).epsilon(0).margin(5e-5));
    CHECK(delta_e_2000(p.a, p.a) == 0.0);
  }
  CHECK(delta_e_76({50, 0, 0}, {53, 4, 0}) == Approx(5.0));
}

TEST_CASE("Adaptation maps white to white and back", "[colour]") {
  const Observer& o = observer("cie1931");
  for (const Adaptation method : {Adaptation::kBradford, Adaptation::kCat16}) {
    for (const char* name : {"A", "E", "FL11", "LED-B3", "2700", "3200", "12000"}) {
      const Xyz from = white_xyz(name), to = white_xyz("D65");
      const Matrix3 there = adaptation_matrix(from, to, method);
      const Matrix3 back = adaptation_matrix(to, from, method);
      CHECK(largest_difference(transformed(there, from), to) < 1e-13);
      CHECK(largest_difference(
                linear_srgb_of_xyz(transformed(adaptation_to_d65(name, o, method), from)),
                linear_srgb_of_xyz(to)) < 1e-12);
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(largest_difference(product(back, there)[i], kIdentity3[i]) < 1e-12);
      }
    }
  }
  // ICC.1: the Bradford matrix from D65 to the profile connection space's D50.
  const Matrix3 icc{
      {{1.0478, 0.0229, -0.0501}, {0.0295, 0.9905, -0.0171}, {-0.0092, 0.0150, 0.7521}}};
  const Matrix3 bradford =
      adaptation_matrix(white_xyz("D65"), white_xyz("D50"), Adaptation::kBradford);
  for (std::size_t i = 0; i < 3; ++i) CHECK(largest_difference(bradford[i], icc[i]) < 2e-4);
  CHECK(adaptation_to_d65("D65", o) == kIdentity3);
  CHECK(adaptation_to_d65("none", observer("cie1964")) == kIdentity3);
  CHECK(adaptation_method("cat16") == Adaptation::kCat16);
  CHECK_THROWS_WITH(adaptation_method("bradfort"), Catch::Contains("bradford"));
}

// Doubling one cone response alone shows the cone matrix: the adaptation is the identity plus the
// outer product of a column of its inverse and the row of the matrix. Inverses as their papers
// print them.
TEST_CASE("Adaptations use the published cone spaces", "[colour]") {
  struct ConeSpace {
    Adaptation method;
    Matrix3 cones, inverse;
  };
  const ConeSpace spaces[] = {
      {Adaptation::kBradford,
       {{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}},
       {{{0.9869929, -0.1470543, 0.1599627},
         {0.4323053, 0.5183603, 0.0492912},
         {-0.0085287, 0.0400428, 0.9684867}}}},
      {Adaptation::kCat16,
       {{{0.401288, 0.650173, -0.051461},
         {-0.250268, 1.204414, 0.045854},
         {-0.002079, 0.048952, 0.953127}}},
       {{{1.86206786, -1.01125463, 0.14918677},
         {0.38752654, 0.62144744, -0.00897398},
         {-0.01584150, -0.03412294, 1.04996444}}}}};
  for (const ConeSpace& space : spaces) {
    const Xyz from = transformed(space.inverse, {1, 1, 1});
    for (std::size_t cone = 0; cone < 3; ++cone) {
      Xyz to = from;
      for (std::size_t i = 0; i < 3; ++i) to[i] += space.inverse[i][cone];
      const Matrix3 m = adaptation_matrix(from, to, space.method);
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          const double expected = kIdentity3[i][j] + space.inverse[i][cone] * space.cones[cone][j];
          CHECK(m[i][j] == Approx(expected).epsilon(0).margin(1e-6));
        }
      }
    }
  }
}

TEST_CASE("Another observer's white becomes the white of linear sRGB", "[colour]") {
  const Observer& ten_degrees = observer("cie1964");
  const Xyz white = white_xyz("D65", ten_degrees);
  const Xyz adapted = transformed(adaptation_to_d65("D65", ten_degrees), white);
  CHECK(largest_difference(adapted, white_xyz("D65")) < 1e-13);
}

TEST_CASE("Whites by temperature are blackbodies", "[colour]") {
  // CIE 015: illuminant A at the temperature it has on today's scale.
  const Xyz a = white_xyz("A"), planck = white_xyz("2855.4956");
  CHECK(largest_difference(a, planck) < 1e-7);
  // The Planckian locus at 6500 K: x = .3135, y = .3237 (Wyszecki and Stiles 1982).
  const auto xyy = xyy_of_xyz(white_xyz("6500"));
  CHECK(xyy[0] == Approx(.3135).epsilon(0).margin(1e-4));
  CHECK(xyy[1] == Approx(.3237).epsilon(0).margin(1e-4));
  CHECK_THROWS_WITH(white_xyz("D66"), Catch::Contains("D65") && Catch::Contains("kelvin"));
  for (const char* name : {"0", "-5", "499", "1e9", "nan", "inf", "", "6500 K"}) {
    INFO(name);
    CHECK_THROWS_AS(white_xyz(name), InputError);
  }
}
