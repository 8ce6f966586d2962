#include "render/film.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "render/integrator.h"
#include "spectral/observer.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr int kFractionBits = 64;

// Larger squares would leave the range of ExactSum; the variance of such a pixel is a lower bound.
constexpr float kMostForSquare = 0x1p29f;
constexpr float kMost = 0x1p60f;

}  // namespace

void ExactSum::add(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const int exponent = static_cast<int>((bits >> 23) & 0xffu);
  if (exponent == 0) return;  // zero and subnormal numbers, below 2^-64 by far
  const Int128 mantissa = static_cast<Int128>((bits & 0x7fffffu) | 0x800000u);
  const int shift = exponent - 150 + kFractionBits;  // value = mantissa * 2^(exponent - 150)
  const Int128 magnitude = shift >= 0    ? mantissa << shift
                           : shift > -24 ? mantissa >> -shift
                                         : Int128{0};
  bits_ += (bits >> 31) != 0 ? -magnitude : magnitude;
}

double ExactSum::value() const { return std::ldexp(static_cast<double>(bits_), -kFractionBits); }

// Each addend is its mantissa, shifted to where it stands in 128 bits: below bit 64, above it, or
// across. A shift by 64 or more bits is none in C++, and the loop must not branch; so the mantissa
// is shifted within bounds, and what is not wanted is masked.
void FourSums::add(const float values[4]) {
  std::uint64_t low[4], high[4];
#pragma omp simd
  for (int i = 0; i < 4; ++i) {
    const std::uint64_t bits = std::bit_cast<std::uint32_t>(values[i]);
    const auto exponent = static_cast<std::int64_t>(bits >> 23);  // the sign is 0
    const std::uint64_t mantissa = (bits & 0x7fffffu) | 0x800000u;
    const std::int64_t shift = exponent - 150 + kFractionBits;  // in [-86, 101]: see kMost
    const auto left = static_cast<std::uint64_t>(std::clamp<std::int64_t>(shift, 0, 63));
    const auto right = static_cast<std::uint64_t>(std::clamp<std::int64_t>(-shift, 0, 63));
    const auto across = static_cast<std::uint64_t>(std::clamp<std::int64_t>(64 - shift, 0, 63));
    const auto above = static_cast<std::uint64_t>(std::clamp<std::int64_t>(shift - 64, 0, 63));
    const std::uint64_t normal = exponent == 0 ? 0 : mantissa;  // subnormals are below 2^-64 by far
    low[i] = shift >= 64 ? 0 : (normal << left) >> right;
    high[i] = (normal >> across) << above;
  }
  add(low, high);
}

void FourSums::add(const FourSums& other) { add(other.low_, other.high_); }

void FourSums::add(const std::uint64_t low[4], const std::uint64_t high[4]) {
#pragma omp simd
  for (int i = 0; i < 4; ++i) {
    const std::uint64_t sum = low_[i] + low[i];
    high_[i] += high[i] + (sum < low[i] ? 1u : 0u);
    low_[i] = sum;
  }
}

double FourSums::value(std::size_t i) const {
  return static_cast<double>(high_[i]) + std::ldexp(static_cast<double>(low_[i]), -kFractionBits);
}

Sensor Sensor::make(const std::string& observer_name, const WavelengthLattice& lattice) {
  const Observer& curves = observer(observer_name);
  const double scale = lattice.range().width_nm() / curves.ybar_integral;
  Sensor sensor;
  const SpectrumPtr bars[3] = {curves.xbar, curves.ybar, curves.zbar};
  for (std::size_t i = 0; i < 3; ++i) {
    sensor.xyz[i] = bin_means(*scaled_spectrum(bars[i], scale), lattice);
  }
  return sensor;
}

Film::Film(Crop crop, FilmChannels channels, const Sensor& sensor)
    : crop_(crop), channels_(channels), sensor_(sensor) {
  const std::size_t count =
      static_cast<std::size_t>(crop.x1 - crop.x0) * static_cast<std::size_t>(crop.y1 - crop.y0);
  pixels_.resize(count);
  if (channels.features) features_.resize(count);
  spectral_.resize(count * static_cast<std::size_t>(channels.spectral_bins));
}

Film::SampleSums Film::sums_of(const SampledSpectrum& radiance,
                               SampledWavelengths wavelengths) const {
  SampleSums sums;
  for (std::size_t i = 0; i < 3; ++i) {
    sums.values[i] = mean_product(radiance, sensor_.xyz[i][wavelengths.phase]);
  }
  const float luminance = std::min(sums.values[1], kMostForSquare);
  sums.values[3] = luminance * luminance;
  return sums;
}

// All sums first: what is stored as single floats and loaded as a vector at once waits long.
void Film::add(int x0, int y0, const CameraBatch& batch) {
  SampleSums sums[kBatch];
  for (int i = 0; i < kBatch; ++i) sums[i] = sums_of(batch.radiance[i], batch.wavelengths[i]);
  for (int i = 0; i < kBatch; ++i) {
    const int x = x0 + i % kBlock, y = y0 + i / kBlock;
    if (x < crop_.x0 || x >= crop_.x1 || y < crop_.y0 || y >= crop_.y1) continue;
    const FirstHit* first_hit =
        batch.first_hits.empty() ? nullptr : &batch.first_hits[static_cast<std::size_t>(i)];
    add(x, y, batch.radiance[i], batch.wavelengths[i], first_hit, sums[i]);
  }
}

