// This path's values of a spectral quantity: one float for each of its kLanes wavelengths.
//
// Every operation is a plain loop of constant length over a plain array. The OpenMP pragma
// (compiled with -fopenmp-simd: no run-time library) makes each of them one or two vector
// instructions; without it GCC unrolls some of them to scalar code before it tries to vectorise.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "spectral/wavelengths.h"

namespace karat {

struct alignas(sizeof(float) * kLanes) SampledSpectrum {
  std::array<float, kLanes> lane;

  SampledSpectrum() = default;  // uninitialised, like float
  explicit SampledSpectrum(float value) { lane.fill(value); }

  float operator[](int i) const { return lane[static_cast<std::size_t>(i)]; }
  float& operator[](int i) { return lane[static_cast<std::size_t>(i)]; }

  SampledSpectrum& operator+=(const SampledSpectrum& o) {
#pragma omp simd
    for (int i = 0; i < kLanes; ++i) (*this)[i] += o[i];
    return *this;
  }
  SampledSpectrum& operator-=(const SampledSpectrum& o) {
#pragma omp simd
    for (int i = 0; i < kLanes; ++i) (*this)[i] -= o[i];
    return *this;
  }
  SampledSpectrum& operator*=(const SampledSpectrum& o) {
#pragma omp simd
    for (int i = 0; i < kLanes; ++i) (*this)[i] *= o[i];
    return *this;
  }
  SampledSpectrum& operator/=(const SampledSpectrum& o) {
#pragma omp simd
    for (int i = 0; i < kLanes; ++i) (*this)[i] /= o[i];
    return *this;
  }
  SampledSpectrum& operator*=(float s) {
#pragma omp simd
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
#pragma omp simd
  for (int i = 0; i < kLanes; ++i) r[i] = f(i);
  return r;
}

// Sums add the upper half to the lower one until one is left: four dependent additions for 16 lanes
// where a reduction in order has sixteen.
template <int kCount>
inline float sum_halves(const float* values) {
  if constexpr (kCount == 1) {
    return values[0];
  } else {
    alignas(sizeof(float) * kCount / 2) float half[kCount / 2];
#pragma omp simd
    for (int i = 0; i < kCount / 2; ++i) half[i] = values[i] + values[i + kCount / 2];
    return sum_halves<kCount / 2>(half);
  }
}
inline float sum(const SampledSpectrum& s) { return sum_halves<kLanes>(s.lane.data()); }
inline float mean(const SampledSpectrum& s) { return sum(s) * (1.0f / kLanes); }
inline float mean_product(const SampledSpectrum& a, const SampledSpectrum& b) {
  return mean(a * b);
}

inline float max_lane(const SampledSpectrum& s) {
  float largest = s[0];
#pragma omp simd reduction(max : largest)
  for (int i = 0; i < kLanes; ++i) largest = std::max(largest, s[i]);
  return largest;
}
inline bool is_black(const SampledSpectrum& s) { return !(max_lane(s) > 0.0f); }

// Whether every lane is a number of magnitude below `limit`.
inline bool all_below(const SampledSpectrum& s, float limit) {
  int count = 0;
#pragma omp simd reduction(+ : count)
  for (int i = 0; i < kLanes; ++i) count += std::abs(s[i]) < limit ? 1 : 0;
  return count == kLanes;
}
inline bool any_negative(const SampledSpectrum& s) {
  int count = 0;
#pragma omp simd reduction(+ : count)
  for (int i = 0; i < kLanes; ++i) count += s[i] < 0.0f ? 1 : 0;
  return count != 0;
}
inline bool is_finite(const SampledSpectrum& s) {
  return all_below(s, std::numeric_limits<float>::infinity());
}

}  // namespace karat
