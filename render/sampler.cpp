// Owen-scrambled Sobol pairs, eight numbers for the camera and for every vertex.
//
// Every pair of dimensions is the Sobol (0,2)-sequence of Kollig and Keller 2002 with its index
// shuffled and both its values scrambled by nested uniform (Owen) scrambling, so that pairs are
// independent of one another and every one is stratified over a pixel's samples. The scrambling is
// the hash of Laine and Karras 2011 as improved and used for padding by Burley, "Practical
// hash-based Owen scrambling", JCGT 9(4), 2020.
#include "render/sampler.h"

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

// Two neighbouring dimensions of a sample, of which the first is even. What of the sample's number
// is the same for all dimensions and pixels comes prepared: hash(sample), reverse_bits(sample).
inline void independent_pair(std::uint32_t pixel, std::uint32_t hashed_sample,
                             std::uint32_t dimension, float& first, float& second) {
  const std::uint32_t stream = hash(pixel + hashed_sample);
  first = to_unit(hash(stream ^ hash(pixel ^ dimension)));
  second = to_unit(hash(stream ^ hash(pixel ^ (dimension + 1))));
}
inline void sobol_pair(std::uint32_t pixel, std::uint32_t reversed_sample, std::uint32_t dimension,
                       float& first, float& second) {
  const std::uint32_t a =
      scramble_reversed(reversed_sample, hash(pixel ^ (0x80000000u | (dimension >> 1))));
  const std::uint32_t b = sobol_second(a);
  first = to_unit(reverse_bits(scramble_reversed(reverse_bits(a), hash(pixel ^ dimension))));
  second = to_unit(reverse_bits(scramble_reversed(reverse_bits(b), hash(pixel ^ (dimension + 1)))));
}

std::uint32_t hash_of_pixel(std::uint32_t x, std::uint32_t y, std::uint32_t hashed_seed) {
  return hash(x ^ hash(y ^ hashed_seed));
}

constexpr std::uint32_t first_dimension(int depth) {
  return (kFirstVertexBlock + static_cast<std::uint32_t>(depth)) * kBlockNumbers;
}
constexpr std::uint32_t kCameraDimension = kCameraBlock * kBlockNumbers;

}  // namespace

void Sampler::start(std::uint32_t x, std::uint32_t y, std::uint32_t sample) {
  pixel_hash_ = hash_of_pixel(x, y, hash(seed_));
  sample_ = sample;
}

Vec2 Sampler::pair(std::uint32_t dimension) const {
  Vec2 u;
  if (kind_ == SamplerKind::kIndependent) {
    independent_pair(pixel_hash_, hash(sample_), dimension, u.x, u.y);
  } else {
    sobol_pair(pixel_hash_, reverse_bits(sample_), dimension, u.x, u.y);
  }
  return u;
}

CameraNumbers Sampler::camera() const {
  const Vec2 rest = pair(kCameraDimension + 4);
  return {pair(kCameraDimension), pair(kCameraDimension + 2), rest.x, rest.y};
}

VertexNumbers Sampler::vertex(int depth) const {
  const std::uint32_t first = first_dimension(depth);
  const Vec2 choices = pair(first + 4);
  return {pair(first), pair(first + 2), choices.x, choices.y, pair(first + 6).x};
}

void BatchSampler::start_block(std::uint32_t x, std::uint32_t y) {
  const std::uint32_t seed = hash(seed_);
  for_whole_batch([&](int i) {
    const auto across = static_cast<std::uint32_t>(i % kBlock);
    const auto down = static_cast<std::uint32_t>(i / kBlock);
    pixel_hash_[i] = hash_of_pixel(x + across, y + down, seed);
  });
}

void BatchSampler::pair(std::uint32_t dimension, BatchFloat& first, BatchFloat& second) const {
  if (kind_ == SamplerKind::kIndependent) {
    const std::uint32_t sample = hash(sample_);
    for_whole_batch(
        [&](int i) { independent_pair(pixel_hash_[i], sample, dimension, first[i], second[i]); });
    return;
  }
  const std::uint32_t sample = reverse_bits(sample_);
  for_whole_batch(
      [&](int i) { sobol_pair(pixel_hash_[i], sample, dimension, first[i], second[i]); });
}

void BatchSampler::camera(BatchCameraNumbers& u) const {
  pair(kCameraDimension, u.pixel[0], u.pixel[1]);
  pair(kCameraDimension + 2, u.lens[0], u.lens[1]);
  pair(kCameraDimension + 4, u.phase, u.hero);
}

void BatchSampler::vertex(int depth, BatchVertexNumbers& u) const {
  const std::uint32_t first = first_dimension(depth);
  BatchFloat unused;
  pair(first, u.bsdf[0], u.bsdf[1]);
  pair(first + 2, u.light[0], u.light[1]);
  pair(first + 4, u.lobe, u.light_choice);
  pair(first + 6, u.roulette, unused);
}

}  // namespace karat
