// Colours as light: spectra for emitted linear RGB.
#pragma once

#include "spectral/spectrum.h"

namespace karat {

// The spectra of the three Rec.709 primaries (data/rgb/rec709_emission.json): smooth, nowhere
// negative, and together illuminant D65 with the luminance of an equal-energy spectrum of value 1.
// A sum of them with weights r, g, b is a spectrum whose colour is that linear RGB exactly (CIE
// 1931, whole range), and white light is D65.
struct RgbEmission {
  LatticeSpectrum red, green, blue;

  explicit RgbEmission(const WavelengthLattice& lattice);

  SampledSpectrum operator()(float r, float g, float b, int phase) const {
    return red[phase] * r + green[phase] * g + blue[phase] * b;
  }
};

}  // namespace karat
