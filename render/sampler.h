// Random numbers addressed by (pixel, sample, dimension): the same for any order of rendering.
//
// A vertex's numbers are made together, in lanes: eight dimensions of Owen-scrambled Sobol cost
// about as much as one.
#pragma once

#include <cstdint>

#include "materials/vector.h"
#include "render/batch.h"

namespace karat {

enum class SamplerKind { kSobol, kIndependent };

struct CameraNumbers {
  Vec2 pixel, lens;
  float phase, hero;
};

struct VertexNumbers {
  Vec2 bsdf;
  Vec2 light;
  float lobe, light_choice, roulette;
};

class Sampler {
 public:
  Sampler(SamplerKind kind, std::uint32_t seed) : kind_(kind), seed_(seed) {}

  // The numbers that follow belong to this sample of this pixel.
  void start(std::uint32_t x, std::uint32_t y, std::uint32_t sample);

  CameraNumbers camera() const;
  VertexNumbers vertex(int depth) const;

 private:
  friend class BatchSampler;
  Sampler(SamplerKind kind, std::uint32_t seed, std::uint32_t pixel_hash, std::uint32_t sample)
      : kind_(kind), seed_(seed), pixel_hash_(pixel_hash), sample_(sample) {}

  // Two neighbouring dimensions, of which the first is even.
  Vec2 pair(std::uint32_t dimension) const;

  SamplerKind kind_;
  std::uint32_t seed_;
  std::uint32_t pixel_hash_ = 0, sample_ = 0;
};

// The same numbers for the paths of a batch, all of which are at the same sample of their pixels.
struct BatchCameraNumbers {
  BatchFloat pixel[2], lens[2], phase, hero;
};
struct BatchVertexNumbers {
  BatchFloat bsdf[2], light[2], lobe, light_choice, roulette;
};

class BatchSampler {
 public:
  BatchSampler(SamplerKind kind, std::uint32_t seed) : kind_(kind), seed_(seed) {}

  // Path i belongs to pixel (x + i mod kBlock, y + i / kBlock).
  void start_block(std::uint32_t x, std::uint32_t y);
  void start_sample(std::uint32_t sample) { sample_ = sample; }

  void camera(BatchCameraNumbers& u) const;
  void vertex(int depth, BatchVertexNumbers& u) const;

  // For integrators that take one path after the other.
  Sampler path(int i) const { return {kind_, seed_, pixel_hash_[i], sample_}; }

 private:
  // Two neighbouring dimensions, of which the first is even.
  void pair(std::uint32_t dimension, BatchFloat& first, BatchFloat& second) const;

  SamplerKind kind_;
  std::uint32_t seed_, sample_ = 0;
  alignas(64) std::uint32_t pixel_hash_[kBatch] = {};
};

}  // namespace karat
