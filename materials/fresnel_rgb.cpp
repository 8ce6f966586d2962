#include "materials/fresnel_rgb.h"

namespace karat {

RgbExactFresnel::ChannelIndex RgbExactFresnel::index_at(const LatticeIndex& index,
                                                        const Rgb& wavelengths_nm) {
  const auto at = [](const LatticeSpectrum& spectrum, int place) {
    return double{spectrum[place % kPhases][place / kPhases]};
  };
  const double first = index.lattice.wavelength_nm(0, 0), step = index.lattice.bin_width_nm();
  ChannelIndex result;
  for (std::size_t c = 0; c < 3; ++c) {
    const double x = std::clamp((wavelengths_nm[c] - first) / step, 0.0, kLatticeSize - 1.0);
    const int place = std::min(static_cast<int>(x), kLatticeSize - 2);
    const double t = x - place;
    result.n[c] = at(index.n, place) * (1.0 - t) + at(index.n, place + 1) * t;
    result.k[c] = at(index.k, place) * (1.0 - t) + at(index.k, place + 1) * t;
  }
  return result;
}

}  // namespace karat
