// Thin films against closed forms and against the recursive method, which shares no step with the
// transfer matrices of the program.
#include "materials/thin_film.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "materials/film_stack.h"
#include "materials/fresnel.h"
#include "materials/index/index_catalogue.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi;

// Rouard 1937, Parratt 1954: r = (rho + r' x) / (1 + rho r' x), from the substrate outwards, with
// Fresnel's amplitudes rho and x = exp(2 i phase). In long double, so that what differs is ours.
struct Reflectances {
  double s, p;
};
Reflectances recursive(const std::vector<FilmLayer>& layers, Complex substrate, double cos_theta) {
  using Real = long double;
  using Long = std::complex<Real>;
  const Real c = cos_theta, s2 = (1 - c) * (1 + c);
  const auto normal_part = [&](Long m) {
    const Long q = std::sqrt(m * m - s2);
    return q.imag() < 0 ? -q : q;
  };
  std::array<double, 2> result{};
  for (const bool p : {false, true}) {
    const auto admittance = [&](Long m) { return p ? m * m / normal_part(m) : normal_part(m); };
    std::vector<Long> media{1};
    for (const FilmLayer& layer : layers) media.push_back(layer.index);
    media.push_back(substrate);
    Long r = 0;
    for (std::size_t i = layers.size() + 1; i-- > 0;) {
      const Long a = admittance(media[i]), b = admittance(media[i + 1]);
      const Long rho = (a - b) / (a + b);
      Long x = 0;
      if (i < layers.size()) {
        const Real turn = 4 * std::numbers::pi_v<Real> * Real(layers[i].thickness);
        x = std::exp(Long(0, turn) * normal_part(media[i + 1]));
      }
      r = (rho + r * x) / (Real(1) + rho * r * x);
    }
    result[p ? 1 : 0] = static_cast<double>(std::norm(r));
  }
  return {result[0], result[1]};
}

std::vector<FilmLayer> random_layers(std::mt19937& random, bool absorbing) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<FilmLayer> layers(static_cast<std::size_t>(1.0 + 6.0 * unit(random)));
  for (FilmLayer& layer : layers) {
    layer = {{0.3 + 3.0 * unit(random), absorbing ? 5.0 * unit(random) : 0.0}, 2.0 * unit(random)};
  }
  return layers;
}

TEST_CASE("without layers it is the exact Fresnel term", "[thin_film]") {
  const FresnelModel& exact = *Registry<FresnelModel>::instance().find("exact");
  for (const Complex m :
       {Complex(1.5, 0), Complex(0.18, 3.4), Complex(2.5, 3.3), Complex(0.6, 0)}) {
    for (const double c : {1.0, 0.9, 0.5, 0.1, 0.001, 0.0}) {
      const FilmResponse films = film_response({}, m, c);
      const FresnelModel::Scalar fresnel = exact.evaluate({m.real(), m.imag()}, c);
      CHECK(films.s.reflected == Approx(*fresnel.s).margin(1e-13));
      CHECK(films.p.reflected == Approx(*fresnel.p).margin(1e-13));
    }
  }
}

// Airy 1833, by intensities: R = (r1^2 + r2^2 + 2 r1 r2 cos d) / (1 + r1^2 r2^2 + 2 r1 r2 cos d).
TEST_CASE("one transparent film: Airy's formula", "[thin_film]") {
  const double n = 2.4, substrate = 1.52;
  for (const double c : {1.0, 0.7, 0.2}) {
    for (const double thickness : {0.01, 0.1, 0.37, 5.0}) {
      const double s2 = 1.0 - c * c, q1 = std::sqrt(n * n - s2);
      const double q2 = std::sqrt(substrate * substrate - s2), d = 4.0 * kPi * thickness * q1;
      const auto airy = [&](double r1, double r2) {
        const double fringe = 2.0 * r1 * r2 * std::cos(d);
        return (r1 * r1 + r2 * r2 + fringe) / (1.0 + r1 * r1 * r2 * r2 + fringe);
      };
      const double n2 = n * n, g2 = substrate * substrate;
      const FilmResponse films =
          film_response(std::vector<FilmLayer>{{n, thickness}}, substrate, c);
      CHECK(films.s.reflected ==
            Approx(airy((c - q1) / (c + q1), (q1 - q2) / (q1 + q2))).epsilon(1e-12));
      CHECK(films.p.reflected ==
            Approx(airy((n2 * c - q1) / (n2 * c + q1), (g2 * q1 - n2 * q2) / (g2 * q1 + n2 * q2)))
                .epsilon(1e-12));
    }
  }
}

