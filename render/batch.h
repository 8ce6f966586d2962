// Sixteen paths that are traced together: the pixels of a small block of the image, one sample
// each.
//
// What every path of a batch computes alike (directions, frames, random numbers) is done for all of
// them in one loop over arrays, which becomes vector code, whether a path is still alive or not:
// numbers of ended paths are computed and ignored. A batch holds the same pixels in every render of
// a scene, so that an image does not depend on how its samples were divided into passes.
#pragma once

#include <bit>
#include <cstdint>

#include "materials/vector.h"

namespace karat {

inline constexpr int kBlock = 4;  // pixels a side; blocks start at multiples of it
inline constexpr int kBatch = kBlock * kBlock;

// One bit per path.
using BatchMask = std::uint32_t;
inline constexpr BatchMask kWholeBatch = (BatchMask{1} << kBatch) - 1;

// `f(i)` for every path in the mask, in ascending order.
template <typename F>
inline void for_each(BatchMask mask, F&& f) {
  for (; mask != 0; mask &= mask - 1) f(std::countr_zero(mask));
}

// `f(i)` for every path, alive or not, as one loop of vector code. The body is a function of its
// own because GCC keeps variables of an "omp simd" loop whose address is taken in memory, and then
// does not vectorise it.
template <typename F>
inline void for_whole_batch(F&& f) {
#pragma omp simd
  for (int i = 0; i < kBatch; ++i) f(i);
}

// The paths in `mask` for which `f(i)` holds.
template <typename F>
inline BatchMask those(BatchMask mask, F&& f) {
  BatchMask result = 0;
  for_each(mask, [&](int i) { result |= BatchMask{f(i)} << i; });
  return result;
}

struct alignas(4 * kBatch) BatchFloat {
  float values[kBatch] = {};
  float operator[](int i) const { return values[i]; }
  float& operator[](int i) { return values[i]; }
};

struct BatchVec3 {
  BatchFloat x, y, z;
  Vec3 operator[](int i) const { return {x[i], y[i], z[i]}; }
  void set(int i, const Vec3& v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
};

struct BatchRay {
  BatchVec3 origin, direction;
};

}  // namespace karat
