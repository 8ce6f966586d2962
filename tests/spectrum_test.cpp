#include "spectral/spectrum.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "spectral/observer.h"

using namespace karat;

namespace {

// The mean by a million midpoints: slow, literal, independent of segments and quadrature nodes.
double literal_mean(const Spectrum& s, WavelengthRange interval, int points = 1000000) {
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    sum += s(interval.min_nm + (i + 0.5) / points * interval.width_nm());
  }
  return sum / points;
}

SpectrumPtr random_table(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(0.05, 9.0), value(0.0, 1.0);
  std::vector<double> nm, values;
  for (double l = 400.0; l < 700.0; l += step(random))
    nm.push_back(l), values.push_back(value(random));
  return table_spectrum(nm, values, "random");
}

double lattice_integral(const LatticeSpectrum& s, const WavelengthLattice& lattice) {
  double sum = 0.0;
  for (int phase = 0; phase < kPhases; ++phase) {
    for (int lane = 0; lane < kLanes; ++lane) sum += s[phase][lane];
  }
  return sum * lattice.bin_width_nm();
}

}  // namespace

TEST_CASE("A table is linear between samples and holds its ends", "[spectrum]") {
  const SpectrumPtr s = table_spectrum({400, 500, 600}, {1, 3, 2}, "three");
  CHECK((*s)(400) == 1.0);
  CHECK((*s)(450) == 2.0);
  CHECK((*s)(500) == 3.0);
  CHECK((*s)(575) == 2.25);
  CHECK((*s)(300) == 1.0);
  CHECK((*s)(900) == 2.0);
  CHECK(s->range().min_nm == 400.0);
  CHECK(s->range().max_nm == 600.0);
  CHECK(s->description() == "three");
}

TEST_CASE("Means of a table are exact", "[spectrum]") {
  const SpectrumPtr s = table_spectrum({400, 500, 600}, {1, 3, 2}, "three");
  CHECK(s->mean({400, 600}) == Approx((2.0 + 2.5) / 2.0).epsilon(1e-15));
  CHECK(s->mean({450, 550}) == Approx((2.5 + 2.75) / 2.0).epsilon(1e-15));
  CHECK(s->mean({410, 420}) == Approx(1.3).epsilon(1e-15));  // within one segment
  CHECK(s->mean({300, 500}) == Approx(1.5).epsilon(1e-15));  // held end, then the ramp
  CHECK(s->mean({700, 800}) == Approx(2.0).epsilon(1e-15));  // outside
  CHECK(s->mean({475, 475}) == Approx(2.5).epsilon(1e-15));  // a point
  for (unsigned seed = 0; seed < 3; ++seed) {
    const SpectrumPtr table = random_table(seed);
    for (const WavelengthRange interval :
         {WavelengthRange{380, 780}, {433.3, 433.9}, {500.1, 540.7}}) {
      CHECK(table->mean(interval) == Approx(literal_mean(*table, interval)).epsilon(1e-8));
    }
  }
}

TEST_CASE("Means split: an interval's mean is that of its parts", "[spectrum]") {
  const SpectrumPtr table = random_table(7);
  const double whole = table->mean({395.0, 705.0}) * 310.0;
  double parts = 0.0;
  for (int i = 0; i < 310; ++i) parts += table->mean({395.0 + i, 396.0 + i});
  CHECK(parts == Approx(whole).epsilon(1e-12));
}

TEST_CASE("Lattice means integrate what a finer table would", "[spectrum]") {
  for (const WavelengthRange range :
       {kVisible, WavelengthRange{360, 830}, WavelengthRange{600, 610}}) {
    const WavelengthLattice lattice(range);
    for (const SpectrumPtr& s :
         {random_table(11), blackbody_spectrum(2700),
          scaled_spectrum(blackbody_spectrum(9000), 0.3), constant_spectrum(2.5)}) {
      INFO(s->description() << " over " << range.min_nm << " to " << range.max_nm);
      CHECK(lattice_integral(bin_means(*s, lattice), lattice) ==
            Approx(literal_mean(*s, range) * range.width_nm()).epsilon(1e-6));
    }
  }
}

TEST_CASE("Point samples are the values at the lattice wavelengths", "[spectrum]") {
  const WavelengthLattice lattice;
  const SpectrumPtr s = blackbody_spectrum(4000);
  const LatticeSpectrum points = point_samples(*s, lattice);
  for (int lane = 0; lane < kLanes; ++lane) {
    for (int phase = 0; phase < kPhases; ++phase) {
      CHECK(points[phase][lane] == static_cast<float>((*s)(lattice.wavelength_nm(lane, phase))));
    }
  }
}