// Born and Wolf, section 1.6.4: a quarter wave gives ((ns - n^2) / (ns + n^2))^2, a half wave
// nothing; the classical MgF2 on glass reflects 1.26 %.
TEST_CASE("quarter and half waves at normal incidence", "[thin_film]") {
  const double n = 1.38, glass = 1.52;
  const auto reflected = [&](double wavelengths) {
    return film_response(std::vector<FilmLayer>{{n, wavelengths / n}}, glass, 1.0).reflected();
  };
  const double quarter = (glass - n * n) / (glass + n * n), bare = (glass - 1.0) / (glass + 1.0);
  CHECK(reflected(0.25) == Approx(quarter * quarter).epsilon(1e-12));
  CHECK(reflected(0.25) == Approx(0.0126).margin(5e-5));
  CHECK(reflected(0.5) == Approx(bare * bare).epsilon(1e-12));
  CHECK(
      film_response(std::vector<FilmLayer>{{std::sqrt(glass), 0.25 / std::sqrt(glass)}}, glass, 1.0)
          .reflected() == Approx(0.0).margin(1e-30));
}

// Born and Wolf, section 1.6.5, equation 99: N pairs of quarter waves on glass.
TEST_CASE("Bragg mirrors: the closed form for any number of pairs", "[thin_film]") {
  const double high = 2.3, low = 1.38, glass = 1.52;
  for (const int pairs : {1, 2, 5, 10, 400}) {
    std::vector<FilmLayer> layers;
    for (int i = 0; i < pairs; ++i) {
      layers.push_back({high, 0.25 / high});
      layers.push_back({low, 0.25 / low});
    }
    const double ratio = glass * std::pow(high / low, 2 * pairs);
    const double amplitude = ratio < 1e150 ? (1.0 - ratio) / (1.0 + ratio) : 1.0;
    const FilmResponse films = film_response(layers, glass, 1.0);
    CHECK(films.s.reflected == Approx(amplitude * amplitude).epsilon(1e-12));
    CHECK(films.p.reflected == Approx(amplitude * amplitude).epsilon(1e-12));
    CHECK(films.s.transmitted == Approx(1.0 - amplitude * amplitude).margin(1e-12));
  }
}

TEST_CASE("random stacks agree with the recursive method", "[thin_film]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double worst = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const std::vector<FilmLayer> layers = random_layers(random, i % 2 == 0);
    const Complex substrate(0.1 + 3.0 * unit(random), 6.0 * unit(random));
    const double c = unit(random);
    const Reflectances expected = recursive(layers, substrate, c);
    const FilmResponse films = film_response(layers, substrate, c);
    worst = std::max({worst, std::abs(films.s.reflected - expected.s),
                      std::abs(films.p.reflected - expected.p)});
  }
  CHECK(worst < 1e-11);
}

TEST_CASE("energy: nothing is lost in transparent films, nothing gained in others", "[thin_film]") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 5000; ++i) {
    const bool absorbing = i % 2 == 0;
    const std::vector<FilmLayer> layers = random_layers(random, absorbing);
    const FilmResponse films =
        film_response(layers, {0.5 + 2.0 * unit(random), 3.0 * unit(random)}, unit(random));
    for (const FilmPower& power : {films.s, films.p}) {
      const double sum = power.reflected + power.transmitted;
      if (absorbing ? sum > 1.0 + 1e-12 : std::abs(sum - 1.0) > 1e-9) FAIL_CHECK(i << ": " << sum);
    }
  }
}

