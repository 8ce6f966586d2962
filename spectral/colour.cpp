// Spectra to XYZ, XYZ to linear sRGB.
#include "spectral/colour.h"

#include <algorithm>
#include <cmath>

#include "spectral/support/error.h"

namespace karat {

std::array<double, 3> transformed(const Matrix3& m, const std::array<double, 3>& v) {
  std::array<double, 3> r{};
  for (std::size_t i = 0; i < 3; ++i) r[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return r;
}

Matrix3 product(const Matrix3& a, const Matrix3& b) {
  Matrix3 r{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      r[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    }
  }
  return r;
}

// Adjugate over determinant; cyclic indices carry the cofactors' signs.
Matrix3 inverse(const Matrix3& m) {
  Matrix3 r{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      r[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
    }
  }
  const double determinant = m[0][0] * r[0][0] + m[0][1] * r[1][0] + m[0][2] * r[2][0];
  for (auto& row : r) {
    for (double& x : row) x /= determinant;
  }
  return r;
}

Xyz xyz_of_emission(const Spectrum& emission, const Observer& observer) {
  const NanometreGrid grid = nanometre_grid(observer.range);
  Xyz xyz{};
  for (int i = 0; i < grid.count; ++i) {
    const double nm = grid.first_nm + i, s = emission(nm);
    for (int j = 0; j < 3; ++j) xyz[static_cast<std::size_t>(j)] += s * observer[j](nm);
  }
  for (double& v : xyz) v /= observer.ybar_integral;
  return xyz;
}

Xyz xyz_of_reflectance(const WavelengthFunction& reflectance, const Spectrum& illuminant,
                       const Observer& observer, WavelengthRange range) {
  const NanometreGrid grid = nanometre_grid({std::max(range.min_nm, observer.range.min_nm),
                                             std::min(range.max_nm, observer.range.max_nm)});
  Xyz xyz{};
  double white = 0.0;
  for (int i = 0; i < grid.count; ++i) {
    const double nm = grid.first_nm + i, s = illuminant(nm), r = reflectance(nm);
    white += s * (*observer.ybar)(nm);
    for (int j = 0; j < 3; ++j) xyz[static_cast<std::size_t>(j)] += r * s * observer[j](nm);
  }
  if (!(white > 0.0)) {
    throw InputError(illuminant.description() + " has no power that the observer sees");
  }
  for (double& v : xyz) v /= white;
  return xyz;
}

Xyz xyz_of_reflectance(const Spectrum& reflectance, const Spectrum& illuminant,
                       const Observer& observer, WavelengthRange range) {
  return xyz_of_reflectance([&](double nm) { return reflectance(nm); }, illuminant, observer,
                            range);
}

std::array<double, 3> xyy_of_xyz(const Xyz& xyz) {
  const double sum = xyz[0] + xyz[1] + xyz[2];
  if (sum == 0.0) return {0.0, 0.0, xyz[1]};
  return {xyz[0] / sum, xyz[1] / sum, xyz[1]};
}

Xyz xyz_of_xyy(const std::array<double, 3>& xyy) {
  const auto [x, y, luminance] = xyy;
  if (y == 0.0) return {0.0, 0.0, 0.0};
  return {x * luminance / y, luminance, (1.0 - x - y) * luminance / y};
}

// Columns are the primaries' XYZ, scaled so that (1, 1, 1) is the white.
Matrix3 xyz_of_rgb_matrix(const Primaries& p) {
  const auto at_unit_luminance = [](const std::array<double, 2>& xy) {
    // AP0's green has x + y = 1, its blue a negative y: only y = 0 is out of reach.
    return xyz_of_xyy({xy[0], xy[1], 1.0});
  };
  const Xyz red = at_unit_luminance(p.red), green = at_unit_luminance(p.green),
            blue = at_unit_luminance(p.blue);
  Matrix3 m{};
  for (std::size_t i = 0; i < 3; ++i) m[i] = {red[i], green[i], blue[i]};
  const Rgb scale = transformed(inverse(m), at_unit_luminance(p.white));
  for (auto& row : m) {
    for (std::size_t j = 0; j < 3; ++j) row[j] *= scale[j];
  }
  return m;
}

const Matrix3& xyz_of_linear_srgb_matrix() {
  static const Matrix3 matrix = xyz_of_rgb_matrix(kRec709);
  return matrix;
}

const Matrix3& linear_srgb_of_xyz_matrix() {
  static const Matrix3 matrix = inverse(xyz_of_linear_srgb_matrix());
  return matrix;
}

Rgb linear_srgb_of_xyz(const Xyz& xyz) { return transformed(linear_srgb_of_xyz_matrix(), xyz); }
Xyz xyz_of_linear_srgb(const Rgb& rgb) { return transformed(xyz_of_linear_srgb_matrix(), rgb); }

double srgb_encode(double linear) {
  const double v = std::abs(linear);
  const double encoded = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
  return std::copysign(encoded, linear);
}

double srgb_decode(double encoded) {
  const double v = std::abs(encoded);
  const double linear = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  return std::copysign(linear, encoded);
}

}  // namespace karat