TEST_CASE("Planck's law has its maximum and its integral where they belong", "[spectrum]") {
  for (const double kelvin : {1000.0, 2856.0, 5772.0, 12000.0}) {
    const SpectrumPtr s = blackbody_spectrum(kelvin);
    // Wien 1893: the maximum per wavelength lies at b / T, b = 2.897771955e6 nm K.
    const double peak = 2.897771955e6 / kelvin;
    CHECK((*s)(peak) > (*s)(peak * 1.001));
    CHECK((*s)(peak) > (*s)(peak * 0.999));
    const double slope = ((*s)(peak * 1.00001) - (*s)(peak * 0.99999)) / (*s)(peak) / 2e-5;
    CHECK(std::abs(slope) < 1e-6);
    // Stefan-Boltzmann: the integral over all wavelengths is sigma T^4 / pi. In log wavelength the
    // midpoint rule converges fast.
    double integral = 0.0;
    const int points = 20000;
    const double lower = std::log(peak / 50.0), upper = std::log(peak * 5000.0);
    const double width = (upper - lower) / points;
    for (int i = 0; i < points; ++i) {
      const double nm = std::exp(lower + (i + 0.5) * width);
      integral += (*s)(nm)*nm * width;
    }
    CHECK(integral ==
          Approx(5.670374419e-8 * std::pow(kelvin, 4) / std::numbers::pi).epsilon(1e-8));
  }
}

TEST_CASE("Planck's law at the ends of its range", "[spectrum]") {
  const SpectrumPtr cold = blackbody_spectrum(3.0);
  CHECK((*cold)(380.0) == 0.0);  // exp overflows: no light, not NaN
  // Rayleigh-Jeans: 2 c k T / lambda^4 for long waves, to h c / (2 lambda k T).
  const double nm = 1e9;
  const double m = nm * 1e-9,
               rayleigh_jeans = 2.0 * 299792458.0 * 1.380649e-23 * 5000.0 / std::pow(m, 4);
  CHECK((*blackbody_spectrum(5000.0))(nm) == Approx(rayleigh_jeans * 1e-9).epsilon(1e-5));
  for (const double kelvin : {0.0, -1.0, std::nan(""), static_cast<double>(INFINITY)}) {
    CHECK_THROWS_AS(blackbody_spectrum(kelvin), std::invalid_argument);
  }
}

TEST_CASE("A scaled spectrum keeps the range", "[spectrum]") {
  const SpectrumPtr s = scaled_spectrum(random_table(3), 2.5), plain = random_table(3);
  CHECK(s->range().min_nm == plain->range().min_nm);
  CHECK((*s)(512.3) == 2.5 * (*plain)(512.3));
  CHECK(s->mean({500, 520}) == 2.5 * plain->mean({500, 520}));
}

TEST_CASE("A table that is none is refused", "[spectrum]") {
  CHECK_THROWS_AS(table_spectrum({}, {}, ""), std::invalid_argument);
  CHECK_THROWS_AS(table_spectrum({400, 500}, {1}, ""), std::invalid_argument);
  CHECK_THROWS_AS(table_spectrum({500, 400}, {1, 2}, ""), std::invalid_argument);
  CHECK_THROWS_AS(table_spectrum({400, 400}, {1, 2}, ""), std::invalid_argument);
  CHECK_THROWS_AS(table_spectrum({400, std::nan("")}, {1, 2}, ""), std::invalid_argument);
  CHECK_THROWS_AS(table_spectrum({400, INFINITY}, {1, 2}, ""), std::invalid_argument);
  CHECK_THROWS_AS(table_spectrum({std::nan("")}, {1}, ""), std::invalid_argument);
  CHECK_THROWS_AS(table_spectrum({400, 500}, {1, std::nan("")}, ""), std::invalid_argument);
}

TEST_CASE("Sampled spectra: lanes and sums", "[spectrum]") {
  const SampledSpectrum ramp = for_each_lane([](int i) { return static_cast<float>(i + 1); });
  CHECK(sum(ramp) == static_cast<float>(kLanes * (kLanes + 1) / 2));
  CHECK(mean(ramp) == 0.5f * static_cast<float>(kLanes + 1));
  CHECK(max_lane(ramp) == static_cast<float>(kLanes));
  CHECK(is_black(SampledSpectrum(0.0f)));
  CHECK_FALSE(is_black(ramp));
  SampledSpectrum broken = ramp;
  CHECK(is_finite(broken));
  broken[kLanes - 1] = std::nanf("");
  CHECK_FALSE(is_finite(broken));
  for (int i = 0; i < kLanes; ++i) {
    CHECK((2.0f * ramp + ramp - ramp)[i] == 2.0f * ramp[i]);
    CHECK((ramp * ramp / ramp)[i] == ramp[i]);
  }
}

TEST_CASE("The lattice covers its range without gaps", "[spectrum]") {
  const WavelengthLattice lattice({360, 830});
  double edge = 360.0;
  for (int lane = 0; lane < kLanes; ++lane) {
    for (int phase = 0; phase < kPhases; ++phase) {
      const WavelengthRange bin = lattice.bin(lane, phase);
      CHECK(bin.min_nm == Approx(edge).epsilon(1e-12));
      CHECK(lattice.wavelength_nm(lane, phase) ==
            Approx(0.5 * (bin.min_nm + bin.max_nm)).epsilon(1e-12));
      edge = bin.max_nm;
    }
  }
  CHECK(edge == Approx(830.0).epsilon(1e-12));
}