// Yeh, Optical Waves in Layered Media, section 4.3: A = 1 - R - T of a metal film is the flux that
// the matrices lose. A film split into ten is the same film.
TEST_CASE("a film in ten slices is the same film", "[thin_film]") {
  const Complex film(1.2, 2.1), substrate(1.5, 0.0);
  for (const double c : {1.0, 0.4}) {
    const FilmResponse whole = film_response(std::vector<FilmLayer>{{film, 0.05}}, substrate, c);
    const FilmResponse slices =
        film_response(std::vector<FilmLayer>(10, FilmLayer{film, 0.005}), substrate, c);
    CHECK(slices.s.reflected == Approx(whole.s.reflected).epsilon(1e-12));
    CHECK(slices.p.transmitted == Approx(whole.p.transmitted).epsilon(1e-12));
    CHECK(whole.s.reflected + whole.s.transmitted < 0.99);
  }
}

TEST_CASE("films of any thickness and absorption stay finite", "[thin_film]") {
  const Complex substrate(1.5, 0.0);
  for (const double thickness : {0.0, 1e-12, 1.0, 1e3, 1e6}) {
    for (const Complex film : {Complex(0.05, 5.0), Complex(2.0, 1e-9), Complex(1.0, 0.0)}) {
      for (const double c : {0.0, 1e-9, 0.5, 1.0}) {
        const FilmResponse films = film_response(
            std::vector<FilmLayer>{{film, thickness}, {3.0, thickness}}, substrate, c);
        for (const double value :
             {films.s.reflected, films.s.transmitted, films.p.reflected, films.p.transmitted}) {
          CHECK(value >= 0.0);
          CHECK(value <= 1.0);
        }
      }
    }
  }
  // A metal that lets nothing through is a half-space of that metal.
  const Complex silver(0.05, 4.0);
  const double thick =
      film_response(std::vector<FilmLayer>{{silver, 1e4}}, substrate, 0.6).reflected();
  CHECK(thick == Approx(film_response({}, silver, 0.6).reflected()).epsilon(1e-13));
}

// Frustrated total reflection: a thin gap of air between two glasses (relative index 1/1.5 and 1)
// lets light through at 45 degrees, a thick one none.
TEST_CASE("a critical angle and an evanescent gap", "[thin_film]") {
  const double gap = 1.0 / 1.5, c = std::sqrt(0.5);
  const auto transmitted = [&](double thickness) {
    return film_response(std::vector<FilmLayer>{{gap, thickness}}, 1.0, c).s.transmitted;
  };
  // Born and Wolf, section 7.6: T = 1 / (1 + ((c^2 + g^2) / (2 c g))^2 sinh^2(2 pi g d)).
  const double g = std::sqrt(0.5 - gap * gap), ratio = (c * c + g * g) / (2.0 * c * g);
  const double sinh = std::sinh(2.0 * kPi * g * 0.3);
  CHECK(transmitted(0.3) == Approx(1.0 / (1.0 + ratio * ratio * sinh * sinh)).epsilon(1e-12));
  CHECK(transmitted(50.0) < 1e-30);
  const double critical = std::sqrt(1.0 - gap * gap);
  const FilmResponse at = film_response(std::vector<FilmLayer>{{gap, 0.3}}, 1.0, critical);
  const FilmResponse near = film_response(std::vector<FilmLayer>{{gap, 0.3}}, 1.0, critical + 1e-9);
  CHECK(at.s.reflected == Approx(near.s.reflected).margin(1e-6));
  CHECK(at.p.reflected == Approx(near.p.reflected).margin(1e-6));
}

FilmStack oxide(double thickness_nm) {
  return {{{constant_index({2.4, 0.0}), thickness_nm}}, find_index_table("main/Ti/Johnson")};
}

