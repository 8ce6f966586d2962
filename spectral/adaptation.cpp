// Whites and the adaptation from one to another.
#include <cmath>
#include <cstdlib>

#include "spectral/colour.h"
#include "spectral/illuminant.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr Matrix3 kBradfordCones{
    {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
constexpr Matrix3 kCat16Cones{{{0.401288, 0.650173, -0.051461},
                               {-0.250268, 1.204414, 0.045854},
                               {-0.002079, 0.048952, 0.953127}}};

constexpr double kCoolest = 500.0, kHottest = 100000.0;

// The number that the whole of `text` spells, or nothing.
bool is_number(const std::string& text, double& number) {
  char* end = nullptr;
  number = std::strtod(text.c_str(), &end);
  return end != text.c_str() && *end == '\0' && std::isfinite(number);
}

SpectrumPtr white_spectrum(const std::string& name) {
  if (name == "none") return illuminant("D65");
  double kelvin = 0.0;
  if (!is_number(name, kelvin)) {
    try {
      return illuminant(name);
    } catch (const InputError& e) {
      throw InputError(std::string(e.what()) +
                       " A temperature in kelvin (500 to 100000) and \"none\" are allowed too.");
    }
  }
  if (!(kelvin >= kCoolest && kelvin <= kHottest)) {
    throw InputError("a white's temperature must be from 500 to 100000 K, found " + name);
  }
  return blackbody_spectrum(kelvin);
}

}  // namespace

// Von Kries 1902: the cone responses scale by the ratio of the whites' responses.
Matrix3 adaptation_matrix(const Xyz& from_white, const Xyz& to_white, Adaptation method) {
  const Matrix3& cones = method == Adaptation::kBradford ? kBradfordCones : kCat16Cones;
  const std::array<double, 3> from = transformed(cones, from_white),
                              to = transformed(cones, to_white);
  Matrix3 scaled = cones;
  for (std::size_t i = 0; i < 3; ++i) {
    for (double& x : scaled[i]) x *= to[i] / from[i];
  }
  return product(inverse(cones), scaled);
}

Adaptation adaptation_method(const std::string& name) {
  if (name == "bradford") return Adaptation::kBradford;
  if (name == "cat16") return Adaptation::kCat16;
  throw InputError(unknown_name_message("chromatic adaptation", name, {"bradford", "cat16"}));
}

Xyz white_xyz(const std::string& name, const Observer& observer) {
  const SpectrumPtr spectrum = white_spectrum(name);
  return xyz_of_reflectance([](double) { return 1.0; }, *spectrum, observer);
}

Xyz white_xyz(const std::string& name) { return white_xyz(name, observer("cie1931")); }

Matrix3 adaptation_to_d65(const std::string& white, const Observer& observer, Adaptation method) {
  if (white == "none" || (white == "D65" && observer.name == "cie1931")) return kIdentity3;
  return adaptation_matrix(white_xyz(white, observer), white_xyz("D65"), method);
}

}  // namespace karat
