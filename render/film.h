// The film: sums per pixel that do not depend on the order of what is added.
//
// Every sum is a 128-bit fixed-point number, so tiles, threads, passes, resumed and merged renders
// add up to the same bits.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "render/scene.h"
#include "spectral/spectrum.h"

namespace karat {

// A sum of floats, exact for addends of magnitude 2^-40 to 2^60 (smaller ones lose bits below
// 2^-64).
class ExactSum {
 public:
  void add(float value);
  void add(const ExactSum& other) { bits_ += other.bits_; }
  double value() const;

 private:
  __extension__ typedef __int128 Int128;
  Int128 bits_ = 0;  // in units of 2^-64
};

// Four sums of floats that are not negative, added to at once: the same numbers as four ExactSums,
// as arrays, so that they become vector code.
class FourSums {
 public:
  void add(const float values[4]);
  void add(const FourSums& other);
  double value(std::size_t i) const;

 private:
  void add(const std::uint64_t low[4], const std::uint64_t high[4]);

  alignas(32) std::uint64_t low_[4] = {}, high_[4] = {};
};

// The sensor: colour-matching functions on the lattice, scaled so that sum over lanes of
// radiance * curve, over kLanes, is X, Y, Z with Y = integral(L ybar) / integral(ybar), the
// denominator taken over the observer's whole range.
struct Sensor {
  std::array<LatticeSpectrum, 3> xyz;
  static Sensor make(const std::string& observer, const WavelengthLattice& lattice);
};

// A pixel's plain results.
struct PixelValue {
  std::array<double, 3> xyz{};
  double variance_of_mean = 0.0;  // of Y
  std::uint32_t samples = 0;
};

struct FilmChannels {
  bool features = false;  // albedo (XYZ), normal, depth, shape id
  int spectral_bins = 0;  // equal bins over the lattice's range
};

struct CameraBatch;
struct FirstHit;

class Film {
 public:
  Film(Crop crop, FilmChannels channels, const Sensor& sensor);

  Crop crop() const { return crop_; }
  const FilmChannels& channels() const { return channels_; }

  // One camera sample of pixel (x, y) of the whole image. Different pixels may be added at once.
  // A sample with a non-finite or negative lane is dropped and counted.
  void add(int x, int y, const SampledSpectrum& radiance, SampledWavelengths wavelengths,
           const FirstHit* first_hit) {
    add(x, y, radiance, wavelengths, first_hit, sums_of(radiance, wavelengths));
  }

  // The samples of a batch whose first pixel is (x, y); what lies outside the crop is left out.
  void add(int x, int y, const CameraBatch& batch);

  PixelValue pixel(int x, int y) const;
  double spectral(int x, int y, int bin) const;  // mean radiance in the bin
  struct Features {
    std::array<double, 3> albedo_xyz{}, normal{};
    double depth = 0.0, shape = 0.0;
  };
  Features features(int x, int y) const;

  std::uint64_t non_finite() const;
  std::uint64_t negative() const;

  // The exact state, for checkpoints; load() throws InputError when it belongs to another film.
  std::vector<std::uint8_t> save() const;
  void load(const std::vector<std::uint8_t>& state);

  // Adds the samples of a film of the same crop and channels.
  void merge(const Film& other);

 private:
  struct Pixel {
    FourSums sums;  // of X, Y, Z, and of Y squared
    std::uint32_t samples = 0, dropped_non_finite = 0, dropped_negative = 0;
    std::uint32_t unused[5] = {};  // no padding: the bytes are saved as they are
  };
  struct PixelFeatures {
    std::array<ExactSum, 8> sums;
    std::uint32_t hits = 0, unused[3] = {};
  };

  // X, Y, Z and Y squared.
  struct alignas(16) SampleSums {
    float values[4];
  };
  SampleSums sums_of(const SampledSpectrum& radiance, SampledWavelengths wavelengths) const;
  void add(int x, int y, const SampledSpectrum& radiance, SampledWavelengths wavelengths,
           const FirstHit* first_hit, const SampleSums& sums);

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - crop_.y0) * static_cast<std::size_t>(crop_.x1 - crop_.x0) +
           static_cast<std::size_t>(x - crop_.x0);
  }

  Crop crop_;
  FilmChannels channels_;
  Sensor sensor_;
  std::vector<Pixel> pixels_;
  std::vector<PixelFeatures> features_;
  std::vector<ExactSum> spectral_;
};

}  // namespace karat
