#include "materials/index/index_oscillators.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "spectral/support/error.h"

namespace karat {
namespace {

const std::filesystem::path kDatabase =
    std::filesystem::path(KARAT_TEST_REFERENCE_DIR) / "refractiveindex.info/database/data";

// Rakic et al. 1998, tables 1 and 2: plasma energy, f_0, Gamma_0 and f_j, Gamma_j, omega_j in eV.
OscillatorModel rakic(const std::string& metal) {
  if (metal == "Au") {
    return {9.03,
            1.0,
            0.760,
            0.053,
            {{0.024, 0.241, 0.415},
             {0.010, 0.345, 0.830},
             {0.071, 0.870, 2.969},
             {0.601, 2.494, 4.304},
             {4.384, 2.214, 13.32}}};
  }
  if (metal == "Ag") {
    return {9.01,
            1.0,
            0.845,
            0.048,
            {{0.065, 3.886, 0.816},
             {0.124, 0.452, 4.481},
             {0.011, 0.065, 8.185},
             {0.840, 0.916, 9.083},
             {5.646, 2.419, 20.29}}};
  }
  if (metal == "Cu") {
    return {10.83,
            1.0,
            0.575,
            0.030,
            {{0.061, 0.378, 0.291},
             {0.104, 1.056, 2.957},
             {0.723, 3.213, 5.300},
             {0.638, 4.305, 11.18}}};
  }
  return {
      14.98,
      1.0,
      0.523,
      0.047,
      {{0.227, 0.333, 0.162}, {0.050, 0.312, 1.544}, {0.166, 1.351, 1.808}, {0.030, 3.382, 3.473}}};
}

TEST_CASE("Rakic's Lorentz-Drude metals reproduce the database's tables", "[index_oscillators]") {
  if (!std::filesystem::exists(kDatabase)) {
    WARN("skipped: no " << kDatabase.string());
    return;
  }
  for (const std::string metal : {"Au", "Ag", "Cu", "Al"}) {
    INFO(metal);
    const std::string file = "main/" + metal + "/nk/Rakic-LD.yml";
    const IndexTablePtr made = oscillator_index(rakic(metal), {});
    std::ifstream rows(kDatabase / file);
    double worst = 0.0, um = 0.0, n = 0.0, k = 0.0;
    int compared = 0;
    for (std::string row; std::getline(rows, row);) {
      if (std::sscanf(row.c_str(), " %lf %lf %lf", &um, &n, &k) != 3) continue;
      const ComplexIndex index = made->at(um * 1000.0);
      worst = std::max(worst, std::hypot(index.n - n, index.k - k) / std::hypot(n, k));
      ++compared;
    }
    CHECK(compared >= 200);
    CHECK(worst < 3e-4);  // the file has five digits, of wavelength too
  }
}

TEST_CASE("Drude: closed forms", "[index_oscillators]") {
  OscillatorModel metal;
  metal.plasma_ev = 9.0;
  metal.free_strength = 1.0;
  // Without damping eps = 1 - (plasma / w)^2: 0 at the plasma energy, -3 at half of it.
  CHECK(permittivity_of(metal, 9.0).real() == Approx(0.0).margin(1e-14));
  CHECK(permittivity_of(metal, 4.5).real() == Approx(-3.0));
  CHECK(permittivity_of(metal, 4.5).imag() == Approx(0.0).margin(1e-14));
  const IndexTablePtr table = oscillator_index(metal, {});
  CHECK(table->at(kEvNm / 4.5).k == Approx(std::sqrt(3.0)));
  CHECK(table->at(kEvNm / 4.5).n == Approx(0.0).margin(1e-12));
  CHECK(table->at(kEvNm / 18.0).n == Approx(std::sqrt(0.75)));
  // Real and imaginary part with damping: eps_inf - p^2 / (w^2 + g^2), p^2 g / (w (w^2 + g^2)).
  metal.free_gamma_ev = 0.5;
  metal.eps_inf = 4.0;
  const double w = 2.0, g = 0.5, p2 = 81.0;
  CHECK(permittivity_of(metal, w).real() == Approx(4.0 - p2 / (w * w + g * g)));
  CHECK(permittivity_of(metal, w).imag() == Approx(p2 * g / (w * (w * w + g * g))));
  CHECK(kEvNm == Approx(1239.841984).epsilon(1e-9));
}

TEST_CASE("a Lorentz oscillator: static value, resonance and sum rule", "[index_oscillators]") {
  OscillatorModel glass;
  glass.plasma_ev = 2.0;
  glass.bound = {{1.5, 0.3, 5.0}};
  CHECK(permittivity_of(glass, 1e-6).real() == Approx(1.0 + 1.5 * 4.0 / 25.0));
  CHECK(permittivity_of(glass, 5.0).real() == Approx(1.0));
  CHECK(permittivity_of(glass, 5.0).imag() == Approx(1.5 * 4.0 / (5.0 * 0.3)));
  // integral of w Im(eps) dw = pi/2 f plasma^2: the f-sum rule, by the midpoint rule to 1000 eV.
  double sum = 0.0;
  constexpr double kStep = 0.01;
  for (double w = 0.5 * kStep; w < 1000.0; w += kStep)
    sum += w * permittivity_of(glass, w).imag() * kStep;
  CHECK(sum == Approx(0.5 * 3.14159265358979 * 1.5 * 4.0).epsilon(1e-3));
}

TEST_CASE("a resonance without damping is an error, not infinity", "[index_oscillators]") {
  OscillatorModel model;
  model.plasma_ev = 1.0;
  model.bound = {{1.0, 0.0, 2.0}};
  const IndexTablePtr table = oscillator_index(model, {});
  CHECK(table->at(kEvNm / 1.9).n > 1.0);
  CHECK_THROWS_AS(table->at(kEvNm / 2.0), InputError);
}

TEST_CASE("formulas are passive and finite everywhere", "[index_oscillators]") {
  for (const std::string metal : {"Au", "Ag", "Cu", "Al"}) {
    const IndexTablePtr table = oscillator_index(rakic(metal), {});
    CHECK(table->range().covers({10.0, 1e6}));
    CHECK(table->has_k());
    for (double nm = 10.0; nm < 1e6; nm *= 1.01) {
      const ComplexIndex index = table->at(nm);
      if (!(index.n > 0.0 && index.k > 0.0 && std::isfinite(index.n + index.k))) FAIL_CHECK(nm);
    }
  }
}

}  // namespace
}  // namespace karat
