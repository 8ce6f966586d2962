// CIELAB and its colour differences.
#include <cmath>
#include <numbers>

#include "spectral/colour.h"

namespace karat {
namespace {

constexpr double kDelta = 6.0 / 29.0;  // ISO/CIE 11664-4, where the cube root becomes a line
constexpr double kDegree = std::numbers::pi / 180.0;

double compressed(double t) {
  return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
}

double expanded(double f) {
  return f > kDelta ? f * f * f : 3.0 * kDelta * kDelta * (f - 4.0 / 29.0);
}

// Hue angle in degrees, [0, 360); 0 for grey.
double hue_deg(double a, double b) {
  if (a == 0.0 && b == 0.0) return 0.0;
  const double h = std::atan2(b, a) / kDegree;
  return h < 0.0 ? h + 360.0 : h;
}

double pow7(double x) { return x * x * x * x * x * x * x; }

// sqrt(C^7 / (C^7 + 25^7)), in the equations for G and R_C.
double chroma_weight(double c) { return std::sqrt(pow7(c) / (pow7(c) + pow7(25.0))); }

struct HueDifference {
  double delta_deg, mean_deg;
};

// Sharma, Wu and Dalal 2005, equations 10 and 14: the shorter way round, and the mean along it.
HueDifference hue_difference(double h1, double h2, bool grey) {
  if (grey) return {0.0, h1 + h2};
  const double d = h2 - h1, sum = h1 + h2;
  if (std::abs(d) <= 180.0) return {d, 0.5 * sum};
  return {d > 180.0 ? d - 360.0 : d + 360.0,
          sum < 360.0 ? 0.5 * (sum + 360.0) : 0.5 * (sum - 360.0)};
}

}  // namespace

Lab lab_of_xyz(const Xyz& xyz, const Xyz& white) {
  const double fx = compressed(xyz[0] / white[0]), fy = compressed(xyz[1] / white[1]),
               fz = compressed(xyz[2] / white[2]);
  return {116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

Xyz xyz_of_lab(const Lab& lab, const Xyz& white) {
  const double fy = (lab[0] + 16.0) / 116.0;
  return {white[0] * expanded(fy + lab[1] / 500.0), white[1] * expanded(fy),
          white[2] * expanded(fy - lab[2] / 200.0)};
}

double delta_e_76(const Lab& a, const Lab& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Sharma, Wu and Dalal 2005, "The CIEDE2000 color-difference formula", equations 2 to 22.
double delta_e_2000(const Lab& lab1, const Lab& lab2) {
  const double c_mean = 0.5 * (std::hypot(lab1[1], lab1[2]) + std::hypot(lab2[1], lab2[2]));
  const double g = 0.5 * (1.0 - chroma_weight(c_mean));
  const double a1 = (1.0 + g) * lab1[1], a2 = (1.0 + g) * lab2[1];
  const double c1 = std::hypot(a1, lab1[2]), c2 = std::hypot(a2, lab2[2]);
  const auto [dh, h] = hue_difference(hue_deg(a1, lab1[2]), hue_deg(a2, lab2[2]), c1 * c2 == 0.0);

  const double delta_l = lab2[0] - lab1[0], delta_c = c2 - c1;
  const double delta_h = 2.0 * std::sqrt(c1 * c2) * std::sin(0.5 * dh * kDegree);
  const double l = 0.5 * (lab1[0] + lab2[0]), c = 0.5 * (c1 + c2);

  const double t = 1.0 - 0.17 * std::cos((h - 30.0) * kDegree) +
                   0.24 * std::cos(2.0 * h * kDegree) + 0.32 * std::cos((3.0 * h + 6.0) * kDegree) -
                   0.20 * std::cos((4.0 * h - 63.0) * kDegree);
  const double hue_band = (h - 275.0) / 25.0;
  const double rotation =
      -std::sin(60.0 * std::exp(-hue_band * hue_band) * kDegree) * 2.0 * chroma_weight(c);
  const double l50 = (l - 50.0) * (l - 50.0);
  const double tl = delta_l / (1.0 + 0.015 * l50 / std::sqrt(20.0 + l50));
  const double tc = delta_c / (1.0 + 0.045 * c);
  const double th = delta_h / (1.0 + 0.015 * c * t);
  return std::sqrt(tl * tl + tc * tc + th * th + rotation * tc * th);
}

}  // namespace karat
