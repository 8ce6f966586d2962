// Reflectance that is known only as values at angles: tabulated once, interpolated in the loop.
#pragma once

#include <functional>

#include "materials/fresnel.h"

namespace karat {

// Reflectance at one lattice wavelength and angle, in [0, 1]; called from several threads.
using ReflectanceOfAngle = std::function<double(int lane, int phase, double cos_theta)>;

struct TabulatedReflectance {
  FresnelTables tables;  // one plane for each of the cosines 0, 1/intervals, ..., 1
  int intervals = 0;
  double error = 0.0;  // the largest half-way between two of them, cos_theta >= kGrazingCosine
};

inline constexpr double kTabulatedError = 1e-4;
// Closer to grazing, where mirrors of many layers have resonances of any sharpness, the error does
// not count: that is the last half degree, a ten-thousandth of the projected hemisphere.
inline constexpr double kGrazingCosine = 0.01;

// Doubles the number of intervals, from 32, until the error is at most kTabulatedError, or there
// are 1024.
TabulatedReflectance tabulated_reflectance(const ReflectanceOfAngle& reflectance);

// Reads such tables: four neighbours, a cubic in the cosine (Lagrange), clamped to [0, 1]. Its own
// prepare() and evaluate() are of the exact Fresnel equations. Not registered: a scene cannot ask
// for it, only a material that has such tables.
const FresnelModel& tabulated_fresnel();

}  // namespace karat