TEST_CASE("the tabulated reflectance of films is right at every angle", "[thin_film]") {
  const WavelengthLattice lattice;
  const IndexTablePtr air = constant_index({1.0, 0.0});
  for (const double thickness_nm : {20.0, 60.0, 150.0}) {
    const FilmStack stack = oxide(thickness_nm);
    const TabulatedReflectance films = tabulated_films(stack, *air, lattice);
    CHECK(films.error <= kTabulatedError);
    CHECK(films.intervals <= 128);
    double worst = 0.0;
    for (int i = 0; i <= 997; ++i) {
      const double c = kGrazingCosine + (1.0 - kGrazingCosine) * i / 997.0;
      const int phase = i % kPhases;
      const SampledSpectrum r =
          tabulated_fresnel().reflectance(films.tables, phase, static_cast<float>(c));
      for (int lane = 0; lane < kLanes; ++lane) {
        const double nm = lattice.wavelength_nm(lane, phase);
        worst = std::max(worst, std::abs(r[lane] - film_response(stack, 1.0, nm, c).reflected()));
      }
    }
    CHECK(worst < 1.1 * kTabulatedError);  // end intervals peak 7 % above their middle
  }
}

// 10 um of oxide: a fringe is 3 nm wide at 400 nm, four bins. The tabulated value is the mean over
// the bin.
TEST_CASE("fringes of thick films are averaged over the lattice's bins", "[thin_film]") {
  const WavelengthLattice lattice;
  const FilmStack stack = oxide(10000.0);
  const TabulatedReflectance films = tabulated_films(stack, *constant_index({1.0, 0.0}), lattice);
  const WavelengthRange bin = lattice.bin(0, 5);
  double mean = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double nm = bin.min_nm + bin.width_nm() * (i + 0.5) / 1000;
    mean += film_response(stack, 1.0, nm, 1.0).reflected() / 1000;
  }
  const double centre = film_response(stack, 1.0, lattice.wavelength_nm(0, 5), 1.0).reflected();
  CHECK(tabulated_fresnel().reflectance(films.tables, 5, 1.0f)[0] == Approx(mean).margin(1e-3));
  CHECK(std::abs(mean - centre) > 2e-3);  // the mean is not the centre's value
}

TEST_CASE("water outside: everything counts relative to it", "[thin_film]") {
  const FilmStack stack = oxide(80.0);
  const IndexTablePtr water = constant_index({1.33, 0.0});
  const WavelengthLattice lattice;
  const TabulatedReflectance films = tabulated_films(stack, *water, lattice);
  const double nm = lattice.wavelength_nm(7, 9);
  const ComplexIndex ti = stack.substrate->at(nm);
  const Complex relative = Complex(ti.n, ti.k) / 1.33;
  const Reflectances expected = recursive({{2.4 / 1.33, 80.0 * 1.33 / nm}}, relative, 0.5);
  CHECK(tabulated_fresnel().reflectance(films.tables, 9, 0.5f)[7] ==
        Approx(0.5 * (expected.s + expected.p)).margin(kTabulatedError));
}

TEST_CASE("a stack where an index is wanted: an error, not a number", "[thin_film]") {
  const IndexTablePtr table = layered_index(oxide(50.0), {"oxide", "", "", "", ""});
  CHECK(film_stack_of(*table) != nullptr);
  CHECK(film_stack_of(*constant_index({1.0, 0.0})) == nullptr);
  CHECK(table->range().min_nm == find_index_table("main/Ti/Johnson")->range().min_nm);
  CHECK_THROWS_AS(table->at(500.0), InputError);
  CHECK_THROWS_AS(layered_index(oxide(30000.0), {}), InputError);
  FilmStack empty = oxide(50.0);
  empty.layers[0].index = constant_index({0.0, 0.0});
  CHECK_THROWS_AS(film_response(empty, 1.0, 500.0, 1.0), InputError);
}

}  // namespace
}  // namespace karat
