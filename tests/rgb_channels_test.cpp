#include "materials/rgb_channels.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "materials/fresnel.h"
#include "spectral/illuminant.h"
#include "spectral/support/error.h"
#include "tests/reference_fresnel.h"

using namespace karat;

namespace {

// Like gold: an edge in the visible.
ComplexIndex golden(double nm) {
  const double t = 1.0 / (1.0 + std::exp((nm - 520.0) / 20.0));
  return {0.2 + 1.3 * t, 3.2 - 1.3 * t + (nm - 520.0) * 0.006 * (1.0 - t)};
}

LatticeIndex golden_on(const WavelengthLattice& lattice) {
  LatticeIndex index;
  index.lattice = lattice;
  for (int phase = 0; phase < kPhases; ++phase) {
    for (int i = 0; i < kLanes; ++i) {
      const ComplexIndex m = golden(lattice.wavelength_nm(i, phase));
      index.n[phase][i] = static_cast<float>(m.n);
      index.k[phase][i] = static_cast<float>(m.k);
    }
  }
  return index;
}

// Linear sRGB under D65 of lattice values, by sums at 1 nm.
Rgb colour_of(const LatticeSpectrum& spectrum, const WavelengthLattice& lattice) {
  const auto at = [&](double nm) {
    const double x = (nm - lattice.wavelength_nm(0, 0)) / lattice.bin_width_nm();
    const int place = std::clamp(static_cast<int>(std::lround(x)), 0, kLatticeSize - 1);
    return double{spectrum[place % kPhases][place / kPhases]};
  };
  return linear_srgb_of_xyz(
      xyz_of_reflectance(at, *illuminant("D65"), observer(), lattice.range()));
}

Rgb colour_of_function(const WavelengthFunction& f, const WavelengthLattice& lattice) {
  return linear_srgb_of_xyz(xyz_of_reflectance(f, *illuminant("D65"), observer(), lattice.range()));
}

// The colour that a model shows at an angle, in linear sRGB under D65.
Rgb shown(const std::string& name, double cos_theta, const WavelengthLattice& lattice) {
  const FresnelModel& model = *Registry<FresnelModel>::instance().find(name);
  const FresnelTables tables = model.prepare(golden_on(lattice));
  LatticeSpectrum r;
  for (int phase = 0; phase < kPhases; ++phase) {
    r[phase] = model.reflectance(tables, phase, static_cast<float>(cos_theta));
  }
  return colour_of(r, lattice);
}

double clamped(double x) { return std::clamp(x, 0.0, 1.0); }

// Sums at 1 nm and at the lattice's 0.8 nm differ by some 1e-4.
constexpr double kTolerance = 1e-3;

}  // namespace

TEST_CASE("the primaries are colours of their own, and white together", "[rgb_channels]") {
  for (const WavelengthRange range :
       {kVisible, WavelengthRange{400.0, 700.0}, WavelengthRange{360.0, 1000.0}}) {
    const WavelengthLattice lattice(range);
    const auto channels = RgbChannels::of(lattice);
    CAPTURE(range.min_nm, range.max_nm);
    for (std::size_t p = 0; p < 3; ++p) {
      const Rgb rgb = channels->rgb(channels->primaries()[p]);
      const Rgb by_sums = colour_of(channels->primaries()[p], lattice);
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(rgb[c] == Approx(p == c ? 1.0 : 0.0).margin(1e-5));
        if (range.min_nm == 380.0) CHECK(by_sums[c] == Approx(rgb[c]).margin(kTolerance));
      }
    }
    double least = 1.0, off_white = 0.0;
    for (int phase = 0; phase < kPhases; ++phase) {
      for (int i = 0; i < kLanes; ++i) {
        double sum = 0.0;
        for (const LatticeSpectrum& primary : channels->primaries()) {
          least = std::min(least, double{primary[phase][i]});
          sum += double{primary[phase][i]};
        }
        off_white = std::max(off_white, std::abs(sum - 1.0));
      }
    }
    CHECK(least >= 0.0);
    CHECK(off_white <= 2e-7);
  }
}

TEST_CASE("wavelengths without colour have no colour channels", "[rgb_channels]") {
  CHECK_THROWS_AS(RgbChannels::of(WavelengthLattice({800.0, 1600.0})), InputError);
  CHECK_THROWS_AS(RgbChannels::of(WavelengthLattice({500.0, 600.0})), InputError);
}

TEST_CASE("an RGB workflow shows the colour that an RGB renderer computes", "[rgb_channels]") {
  const WavelengthLattice lattice;
  const auto exact_f0 = [](double nm) {
    return reference::fresnel(golden(nm).n, golden(nm).k, 1.0).unpolarised();
  };
  const auto exact_f82 = [](double nm) {
    return reference::fresnel(golden(nm).n, golden(nm).k, 1.0 / 7.0).unpolarised();
  };
  const Rgb f0 = colour_of_function(exact_f0, lattice),
            f82 = colour_of_function(exact_f82, lattice);
  const Rgb n = colour_of_function([](double nm) { return golden(nm).n; }, lattice);
  const Rgb k = colour_of_function([](double nm) { return golden(nm).k; }, lattice);
  const auto schlick = [](double f, double c) { return f + (1.0 - f) * std::pow(1.0 - c, 5.0); };
  for (const double c : {1.0, 0.6, 0.3, 0.12, 0.03}) {
    CAPTURE(c);
    const Rgb average = shown("rgb-exact-average", c, lattice);
    const Rgb round = shown("rgb-exact-650-550-450", c, lattice);
    const Rgb dominant = shown("rgb-exact-611-549-464", c, lattice);
    const Rgb as_schlick = shown("rgb-schlick", c, lattice), as_f82 = shown("rgb-f82", c, lattice);
    const Rgb at_round{650.0, 550.0, 450.0}, at_dominant{611.0, 549.0, 464.0};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto exact = [&](double nm) {
        return reference::fresnel(golden(nm).n, golden(nm).k, c).unpolarised();
      };
      CHECK(round[i] == Approx(exact(at_round[i])).margin(kTolerance));
      CHECK(dominant[i] == Approx(exact(at_dominant[i])).margin(kTolerance));
      const double averaged =
          reference::fresnel(std::max(n[i], 0.0), std::max(k[i], 0.0), c).unpolarised();
      CHECK(average[i] == Approx(averaged).margin(kTolerance));
      const double base = clamped(f0[i]), s = schlick(base, 1.0 / 7.0);
      CHECK(as_schlick[i] == Approx(schlick(base, c)).margin(kTolerance));
      const double b = (s - clamped(f82[i] / s) * s) * 17.6513846;
      const double tinted = schlick(base, c) - b * c * std::pow(1.0 - c, 6.0);
      CHECK(as_f82[i] == Approx(clamped(tinted)).margin(kTolerance));
    }
  }
}
