#include "render/film.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "render/integrator.h"

using namespace karat;

namespace {

const Crop kOnePixel{3, 5, 4, 6};

Film one_pixel_film(FilmChannels channels = {}) {
  return Film(kOnePixel, channels, Sensor::make("cie1931", WavelengthLattice()));
}

}  // namespace

TEST_CASE("an exact sum has the same bits in any order and loses nothing", "[film]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> exponent(-38.0f, 30.0f);
  std::vector<float> values;
  for (int i = 0; i < 1000; ++i) {
    values.push_back((i % 3 == 0 ? -1.0f : 1.0f) * std::exp2(exponent(random)));
  }
  ExactSum forward, backward, halves[2];
  long double literal = 0.0L;
  for (std::size_t i = 0; i < values.size(); ++i) {
    forward.add(values[i]);
    backward.add(values[values.size() - 1 - i]);
    halves[i % 2].add(values[i]);
    literal += static_cast<long double>(values[i]);
  }
  halves[1].add(halves[0]);
  CHECK(forward.value() == backward.value());
  CHECK(forward.value() == halves[1].value());
  // Addends above 2^-40 are exact; the long double sum itself rounds at 2^-64 of its largest term.
  CHECK(forward.value() == Approx(static_cast<double>(literal)).epsilon(1e-15));
}

TEST_CASE("an exact sum reproduces single floats over its whole range", "[film]") {
  for (const float value : {0.0f, 1.0f, -1.0f, 0x1.fffffep59f, 0x1.000002p-40f, 3.14159274f}) {
    ExactSum sum;
    sum.add(value);
    CHECK(sum.value() == double{value});
  }
  ExactSum tiny;
  tiny.add(0x1p-70f);
  CHECK(tiny.value() == 0.0);
}

TEST_CASE("four sums at once are the sums one by one", "[film]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> exponent(-90.0f, 50.0f);
  FourSums four, merged;
  ExactSum one[4];
  for (int n = 0; n < 5000; ++n) {
    float values[4];
    for (std::size_t i = 0; i < 4; ++i) {
      values[i] = n % 7 == 0 ? 0.0f : std::exp2(exponent(random));
      one[i].add(values[i]);
    }
    (n % 2 == 0 ? four : merged).add(values);
  }
  four.add(merged);
  // The 128 bits are rounded to a double in two parts here, at once there.
  for (std::size_t i = 0; i < 4; ++i) CHECK(four.value(i) == Approx(one[i].value()).epsilon(3e-16));

  for (const float value :
       {1.0f, 0x1.fffffep59f, 0x1.fffffep-1f, 0x1.000002p-40f, 0x1.fffffep40f}) {
    FourSums sums;
    const float values[4] = {value, 0.0f, value, 0x1p-70f};
    sums.add(values);
    CHECK((sums.value(0) == double{value} && sums.value(2) == double{value}));
    CHECK((sums.value(1) == 0.0 && sums.value(3) == 0.0));
  }
}

TEST_CASE("radiance of one everywhere has luminance one", "[film]") {
  Film film(kOnePixel, {}, Sensor::make("cie1931", WavelengthLattice({360.0, 830.0})));
  for (int phase = 0; phase < kPhases; ++phase) {
    film.add(3, 5, SampledSpectrum(1.0f), {phase, 0}, nullptr);
  }
  const PixelValue value = film.pixel(3, 5);
  // CIE 1931 sums at 1 nm over 360 to 830 nm: 106.86546949, 106.85691710, 106.89225128. The
  // trapezoidal integral differs from the sum by half the end values, below 1e-5 of it.
  CHECK(value.xyz[0] == Approx(106.86546949 / 106.85691710).epsilon(1e-5));
  CHECK(value.xyz[1] == Approx(1.0).epsilon(1e-5));
  CHECK(value.xyz[2] == Approx(106.89225128 / 106.85691710).epsilon(1e-5));
  CHECK(value.samples == static_cast<std::uint32_t>(kPhases));
}

TEST_CASE("samples that are not finite or negative are dropped and counted", "[film]") {
  Film film = one_pixel_film();
  SampledSpectrum bad(1.0f);
  for (const float value : {std::nanf(""), std::numeric_limits<float>::infinity(), 1e30f}) {
    bad[kLanes / 2] = value;
    film.add(3, 5, bad, {0, 0}, nullptr);
  }
  CHECK(film.non_finite() == 3);
  bad[kLanes / 2] = -1e-3f;
  film.add(3, 5, bad, {0, 0}, nullptr);
  CHECK(film.negative() == 1);
  CHECK(film.non_finite() == 3);
  CHECK(film.pixel(3, 5).xyz[1] == 0.0);
}

TEST_CASE("variance of the mean is that of the samples over their number", "[film]") {
  Film film = one_pixel_film();
  const double unit = [&] {
    Film probe = one_pixel_film();
    probe.add(3, 5, SampledSpectrum(1.0f), {0, 0}, nullptr);
    return probe.pixel(3, 5).xyz[1];
  }();
  for (const float level : {1.0f, 2.0f, 3.0f, 6.0f}) {
    film.add(3, 5, SampledSpectrum(level), {0, 0}, nullptr);
  }
  // Mean 3, squared deviations 4 + 1 + 0 + 9: variance 14/3, of the mean 14/12.
  CHECK(film.pixel(3, 5).variance_of_mean == Approx(14.0 / 12.0 * unit * unit).epsilon(1e-5));
}

TEST_CASE("spectral bins hold the mean radiance of their wavelengths", "[film]") {
  Film film = one_pixel_film({false, 8});
  for (int phase = 0; phase < kPhases; ++phase) {
    film.add(3, 5, for_each_lane([](int lane) { return static_cast<float>(lane); }), {phase, 0},
             nullptr);
  }
  const double lanes_per_bin = kLanes / 8.0;
  for (int bin = 0; bin < 8; ++bin) {
    CHECK(film.spectral(3, 5, bin) == Approx(lanes_per_bin * (bin + 0.5) - 0.5));
  }
}

TEST_CASE("merged films and a saved and loaded film equal one film, to the bit", "[film]") {
  const FilmChannels channels{true, 4};
  Film whole = one_pixel_film(channels), first = one_pixel_film(channels),
       second = one_pixel_film(channels);
  std::mt19937 random(2);
  std::uniform_real_distribution<float> level(0.0f, 1e4f);
  for (int s = 0; s < 100; ++s) {
    const SampledSpectrum radiance = for_each_lane([&](int) { return level(random); });
    FirstHit hit;
    hit.valid = true;
    hit.normal = {0.1f, -0.2f, 0.3f};
    hit.depth = level(random);
    whole.add(3, 5, radiance, {s % kPhases, 0}, &hit);
    (s < 37 ? first : second).add(3, 5, radiance, {s % kPhases, 0}, &hit);
  }
  second.merge(first);
  CHECK(second.save() == whole.save());
  Film loaded = one_pixel_film(channels);
  loaded.load(whole.save());
  CHECK(loaded.save() == whole.save());
  Film other = one_pixel_film({false, 0});
  CHECK_THROWS(other.load(whole.save()));
}
