// Colour channels of renderers without spectra, on the wavelengths of a scene: what a spectrum is
// as linear sRGB under D65, and which spectrum stands for linear sRGB.
#pragma once

#include <array>
#include <memory>

#include "spectral/colour.h"
#include "spectral/spectrum.h"

namespace karat {

class RgbChannels {
 public:
  // Computed once per range (some 10 ms), then shared; safe from any thread. Throws InputError for
  // wavelengths that do not cover 400 to 700 nm, where there is no colour.
  static std::shared_ptr<const RgbChannels> of(const WavelengthLattice& lattice);

  explicit RgbChannels(const WavelengthLattice& lattice);

  // Linear sRGB of a reflectance under D65 for the 1931 observer, in sums over the lattice; a
  // constant is that constant in all three channels. Weights are negative in places: what is
  // within [0, 1] at every wavelength may leave it here.
  Rgb rgb(const LatticeSpectrum& spectrum) const;

  // Spectra of the three primaries: not negative, 1 in sum at every wavelength, and primary i has
  // the colour 1 in channel i and 0 in the others. So a mixture with weights in [0, 1] stays there,
  // and has its weights as its colour under D65. The smoothest that do so: Mallett and Yuksel,
  // "Spectral primary decomposition for rendering with sRGB reflectance", EGSR 2019, equation 6.
  const std::array<LatticeSpectrum, 3>& primaries() const { return primaries_; }

 private:
  std::array<LatticeSpectrum, 3> weights_, primaries_;
};

}  // namespace karat
