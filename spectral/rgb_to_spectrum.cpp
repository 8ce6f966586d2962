#include "spectral/rgb_to_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "spectral/illuminant.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using Vector3 = std::array<double, 3>;

constexpr WavelengthRange kFitted{360.0, 830.0};

std::string text(const Rgb& rgb) {
  return fmt::format("[{:g}, {:g}, {:g}]", rgb[0], rgb[1], rgb[2]);
}

double scaled_wavelength(double nm) { return (nm - 595.0) / 235.0; }

// Jakob and Hanika 2019, equation 5.
double sigmoid(double x) { return 0.5 + 0.5 * x / std::sqrt(1.0 + x * x); }
double sigmoid_slope(double x) {
  const double q = 1.0 / (1.0 + x * x);
  return 0.5 * q * std::sqrt(q);
}
// The argument where the sigmoid is `value`, inside (0, 1).
double sigmoid_inverse(double value) {
  const double v = 2.0 * value - 1.0;
  return v / std::sqrt(1.0 - v * v);
}

double parabola(const Vector3& c, double t) { return c[0] + t * (c[1] + t * c[2]); }

class SigmoidSpectrum final : public Spectrum {
 public:
  SigmoidSpectrum(const Vector3& coefficients, const Rgb& rgb)
      : coefficients_(coefficients), rgb_(rgb) {}
  double operator()(double nm) const override {
    const double inside = std::clamp(nm, kFitted.min_nm, kFitted.max_nm);
    return sigmoid(parabola(coefficients_, scaled_wavelength(inside)));
  }
  WavelengthRange range() const override { return kFitted; }
  std::string description() const override { return "reflectance of RGB " + text(rgb_); }

 private:
  Vector3 coefficients_;
  Rgb rgb_;
};

class ProductSpectrum final : public Spectrum {
 public:
  ProductSpectrum(SpectrumPtr filter, SpectrumPtr illuminant)
      : filter_(std::move(filter)), illuminant_(std::move(illuminant)) {}
  double operator()(double nm) const override { return (*filter_)(nm) * (*illuminant_)(nm); }
  // The filter is smooth: over a lattice bin its mean times that of a spiky lamp is the product's.
  double mean(WavelengthRange interval) const override {
    return filter_->mean(interval) * illuminant_->mean(interval);
  }
  WavelengthRange range() const override {
    const WavelengthRange a = filter_->range(), b = illuminant_->range();
    return {std::max(a.min_nm, b.min_nm), std::min(a.max_nm, b.max_nm)};
  }
  std::string description() const override {
    return filter_->description() + " x " + illuminant_->description();
  }

 private:
  SpectrumPtr filter_, illuminant_;
};

// RGB of a reflectance under D65 as a weighted sum over wavelengths, with the scaled wavelength of
// each weight beside it.
struct RgbWeights {
  std::vector<double> t;
  std::vector<Rgb> weight;
};

const RgbWeights& rgb_weights() {
  static const RgbWeights weights = [] {
    const Observer& o = observer("cie1931");
    const SpectrumPtr d65 = normalised(illuminant("D65"));
    const NanometreGrid grid = nanometre_grid(o.range);
    RgbWeights w;
    for (int i = 0; i < grid.count; ++i) {
      const double nm = grid.first_nm + i, scale = (*d65)(nm) / o.ybar_integral;
      w.t.push_back(scaled_wavelength(nm));
      w.weight.push_back(linear_srgb_of_xyz(
          {scale * (*o.xbar)(nm), scale * (*o.ybar)(nm), scale * (*o.zbar)(nm)}));
    }
    return w;
  }();
  return weights;
}

struct Evaluation {
  Vector3 residual{};  // rgb - target
  Matrix3 jacobian{};  // of the residual by the coefficients
};

Evaluation evaluated(const Vector3& c, const Rgb& target) {
  const RgbWeights& w = rgb_weights();
  Evaluation e;
  for (std::size_t s = 0; s < w.t.size(); ++s) {
    const double t = w.t[s], x = parabola(c, t), value = sigmoid(x), slope = sigmoid_slope(x);
    for (std::size_t i = 0; i < 3; ++i) {
      e.residual[i] += w.weight[s][i] * value;
      const double d = w.weight[s][i] * slope;
      e.jacobian[i][0] += d, e.jacobian[i][1] += d * t, e.jacobian[i][2] += d * t * t;
    }
  }
  for (std::size_t i = 0; i < 3; ++i) e.residual[i] -= target[i];
  return e;
}

