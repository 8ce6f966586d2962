// Reflection and transmission of a stack of plane layers by the transfer-matrix method.
#pragma once

#include <complex>
#include <span>

namespace karat {

// One layer at one wavelength. Everything is relative to the medium outside: `index` is (n + ik)
// over the outer n, with k >= 0 and not zero, and `thickness` counts wavelengths of light out there
// (thickness in nm times outer n over the vacuum wavelength in nm).
struct FilmLayer {
  std::complex<double> index;
  double thickness = 0.0;
};

// Fractions of the incident power, in [0, 1]. `transmitted` crosses the last interface; what is
// left of 1 was absorbed in the layers.
struct FilmPower {
  double reflected = 1.0;
  double transmitted = 0.0;
};

struct FilmResponse {
  FilmPower s, p;
  double reflected() const { return 0.5 * (s.reflected + p.reflected); }  // unpolarised
};

// `layers` in the order in which light meets them, any number; `substrate` is the relative index of
// the half-space behind them; cos_theta in [0, 1] is of the angle outside. Finite for any thickness
// and absorption. Coherent: thick slabs show every fringe. Abeles, Ann. Phys. (Paris) 12(5), 1950,
// 596-640 and 706-782; Born and Wolf, Principles of Optics, 7th edition, section 1.6.
FilmResponse film_response(std::span<const FilmLayer> layers, std::complex<double> substrate,
                           double cos_theta);

}  // namespace karat
