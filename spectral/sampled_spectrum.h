// This path's values of a spectral quantity: one float for each of its kLanes wavelengths.
//
// Every operation is a plain loop of constant length over a plain array, which the compiler turns
// into one or two vector instructions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "spectral/wavelengths.h"

namespace karat {

struct alignas(sizeof(float) * kLanes) SampledSpectrum {
  std::array<float, kLanes> lane;

  SampledSpectrum() = default;  // uninitialised, like float
  explicit SampledSpectrum(float value) { lane.fill(value); }

  float operator[](int i) const { return lane[static_cast<std::size_t>(i)]; }
  float& operator[](int i) { return lane[static_cast<std::size_t>(i)]; }

  SampledSpectrum& operator+=(const SampledSpectrum& o) {
    for (int i = 0; i < kLanes; ++i) (*this)[i] += o[i];
    return *this;
  }
  SampledSpectrum& operator-=(const SampledSpectrum& o) {
    for (int i = 0; i < kLanes; ++i) (*this)[i] -= o[i];
    return *this;
  }
  SampledSpectrum& operator*=(const SampledSpectrum& o) {
    for (int i = 0; i < kLanes; ++i) (*this)[i] *= o[i];
    return *this;
  }
  SampledSpectrum& operator/=(const SampledSpectrum& o) {
    for (int i = 0; i < kLanes; ++i) (*this)[i] /= o[i];
    return *this;
  }
  SampledSpectrum& operator*=(float s) {
    for (int i = 0; i < kLanes; ++i) (*this)[i] *= s;
    return *this;
  }
};

inline SampledSpectrum operator+(SampledSpectrum a, const SampledSpectrum& b) { return a += b; }
inline SampledSpectrum operator-(SampledSpectrum a, const SampledSpectrum& b) { return a -= b; }
inline SampledSpectrum operator*(SampledSpectrum a, const SampledSpectrum& b) { return a *= b; }
inline SampledSpectrum operator/(SampledSpectrum a, const SampledSpectrum& b) { return a /= b; }
inline SampledSpectrum operator*(SampledSpectrum a, float s) { return a *= s; }
inline SampledSpectrum operator*(float s, SampledSpectrum a) { return a *= s; }

// `f(lane index)` for every lane.
template <typename F>
inline SampledSpectrum for_each_lane(F&& f) {
  SampledSpectrum r;
  for (int i = 0; i < kLanes; ++i) r[i] = f(i);
  return r;
}

// Sums halve the vector, in one fixed order for every build of a given kLanes.
inline float sum(SampledSpectrum s) {
  for (int width = kLanes / 2; width > 0; width /= 2) {
    for (int i = 0; i < width; ++i) s[i] += s[i + width];
  }
  return s[0];
}
inline float mean(const SampledSpectrum& s) { return sum(s) * (1.0f / kLanes); }

inline float max_lane(SampledSpectrum s) {
  for (int width = kLanes / 2; width > 0; width /= 2) {
    for (int i = 0; i < width; ++i) s[i] = std::max(s[i], s[i + width]);
  }
  return s[0];
}
inline bool is_black(const SampledSpectrum& s) { return !(max_lane(s) > 0.0f); }
inline bool is_finite(const SampledSpectrum& s) {
  bool finite = true;
  for (int i = 0; i < kLanes; ++i) finite &= std::isfinite(s[i]);
  return finite;
}

}  // namespace karat