void Film::add(int x, int y, const SampledSpectrum& radiance, SampledWavelengths wavelengths,
               const FirstHit* first_hit, const SampleSums& sums) {
  const std::size_t at = index(x, y);
  Pixel& pixel = pixels_[at];
  ++pixel.samples;

  const bool finite = all_below(radiance, kMost), negative = any_negative(radiance);
  if (!finite || negative) {
    pixel.dropped_non_finite += !finite;
    pixel.dropped_negative += finite && negative;
    return;
  }
  pixel.sums.add(sums.values);

  if (channels_.spectral_bins > 0) {
    const auto bins = static_cast<std::size_t>(channels_.spectral_bins);
    // A bin receives the mean of its lattice wavelengths: each is met once in kPhases samples.
    const float weight = static_cast<float>(bins) / kLanes;
    for (int lane = 0; lane < kLanes; ++lane) {
      const auto position = static_cast<std::size_t>(lane * kPhases + wavelengths.phase);
      spectral_[at * bins + position * bins / kLatticeSize].add(radiance[lane] * weight);
    }
  }

  if (channels_.features && first_hit && first_hit->valid) {
    PixelFeatures& features = features_[at];
    ++features.hits;
    for (std::size_t i = 0; i < 3; ++i) {
      features.sums[i].add(mean_product(first_hit->albedo, sensor_.xyz[i][wavelengths.phase]));
    }
    const float others[5] = {first_hit->normal.x, first_hit->normal.y, first_hit->normal.z,
                             first_hit->depth, static_cast<float>(first_hit->shape)};
    for (std::size_t i = 0; i < 5; ++i) features.sums[3 + i].add(others[i]);
  }
}

PixelValue Film::pixel(int x, int y) const {
  const Pixel& pixel = pixels_[index(x, y)];
  PixelValue value;
  value.samples = pixel.samples;
  if (pixel.samples == 0) return value;
  const double n = pixel.samples;
  for (std::size_t i = 0; i < 3; ++i) value.xyz[i] = pixel.sums.value(i) / n;
  if (pixel.samples > 1) {
    const double spread = pixel.sums.value(3) / n - value.xyz[1] * value.xyz[1];
    value.variance_of_mean = std::max(0.0, spread) / (n - 1.0);
  }
  return value;
}

double Film::spectral(int x, int y, int bin) const {
  const std::size_t at = index(x, y);
  const std::uint32_t samples = pixels_[at].samples;
  const auto bins = static_cast<std::size_t>(channels_.spectral_bins);
  return samples == 0 ? 0.0
                      : spectral_[at * bins + static_cast<std::size_t>(bin)].value() / samples;
}

Film::Features Film::features(int x, int y) const {
  const PixelFeatures& pixel = features_[index(x, y)];
  Features features;
  if (pixel.hits == 0) return features;
  const auto average = [&](std::size_t i) { return pixel.sums[i].value() / pixel.hits; };
  for (std::size_t i = 0; i < 3; ++i) {
    features.albedo_xyz[i] = average(i);
    features.normal[i] = average(3 + i);
  }
  features.depth = average(6);
  features.shape = average(7);
  return features;
}

std::uint64_t Film::non_finite() const {
  std::uint64_t count = 0;
  for (const Pixel& pixel : pixels_) count += pixel.dropped_non_finite;
  return count;
}

std::uint64_t Film::negative() const {
  std::uint64_t count = 0;
  for (const Pixel& pixel : pixels_) count += pixel.dropped_negative;
  return count;
}

void Film::merge(const Film& other) {
  for (std::size_t p = 0; p < pixels_.size(); ++p) {
    Pixel& a = pixels_[p];
    const Pixel& b = other.pixels_[p];
    a.sums.add(b.sums);
    a.samples += b.samples;
    a.dropped_non_finite += b.dropped_non_finite;
    a.dropped_negative += b.dropped_negative;
  }
  for (std::size_t p = 0; p < features_.size(); ++p) {
    for (std::size_t i = 0; i < features_[p].sums.size(); ++i) {
      features_[p].sums[i].add(other.features_[p].sums[i]);
    }
    features_[p].hits += other.features_[p].hits;
  }
  for (std::size_t i = 0; i < spectral_.size(); ++i) spectral_[i].add(other.spectral_[i]);
}

// The state is the arrays themselves, pixels first; both ends of a checkpoint are the same program.
std::vector<std::uint8_t> Film::save() const {
  const std::size_t sizes[3] = {pixels_.size() * sizeof(Pixel),
                                features_.size() * sizeof(PixelFeatures),
                                spectral_.size() * sizeof(ExactSum)};
  std::vector<std::uint8_t> state(sizes[0] + sizes[1] + sizes[2]);
  std::memcpy(state.data(), pixels_.data(), sizes[0]);
  if (sizes[1] > 0) std::memcpy(state.data() + sizes[0], features_.data(), sizes[1]);
  if (sizes[2] > 0) std::memcpy(state.data() + sizes[0] + sizes[1], spectral_.data(), sizes[2]);
  return state;
}

void Film::load(const std::vector<std::uint8_t>& state) {
  const std::size_t sizes[3] = {pixels_.size() * sizeof(Pixel),
                                features_.size() * sizeof(PixelFeatures),
                                spectral_.size() * sizeof(ExactSum)};
  const std::size_t expected = sizes[0] + sizes[1] + sizes[2];
  if (state.size() != expected) {
    throw InputError("film state of " + std::to_string(state.size()) + " bytes; this film has " +
                     std::to_string(expected));
  }
  std::memcpy(pixels_.data(), state.data(), sizes[0]);
  if (sizes[1] > 0) std::memcpy(features_.data(), state.data() + sizes[0], sizes[1]);
  if (sizes[2] > 0) std::memcpy(spectral_.data(), state.data() + sizes[0] + sizes[1], sizes[2]);
}

}  // namespace karat
