// Born and Wolf, section 1.6.2, with exp(-i omega t). A layer maps the tangential fields at its far
// side to those at its near side,
//   (E)   (  cos d          -i sin(d) / y ) (E')        d = 2 pi q thickness,
//   (H) = ( -i y sin(d)      cos d        ) (H')        q = sqrt(m^2 - sin^2),
// with the admittance y = q for s and y = m^2 / q for p.
//
// Two changes keep it finite. exp(-i d) grows with absorption without bound, so it is taken out of
// every matrix: what remains, with x = exp(2 i d) and |x| <= 1, is (1 + x) / 2 and (x - 1) / 2.
// Reflection is a ratio and does not see the factor; transmission is multiplied by its inverse
// squared, which underflows to the zero it should be. And q vanishes at a critical angle, so that
// sin(d) / q is written with sin(d) / d.
#include "materials/thin_film.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace karat {
namespace {

using Complex = std::complex<double>;

constexpr Complex kI{0.0, 1.0};

// Component of the wave vector along the normal, in units of the outer wave number; it decays or
// travels inwards.
Complex normal_component(Complex index, double sin2) {
  const Complex q = std::sqrt(index * index - sin2);
  return q.imag() < 0.0 ? -q : q;
}

// exp(i d) cos(d), exp(i d) sin(d) / d and |exp(i d)|^2.
struct Waves {
  Complex cosine, sine_over_phase;
  double attenuation;
};

Waves waves(Complex phase) {
  constexpr double kSmall = 1e-4;
  const Complex x = std::exp(2.0 * kI * phase);
  if (std::abs(phase) < kSmall) {
    return {0.5 * (1.0 + x), std::exp(kI * phase) * (1.0 - phase * phase / 6.0), std::abs(x)};
  }
  return {0.5 * (1.0 + x), (x - 1.0) / (2.0 * kI * phase), std::abs(x)};
}

struct Fields {
  Complex e, h;
};

// One polarisation: the fields at the substrate are carried to the outside.
class Traveller {
 public:
  explicit Traveller(Fields substrate)
      : fields_(substrate), flux_((substrate.e * std::conj(substrate.h)).real()) {}

  // `y_phase` is y d and `phase_over_y` is d / y, which stay finite where q does not.
  void cross(const Waves& w, Complex y_phase, Complex phase_over_y) {
    const Complex s = -kI * w.sine_over_phase;
    fields_ = {w.cosine * fields_.e + s * phase_over_y * fields_.h,
               s * y_phase * fields_.e + w.cosine * fields_.h};
    keep_finite();
  }

  // Incident and reflected wave outside, where E = a + b and H = y (a - b). For s y = cos; for p
  // y = 1 / cos and everything is multiplied by cos.
  FilmPower power(double e_factor, double h_factor, double attenuation) const {
    const Complex e = e_factor * fields_.e, h = h_factor * fields_.h;
    const double incident = std::norm(e + h);
    if (!(incident > 0.0)) return {1.0, 0.0};
    const double transmitted = 4.0 * e_factor * h_factor * flux_ / incident * attenuation;
    return {std::clamp(std::norm(e - h) / incident, 0.0, 1.0), std::clamp(transmitted, 0.0, 1.0)};
  }

 private:
  // Fields and the square root of the flux share a scale that nothing depends on; behind hundreds
  // of mirror layers it would overflow.
  void keep_finite() {
    constexpr double kLarge = 1e100;
    const double size = std::max(std::abs(fields_.e), std::abs(fields_.h));
    if (!(size > kLarge)) return;
    fields_ = {fields_.e / size, fields_.h / size};
    flux_ = flux_ / size / size;
  }

  Fields fields_;
  double flux_;
};

}  // namespace

FilmResponse film_response(std::span<const FilmLayer> layers, Complex substrate, double cos_theta) {
  const double sin2 = (1.0 - cos_theta) * (1.0 + cos_theta);
  const Complex q_substrate = normal_component(substrate, sin2);
  Traveller s({1.0, q_substrate}), p({q_substrate, substrate * substrate});
  double attenuation = 1.0;
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
    const Complex q = normal_component(layer->index, sin2);
    const double turn = 2.0 * std::numbers::pi * layer->thickness;
    const Complex phase = turn * q, m2 = layer->index * layer->index;
    const Waves w = waves(phase);
    s.cross(w, q * phase, turn);
    p.cross(w, m2 * turn, q * phase / m2);
    attenuation *= w.attenuation;
  }
  return {s.power(cos_theta, 1.0, attenuation), p.power(1.0, cos_theta, attenuation)};
}

}  // namespace karat
