// Colour: tristimulus values of spectra, linear sRGB, CIELAB and adaptation to another white.
//
// XYZ is relative, Y = 1 for the white; RGB is linear with Rec.709 primaries and may lie outside
// [0, 1]: nothing here clamps.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "spectral/observer.h"
#include "spectral/spectrum.h"

namespace karat {

using Xyz = std::array<double, 3>;
using Rgb = std::array<double, 3>;
using Lab = std::array<double, 3>;                     // L* in [0, 100], a*, b*
using Matrix3 = std::array<std::array<double, 3>, 3>;  // row major

inline constexpr Matrix3 kIdentity3{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
std::array<double, 3> transformed(const Matrix3& m, const std::array<double, 3>& v);  // m v
Matrix3 product(const Matrix3& a, const Matrix3& b);                                  // a b
Matrix3 inverse(const Matrix3& m);  // of a regular matrix

// --- Spectra to XYZ: sums at whole nanometres, both ends of the range included (ISO/CIE 11664-3).

// sum(S xyzbar) / sum(ybar) over the observer's range, in the unit of S.
Xyz xyz_of_emission(const Spectrum& emission, const Observer& observer);

// sum(R S xyzbar) / sum(S ybar) over the part of `range` that the observer covers: Y = 1 for the
// perfect reflector. Throws InputError where the illuminant has no power there.
using WavelengthFunction = std::function<double(double wavelength_nm)>;
inline constexpr WavelengthRange kWholeObserver{0.0, 1e6};
Xyz xyz_of_reflectance(const WavelengthFunction& reflectance, const Spectrum& illuminant,
                       const Observer& observer, WavelengthRange range = kWholeObserver);
Xyz xyz_of_reflectance(const Spectrum& reflectance, const Spectrum& illuminant,
                       const Observer& observer, WavelengthRange range = kWholeObserver);

// Chromaticity and luminance x, y, Y; black has the chromaticity (0, 0).
std::array<double, 3> xyy_of_xyz(const Xyz& xyz);
Xyz xyz_of_xyy(const std::array<double, 3>& xyy);  // (0, 0, 0) where y is 0

// --- Linear sRGB (Rec.709 primaries, white x = 0.3127, y = 0.3290; IEC 61966-2-1, Rec. ITU-R
// BT.709).

// Chromaticities x, y of a display's or a colour space's primaries and white.
struct Primaries {
  std::array<double, 2> red, green, blue, white;
};
inline constexpr Primaries kRec709{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};

// Linear RGB to XYZ with Y = 1 for RGB (1, 1, 1): SMPTE RP 177.
Matrix3 xyz_of_rgb_matrix(const Primaries& primaries);

// The matrix derived in double precision from the primaries: 3.24096994 -1.53738318 -0.49861076 ...
const Matrix3& linear_srgb_of_xyz_matrix();
const Matrix3& xyz_of_linear_srgb_matrix();
Rgb linear_srgb_of_xyz(const Xyz& xyz);
Xyz xyz_of_linear_srgb(const Rgb& rgb);

// The sRGB transfer function and its inverse (IEC 61966-2-1), odd for negative values.
double srgb_encode(double linear);
double srgb_decode(double encoded);

// --- CIELAB (ISO/CIE 11664-4) against the XYZ of the white.
Lab lab_of_xyz(const Xyz& xyz, const Xyz& white);
Xyz xyz_of_lab(const Lab& lab, const Xyz& white);
// CIE 1976 colour difference: Euclidean distance.
double delta_e_76(const Lab& a, const Lab& b);
// CIEDE2000 with kL = kC = kH = 1 (ISO/CIE 11664-6; Sharma, Wu and Dalal 2005).
double delta_e_2000(const Lab& a, const Lab& b);

// --- Chromatic adaptation.

// Von Kries scaling in the cone space of Bradford (Lam 1985, as in ICC.1) or of CAT16 (Li et al.
// 2017, complete adaptation). Maps `from_white` to `to_white` exactly, and Y of white to Y of
// white.
enum class Adaptation { kBradford, kCat16 };
Matrix3 adaptation_matrix(const Xyz& from_white, const Xyz& to_white, Adaptation method);
Adaptation adaptation_method(const std::string& name);  // "bradford", "cat16", else InputError

// The white, Y = 1, of an illuminant by name, of a blackbody by its temperature in kelvin ("3200";
// a blackbody at every temperature, also where daylight would be usual; 500 to 100000), or of D65
// for "none", which asks for no adaptation. Throws InputError listing what is allowed.
Xyz white_xyz(const std::string& name, const Observer& observer);
Xyz white_xyz(const std::string& name);  // cie1931

// XYZ under `white`, seen by `observer`, to XYZ under D65: the white of the D65 table under the
// 1931 observer, which linear sRGB assumes whatever the observer. The identity for "none", and for
// "D65" under cie1931.
Matrix3 adaptation_to_d65(const std::string& white, const Observer& observer,
                          Adaptation method = Adaptation::kBradford);

}  // namespace karat
