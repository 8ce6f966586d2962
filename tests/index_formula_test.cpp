// Each dispersion formula against values that others published, or against its text evaluated by
// hand.
#include "materials/index/index_formula.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "spectral/support/error.h"

using namespace karat;
using Catch::Contains;

namespace {

double index_of(int number, std::vector<double> coefficients, double um) {
  const auto n = DispersionFormula{number, std::move(coefficients)}.index(um);
  REQUIRE(n);
  return *n;
}

}  // namespace

TEST_CASE("formula 1: fused silica, Malitson 1965, table 1", "[index][formula]") {
  const std::vector<double> c = {0,         0.6961663, 0.0684043, 0.4079426,
                                 0.1162414, 0.8974794, 9.896161};
  CHECK(index_of(1, c, 0.587561) == Approx(1.45846).margin(1e-5));
  CHECK(index_of(1, c, 0.404656) == Approx(1.46962).margin(1e-5));
  CHECK(index_of(1, c, 1.529582) == Approx(1.44427).margin(1e-5));
}

TEST_CASE("formula 2: N-BK7, the data sheet's n_d, n_F, n_C", "[index][formula]") {
  const std::vector<double> c = {0,          1.03961212, 0.00600069867, 0.231792344, 0.0200179144,
                                 1.01046945, 103.560653};
  CHECK(index_of(2, c, 0.5875618) == Approx(1.51680).margin(5e-6));
  CHECK(index_of(2, c, 0.4861327) == Approx(1.52238).margin(5e-6));
  CHECK(index_of(2, c, 0.6562725) == Approx(1.51432).margin(5e-6));
}

TEST_CASE("formula 3: Schott's old glass formula, BK7 n_d", "[index][formula]") {
  // Schott 1966 catalogue: n^2 = A0 + A1 L^2 + A2 L^-2 + A3 L^-4 + A4 L^-6 + A5 L^-8.
  const std::vector<double> c = {2.2718929, -1.0108077e-2, 2,  1.0592509e-2, -2, 2.0816965e-4,
                                 -4,        -7.6472538e-6, -6, 4.9240991e-7, -8};
  CHECK(index_of(3, c, 0.5875618) == Approx(1.51680).margin(1e-5));
}

TEST_CASE("formula 4: rutile, Devore 1951, n_o in sodium light", "[index][formula]") {
  // n^2 = 5.913 + 0.2441 / (L^2 - 0.0803); the squared resonance is written 0.0803^1.
  const std::vector<double> c = {5.913, 0.2441, 0, 0.0803, 1};
  CHECK(index_of(4, c, 0.5893) == Approx(2.613).margin(1e-3));
}

TEST_CASE("formula 4: an unused resonance with 0^0 below the line is absent", "[index][formula]") {
  // At L = 1 um the absent term is 0 / (1 - 0^0) = 0 / 0.
  CHECK(index_of(4, {2.25, 0, 0, 0, 0, 0, 0, 0, 0}, 1.0) == 1.5);
  // 2.25 + 1 L^2 / (L^2 - 2^-2) + 0.5 L^3 at L = 1.
  CHECK(index_of(4, {2.25, 1, 2, 2, -2, 0, 0, 0, 0, 0.5, 3}, 1.0) ==
        Approx(std::sqrt(2.25 + 1 / 0.75 + 0.5)).epsilon(1e-14));
}

TEST_CASE("formula 5: acetone, Rheims et al. 1997, n at 589.3 nm", "[index][formula]") {
  CHECK(index_of(5, {1.34979, 0.00306, -2, 0.00006, -4}, 0.5893) == Approx(1.35910).margin(5e-5));
}

TEST_CASE("formula 6: air at 15 C, Ciddor 1996, against Peck and Reeder 1972 at 633 nm",
          "[index][formula]") {
  // 10^8 (n - 1) = 8060.51 + 2480990 / (132.274 - s^2) + 17455.7 / (39.32957 - s^2), s = 1/L; the
  // two fits of different measurements agree to a few 1e-8.
  const std::vector<double> c = {0, 0.05792105, 238.0185, 0.00167917, 57.362};
  CHECK(std::abs(index_of(6, c, 0.633) - 1.000276515) < 3e-8);
}