double square(const Vector3& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }
double largest(const Vector3& v) {
  return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

// One Levenberg-Marquardt step, (J^T J + damping diag(J^T J)) step = -J^T r (Marquardt 1963).
Vector3 damped_step(const Evaluation& e, double damping) {
  Matrix3 normal{};
  Vector3 gradient{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) normal[i][j] += e.jacobian[k][i] * e.jacobian[k][j];
      gradient[i] -= e.jacobian[j][i] * e.residual[j];
    }
  }
  // The floor keeps the matrix regular where the sigmoid is flat everywhere.
  for (std::size_t i = 0; i < 3; ++i) normal[i][i] += damping * normal[i][i] + 1e-18;
  return transformed(inverse(normal), gradient);
}

// The paper minimises with Gauss-Newton; far from grey that overshoots into the sigmoid's flat
// ends, hence the damping.
Vector3 fitted(Vector3 c, const Rgb& target, int most_steps) {
  constexpr double kExact = 1e-9;
  Evaluation e = evaluated(c, target);
  double damping = 1e-4;
  for (int step = 0; step < most_steps && largest(e.residual) > kExact && damping < 1e12; ++step) {
    const Vector3 d = damped_step(e, damping);
    const Vector3 moved{c[0] + d[0], c[1] + d[1], c[2] + d[2]};
    const Evaluation at_moved = evaluated(moved, target);
    if (square(at_moved.residual) < square(e.residual)) {
      c = moved, e = at_moved, damping = std::max(damping * 0.2, 1e-12);
    } else {
      damping *= 5.0;
    }
  }
  return c;
}

}  // namespace

// Continuation along the line from grey, where the solution is known, to the colour: each stage
// starts from the last one's coefficients.
RgbReflectanceFit rgb_reflectance_fit(const Rgb& rgb) {
  for (const double channel : rgb) {
    if (!(channel >= 0.0 && channel <= 1.0)) {
      throw InputError("RGB " + text(rgb) + " of a reflectance must lie within [0, 1]");
    }
  }
  constexpr int kStages = 12;
  const double grey = std::clamp((rgb[0] + rgb[1] + rgb[2]) / 3.0, 0.02, 0.98);
  Vector3 c{sigmoid_inverse(grey), 0.0, 0.0};
  for (int stage = 1; stage <= kStages; ++stage) {
    // Stages crowd towards the colour, where the coefficients grow fastest.
    const double rest = 1.0 - static_cast<double>(stage) / kStages, way = 1.0 - rest * rest;
    Rgb target;
    for (std::size_t i = 0; i < 3; ++i) target[i] = grey + way * (rgb[i] - grey);
    c = fitted(c, target, stage == kStages ? 200 : 10);
  }
  return {c, largest(evaluated(c, rgb).residual)};
}

SpectrumPtr rgb_reflectance_spectrum(const Rgb& rgb) {
  if (rgb == Rgb{0.0, 0.0, 0.0}) return constant_spectrum(0.0);
  if (rgb == Rgb{1.0, 1.0, 1.0}) return constant_spectrum(1.0);
  return std::make_shared<SigmoidSpectrum>(rgb_reflectance_fit(rgb).coefficients, rgb);
}

// Half the largest channel keeps the reflectance away from 1, where it would be least smooth.
SpectrumPtr rgb_illuminant_spectrum(const Rgb& rgb, SpectrumPtr illuminant) {
  const double brightest = std::max({rgb[0], rgb[1], rgb[2]});
  for (const double channel : rgb) {
    if (!(channel >= 0.0 && std::isfinite(channel))) {
      throw InputError("RGB " + text(rgb) + " of an emission must be finite and not negative");
    }
  }
  if (brightest == 0.0) return constant_spectrum(0.0);
  const double scale = 2.0 * brightest;
  const SpectrumPtr filter =
      rgb_reflectance_spectrum({rgb[0] / scale, rgb[1] / scale, rgb[2] / scale});
  return scaled_spectrum(
      std::make_shared<ProductSpectrum>(filter, normalised(std::move(illuminant))), scale);
}

}  // namespace karat
