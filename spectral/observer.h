// Standard colorimetric observers: colour-matching functions from data/cie, one file each.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "spectral/spectrum.h"

namespace karat {

struct Observer {
  std::string name;         // "cie1931"
  std::string description;  // "CIE 1931 2 degree standard colorimetric observer"
  std::string source;       // the standard that defines the table
  // Linear between the 1 nm samples, zero outside `range`.
  SpectrumPtr xbar, ybar, zbar;
  WavelengthRange range;
  // Sum of ybar at 1 nm steps over the whole range, in nm: 106.85691710 for cie1931.
  double ybar_integral = 0.0;

  const Spectrum& operator[](int i) const { return i == 0 ? *xbar : i == 1 ? *ybar : *zbar; }
};

// "cie1931" (2 degree, the default everywhere), "cie1964" (10 degree), "cie2015_2deg",
// "cie2015_10deg". Read on first use (about 1 ms), then shared; safe from any thread. Throws
// InputError listing the names.
const Observer& observer(const std::string& name = "cie1931");

// The names of the files in data/cie, sorted.
std::vector<std::string> observer_names();

// The first whole wavelength and the number of 1 nm steps of sums over `range`: wavelengths
// first, first + 1, ..., first + count - 1 (both ends included, no end-point halving).
struct NanometreGrid {
  int first_nm = 0;
  int count = 0;
};
NanometreGrid nanometre_grid(WavelengthRange range);

}  // namespace karat
