// Spectra for linear sRGB colours: Jakob and Hanika 2019, "A Low-Dimensional Function Space for
// Efficient Spectral Upsampling", with the coefficients solved when the scene is loaded (no table).
#pragma once

#include <array>

#include "spectral/colour.h"
#include "spectral/spectrum.h"

namespace karat {

// A smooth reflectance within [0, 1] whose colour under D65 (1931 observer, 1 nm sums, matrix of
// linear sRGB) is `rgb`, each channel in [0, 1] (otherwise InputError). Known in 360 to 830 nm.
//
// The colour is met within 1e-4 everywhere, faces, edges and corners of the cube included, except
// near white (all channels above 0.995, one above 0.9999), where the error grows to 2.4e-4: the
// white of the D65 table is not quite that of the sRGB matrix, and the perfect reflector has the
// colour (1.0002, 0.9999, 0.9998). (0, 0, 0) and (1, 1, 1) are exactly the constants 0 and 1; a
// grey between them is flat to 0.1 %. Saturated colours are nearly steps or bands, as they must be
// to be that saturated. Outside 360 to 830 nm the end values hold. About 0.3 ms a colour.
SpectrumPtr rgb_reflectance_spectrum(const Rgb& rgb);

// The solution in numbers: reflectance = S(c0 + c1 t + c2 t^2) with t = (wavelength - 595 nm) / 235
// nm and S(x) = 1/2 + x / (2 sqrt(1 + x^2)); `error` is the largest channel difference from the
// request.
struct RgbReflectanceFit {
  std::array<double, 3> coefficients{};
  double error = 0.0;
};
RgbReflectanceFit rgb_reflectance_fit(const Rgb& rgb);

// Emission whose colour under the 1931 observer is `rgb` (any finite values >= 0, otherwise
// InputError) where `illuminant` is D65: max(rgb) * 2 * the reflectance of rgb / (2 max(rgb)) * the
// normalised illuminant. Under another illuminant it is what a filter of that colour lets through,
// so white is the illuminant's white. In the unit of `rgb` (W m^-2 sr^-1 nm^-1 where rgb = 1 is Y =
// 1).
SpectrumPtr rgb_illuminant_spectrum(const Rgb& rgb, SpectrumPtr illuminant);

}  // namespace karat
