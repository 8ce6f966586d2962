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

void Film::add(int x, int y, const SampledSpectrum& radiance, SampledWavelengths wavelengths,
               const FirstHit* first_hit) {
  const std::size_t at = index(x, y);
  Pixel& pixel = pixels_[at];
  ++pixel.samples;

  const bool finite = all_below(radiance, kMost), negative = any_negative(radiance);
  if (!finite || negative) {
    pixel.dropped_non_finite += !finite;
    pixel.dropped_negative += finite && negative;
    return;
  }

  float xyz[3];
  for (std::size_t i = 0; i < 3; ++i) {
    xyz[i] = mean_product(radiance, sensor_.xyz[i][wavelengths.phase]);
    pixel.xyz[i].add(xyz[i]);
  }
  const float luminance = std::min(xyz[1], kMostForSquare);
  pixel.y_squared.add(luminance * luminance);

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
  for (std::size_t i = 0; i < 3; ++i) value.xyz[i] = pixel.xyz[i].value() / n;
  if (pixel.samples > 1) {
    const double spread = pixel.y_squared.value() / n - value.xyz[1] * value.xyz[1];
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
    for (std::size_t i = 0; i < 3; ++i) a.xyz[i].add(b.xyz[i]);
    a.y_squared.add(b.y_squared);
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
