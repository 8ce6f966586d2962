// Owen-scrambled Sobol pairs, eight per block, for two consecutive vertices at a time.
//
// Every pair of dimensions is the Sobol (0,2)-sequence of Kollig and Keller 2002 with its index
// shuffled and both its values scrambled by nested uniform (Owen) scrambling, so that pairs are
// independent of one another and every one is stratified over a pixel's samples. The scrambling is
// the hash of Laine and Karras 2011 as improved and used for padding by Burley, "Practical
// hash-based Owen scrambling", JCGT 9(4), 2020.
#include "render/sampler.h"

#include <cstddef>

namespace karat {
namespace {

constexpr int kBlockNumbers = 8;
constexpr std::uint32_t kCameraBlock = 0, kFirstVertexBlock = 1;

std::uint32_t reverse_bits(std::uint32_t x) {
  x = (x << 16) | (x >> 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
  x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
  return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
}

// Owen scrambling of a number whose bits are reversed (Burley 2020, listing 2; constants by N.
// Vegdahl 2021, "Building a better LK hash").
std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

// The second Sobol dimension of an index whose bits are reversed: the Pascal matrix modulo 2,
// applied in five steps (digit c sums the index digits whose number contains the bits of c, by
// Lucas).
std::uint32_t sobol_second(std::uint32_t x) {
  x ^= x << 16;
  x ^= (x << 8) & 0xff00ff00u;
  x ^= (x << 4) & 0xf0f0f0f0u;
  x ^= (x << 2) & 0xccccccccu;
  return x ^ ((x << 1) & 0xaaaaaaaau);
}

// A permutation of 32 bits without visible structure (C. Wellons, "Prospecting for hash functions",
// lowbias32).
std::uint32_t hash(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  x ^= x >> 16;
  return x;
}

// In [0, 1), from the upper 24 bits.
float to_unit(std::uint32_t x) {
  return static_cast<float>(static_cast<std::int32_t>(x >> 8)) * 0x1p-24f;
}

}  // namespace

void Sampler::start_pixel(std::uint32_t x, std::uint32_t y) {
  pixel_hash_ = hash(x ^ hash(y ^ hash(seed_)));
}

void Sampler::start_sample(std::uint32_t sample) {
  sample_ = sample;
  first_block_ = ~0u;
}

// One lane per dimension; the loops are plain so that they become vector code.
void Sampler::generate(std::uint32_t block) {
  first_block_ = block;
  constexpr std::uint32_t kCount = 2 * kBlockNumbers;
  const std::uint32_t first_dimension = block * kBlockNumbers;
  alignas(64) std::uint32_t bits[kCount];
  if (kind_ == SamplerKind::kIndependent) {
    const std::uint32_t stream = hash(pixel_hash_ + hash(sample_));
    for (std::uint32_t i = 0; i < kCount; ++i) {
      bits[i] = hash(stream ^ hash(pixel_hash_ ^ (first_dimension + i)));
    }
  } else {
    const std::uint32_t reversed_sample = reverse_bits(sample_);
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const std::uint32_t dimension = first_dimension + i;
      const std::uint32_t pair_seed = hash(pixel_hash_ ^ (0x80000000u | (dimension >> 1)));
      const std::uint32_t own_seed = hash(pixel_hash_ ^ dimension);
      const std::uint32_t first = scramble_reversed(reversed_sample, pair_seed);
      const std::uint32_t second = sobol_second(first);
      const std::uint32_t value = (i & 1u) != 0 ? second : first;
      bits[i] = reverse_bits(scramble_reversed(reverse_bits(value), own_seed));
    }
  }
  for (std::uint32_t i = 0; i < kCount; ++i) numbers_[i] = to_unit(bits[i]);
}

CameraNumbers Sampler::camera() {
  generate(kCameraBlock);
  const float* u = numbers_;
  return {{u[0], u[1]}, {u[2], u[3]}, u[4], u[5]};
}

VertexNumbers Sampler::vertex(int depth) {
  const std::uint32_t block = kFirstVertexBlock + static_cast<std::uint32_t>(depth);
  const std::uint32_t pair_of_blocks = block & ~1u;
  if (pair_of_blocks != first_block_) generate(pair_of_blocks);
  const float* u = numbers_ + (block & 1u) * kBlockNumbers;
  return {{u[0], u[1]}, {u[2], u[3]}, u[4], u[5], u[6]};
}

void BatchSampler::start_block(std::uint32_t x, std::uint32_t y) {
  const std::uint32_t seed = hash(seed_);
  for_whole_batch([&](int i) {
    const auto across = static_cast<std::uint32_t>(i % kBlock);
    const auto down = static_cast<std::uint32_t>(i / kBlock);
    pixel_hash_[i] = hash((x + across) ^ hash((y + down) ^ seed));
  });
}

void BatchSampler::pair(std::uint32_t dimension, BatchFloat& first, BatchFloat& second) const {
  if (kind_ == SamplerKind::kIndependent) {
    const std::uint32_t sample = hash(sample_);
    for_whole_batch([&](int i) {
      const std::uint32_t stream = hash(pixel_hash_[i] + sample);
      first[i] = to_unit(hash(stream ^ hash(pixel_hash_[i] ^ dimension)));
      second[i] = to_unit(hash(stream ^ hash(pixel_hash_[i] ^ (dimension + 1))));
    });
    return;
  }
  const std::uint32_t sample = reverse_bits(sample_);
  for_whole_batch([&](int i) {
    const std::uint32_t pixel = pixel_hash_[i];
    const std::uint32_t a =
        scramble_reversed(sample, hash(pixel ^ (0x80000000u | (dimension >> 1))));
    const std::uint32_t b = sobol_second(a);
    first[i] = to_unit(reverse_bits(scramble_reversed(reverse_bits(a), hash(pixel ^ dimension))));
    second[i] =
        to_unit(reverse_bits(scramble_reversed(reverse_bits(b), hash(pixel ^ (dimension + 1)))));
  });
}

void BatchSampler::camera(BatchCameraNumbers& u) const {
  constexpr std::uint32_t kFirst = kCameraBlock * kBlockNumbers;
  pair(kFirst, u.pixel[0], u.pixel[1]);
  pair(kFirst + 2, u.lens[0], u.lens[1]);
  pair(kFirst + 4, u.phase, u.hero);
}

void BatchSampler::vertex(int depth, BatchVertexNumbers& u) const {
  const std::uint32_t first =
      (kFirstVertexBlock + static_cast<std::uint32_t>(depth)) * kBlockNumbers;
  BatchFloat unused;
  pair(first, u.bsdf[0], u.bsdf[1]);
  pair(first + 2, u.light[0], u.light[1]);
  pair(first + 4, u.lobe, u.light_choice);
  pair(first + 6, u.roulette, unused);
}

}  // namespace karat