TEST_CASE("formula 7: silicon, Herzberger's form with Edwards and Ochoa's 1980 coefficients",
          "[index][formula]") {
  const std::vector<double> c = {3.41983, 0.159906, -0.123109, 1.26878e-6, -1.95104e-9};
  CHECK(index_of(7, c, 2.4373) == Approx(3.4434).margin(5e-4));
  CHECK(index_of(7, c, 10.0) == Approx(3.4215).margin(5e-4));
  const double h = 1.0 / (4.0 - 0.028);
  CHECK(index_of(7, {1, 2, 3, 4, 5, 6}, 2.0) ==
        Approx(1 + 2 * h + 3 * h * h + 4 * 4 + 5 * 16 + 6 * 64).epsilon(1e-14));
}

TEST_CASE("formula 8: silver bromide, Schroter 1931", "[index][formula]") {
  // x = (n^2 - 1) / (n^2 + 2) = C1 + C2 L^2 / (L^2 - C3) + C4 L^2, checked by going back from n to
  // x.
  const std::vector<double> c = {0.452505, 0.09939, 0.070537, -0.00015};
  const double n = index_of(8, c, 0.6), l2 = 0.36;
  CHECK((n * n - 1) / (n * n + 2) ==
        Approx(0.452505 + 0.09939 * l2 / (l2 - 0.070537) - 0.00015 * l2).epsilon(1e-13));
  CHECK(n == Approx(2.2539).margin(2e-3));
}

TEST_CASE("formula 9: against its text evaluated by hand", "[index][formula]") {
  const double n = index_of(9, {2, 0.5, 0.25, 0.75, 0.5, 1.25}, 2.0);
  CHECK(n * n == Approx(2 + 0.5 / 3.75 + 0.75 * 1.5 / (2.25 + 1.25)).epsilon(1e-14));
}

TEST_CASE("missing trailing coefficients are zero, in every formula", "[index][formula]") {
  for (int number = 1; number <= 9; ++number) {
    INFO("formula " << number);
    const double expected = number <= 2                  ? std::sqrt(1.5)
                            : number == 6                ? 1.5
                            : number == 8                ? std::sqrt(2.0 / 0.5)
                            : number == 5 || number == 7 ? 0.5
                                                         : std::sqrt(0.5);
    CHECK(index_of(number, {0.5}, 0.7) == Approx(expected).epsilon(1e-14));
  }
}

TEST_CASE("where a formula has no index it says so, and gives no NaN", "[index][formula]") {
  CHECK_FALSE(DispersionFormula{2, {-3.0}}.index(0.5));              // n^2 < 0
  CHECK_FALSE(DispersionFormula{1, {0.0, 1.0, 0.5}}.index(0.5));     // on the pole
  CHECK_FALSE(DispersionFormula{5, {1e9}}.index(0.5));               // no index is that large
  CHECK_FALSE(DispersionFormula{4, {1, 1, 0, -2, 0.5}}.index(0.5));  // a root of -2
  CHECK_FALSE(DispersionFormula{10, {1.0}}.index(0.5));
  // 1 - 0.5 / (L^2 - 0) changes sign at 0.7071 um.
  const auto curve = formula_curve({4, {1.0, -0.5, 0, 0, 1}}, {400.0, 1000.0}, "FILE: block 1");
  CHECK((*curve.n)(1000.0) == Approx(std::sqrt(0.5)).epsilon(1e-12));
  CHECK_THROWS_WITH((*curve.n)(600.0), Contains("FILE: block 1") && Contains("600 nm"));
  CHECK_THAT(curve.gaps, Contains("400 to 70"));
  CHECK_THROWS_AS(formula_curve({2, {-3.0}}, {400.0, 700.0}, "FILE"), InputError);
}
