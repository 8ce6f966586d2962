// The wavelength lattice: which wavelengths a path carries.
//
// A scene's wavelength range is divided into kLanes lanes of kPhases lattice wavelengths each. A
// camera sample picks one phase; its path then carries one wavelength of every lane, evenly spread
// over the range. Whatever is read during rendering is tabulated on the lattice when the scene is
// loaded, phase by phase, so that a read is one aligned load of kLanes floats.
#pragma once

#include <cassert>

// The number of wavelengths a path carries. Other values (4, 8) exist to measure what they cost.
#ifndef KARAT_LANES
#define KARAT_LANES 16
#endif

namespace karat {

inline constexpr int kLanes = KARAT_LANES;
inline constexpr int kLatticeSize = 512;
inline constexpr int kPhases = kLatticeSize / kLanes;

// A closed interval of wavelengths in nm.
struct WavelengthRange {
  double min_nm = 0.0;
  double max_nm = 0.0;

  double width_nm() const { return max_nm - min_nm; }
  bool covers(WavelengthRange other) const {
    return min_nm <= other.min_nm && other.max_nm <= max_nm;
  }
};

inline constexpr WavelengthRange kVisible{380.0, 780.0};

// kLatticeSize equal bins over a range; bin `lane * kPhases + phase` belongs to (lane, phase), and
// its centre is the lattice wavelength.
class WavelengthLattice {
 public:
  explicit WavelengthLattice(WavelengthRange range = kVisible) : range_(range) {}

  WavelengthRange range() const { return range_; }
  double bin_width_nm() const { return range_.width_nm() / kLatticeSize; }
  WavelengthRange bin(int lane, int phase) const {
    const double lower = range_.min_nm + (lane * kPhases + phase) * bin_width_nm();
    return {lower, lower + bin_width_nm()};
  }
  double wavelength_nm(int lane, int phase) const {
    return range_.min_nm + (lane * kPhases + phase + 0.5) * bin_width_nm();
  }

 private:
  WavelengthRange range_;
};

// The wavelengths of one path. `hero` is the lane that directions follow where they depend on
// wavelength; it is chosen uniformly.
struct SampledWavelengths {
  int phase = 0;
  int hero = 0;
};

}  // namespace karat
