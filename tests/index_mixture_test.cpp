#include "materials/index/index_mixture.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "materials/index/element.h"
#include "materials/index/index_catalogue.h"
#include "materials/index/index_colour.h"
#include "materials/permittivity.h"
#include "spectral/illuminant.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

const MixingRule& rule(const std::string& name) {
  const MixingRule* found = Registry<MixingRule>::instance().find(name);
  REQUIRE(found);
  return *found;
}

double number(std::mt19937& random, double least, double largest) {
  return std::uniform_real_distribution<double>(least, largest)(random);
}

// Permittivities of metals (real part far below 0, little loss) and of dielectrics.
std::vector<MixingPart> random_parts(std::mt19937& random, std::size_t count) {
  std::vector<MixingPart> parts(count);
  double sum = 0.0;
  for (MixingPart& part : parts) {
    part = {number(random, 0.0, 1.0),
            {number(random, -60.0, 20.0), std::pow(10.0, number(random, -6.0, 1.5))}};
    sum += part.fraction;
  }
  for (MixingPart& part : parts) part.fraction /= sum;
  return parts;
}

double bruggeman_residual(const std::vector<MixingPart>& parts, Permittivity eps) {
  Permittivity sum = 0.0;
  double size = 0.0;
  for (const MixingPart& part : parts) {
    const Permittivity term =
        part.fraction * (part.permittivity - eps) / (part.permittivity + 2.0 * eps);
    sum += term;
    size += std::abs(term);
  }
  return std::abs(sum) / std::max(size, 1.0);
}

TEST_CASE("every rule: parts alone, in limits, and never with gain", "[index_mixture]") {
  std::mt19937 random(1);
  for (const std::string& name : Registry<MixingRule>::instance().names()) {
    INFO(name);
    CHECK(!rule(name).description().empty());
    CHECK(!rule(name).source().empty());
    const Permittivity gold(-11.0, 1.2), glass(2.25, 0.0);
    const auto close = [](Permittivity a, Permittivity b) { return std::abs(a - b) < 1e-12; };
    CHECK(close(rule(name).mixed(std::vector<MixingPart>{{1.0, gold}}, 0), gold));
    CHECK(close(rule(name).mixed(std::vector<MixingPart>{{1.0, gold}, {0.0, glass}}, 0), gold));
    CHECK(close(rule(name).mixed(std::vector<MixingPart>{{0.3, gold}, {0.7, gold}}, 0), gold));
    // To the first order in small differences every rule is the mean.
    const Permittivity near = gold * (1.0 + 1e-5);
    CHECK(std::abs(rule(name).mixed(std::vector<MixingPart>{{0.6, gold}, {0.4, near}}, 0) -
                   (0.6 * gold + 0.4 * near)) < 1e-8);
    for (int i = 0; i < 2000; ++i) {
      const auto parts = random_parts(random, 2 + static_cast<std::size_t>(i % 4));
      const Permittivity mixed = rule(name).mixed(parts, 0);
      if (!(mixed.imag() >= 0.0 && std::isfinite(mixed.real()))) FAIL_CHECK(mixed);
    }
  }
}

// 2 eps^2 - b eps - eps1 eps2 = 0, b = (3 f1 - 1) eps1 + (3 f2 - 1) eps2.
TEST_CASE("Bruggeman of two parts is the passive root of the quadratic", "[index_mixture]") {
  std::mt19937 random(2);
  for (int i = 0; i < 20000; ++i) {
    const auto parts = random_parts(random, 2);
    const Permittivity e1 = parts[0].permittivity, e2 = parts[1].permittivity;
    const Permittivity b =
        (3.0 * parts[0].fraction - 1.0) * e1 + (3.0 * parts[1].fraction - 1.0) * e2;
    const Permittivity root = std::sqrt(b * b + 8.0 * e1 * e2);
    const Permittivity u = 0.25 * (b + root), v = 0.25 * (b - root);
    const Permittivity expected = u.imag() > v.imag() ? u : v;
    const Permittivity mixed = rule("bruggeman").mixed(parts, 0);
    // The root itself is only as good as its discriminant.
    const double tolerance = 1e-9 * std::abs(expected) + 1e-14 * std::norm(b) / std::abs(root);
    if (std::abs(mixed - expected) > tolerance)
      FAIL_CHECK(i << ": " << mixed << " not " << expected);
  }
}

TEST_CASE("Bruggeman of many parts solves its equation", "[index_mixture]") {
  std::mt19937 random(3);
  double worst = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const auto parts = random_parts(random, 2 + static_cast<std::size_t>(i % 7));
    worst = std::max(worst, bruggeman_residual(parts, rule("bruggeman").mixed(parts, 0)));
  }
  CHECK(worst < 1e-11);
}

TEST_CASE("Bruggeman of lossless parts", "[index_mixture]") {
  // Two dielectrics: the positive root. Metal and dielectric of opposite sign: above the
  // percolation threshold the mixture absorbs although no part does.
  const auto mixed = [](double f, double e1, double e2) {
    return rule("bruggeman").mixed(std::vector<MixingPart>{{f, e1}, {1.0 - f, e2}}, 0);
  };
  CHECK(mixed(0.5, 2.25, 1.0).real() ==
        Approx((0.5 * 3.25 + std::sqrt(0.25 * 3.25 * 3.25 + 8 * 2.25)) / 4));
  CHECK(mixed(0.5, 2.25, 1.0).imag() == Approx(0.0).margin(1e-12));
  CHECK(mixed(0.5, -4.0, 2.0).imag() > 1.0);
  CHECK(mixed(0.99, -4.0, 2.0).real() == Approx(-4.0).margin(0.15));
  CHECK(mixed(0.01, -4.0, 2.0).real() == Approx(2.0).margin(0.15));
}

// A crossed branch would show as a jump many times the typical step.
TEST_CASE("Bruggeman of real metals is continuous in wavelength", "[index_mixture]") {
  const IndexTablePtr table = mixed_index({{find_index_table("main/Au/Johnson"), 0.6},
                                           {find_index_table("main/Ag/Johnson"), 0.2},
                                           {find_index_table("main/Cu/Johnson"), 0.2}},
                                          rule("bruggeman"), 0, {});
  ComplexIndex last = table->at(300.0);
  for (double nm = 300.1; nm < 1900.0; nm += 0.1) {
    const ComplexIndex index = table->at(nm);
    if (std::hypot(index.n - last.n, index.k - last.k) > 0.01) FAIL_CHECK(nm);
    if (!(index.n > 0.0 && index.k > 0.0)) FAIL_CHECK(nm << " nm: " << index.n << " " << index.k);
    last = index;
  }
}

TEST_CASE("Maxwell Garnett: few spheres in a host", "[index_mixture]") {
  // Equation 2 of Sihvola, Electromagnetic Mixing Formulas (1999), section 3.1.
  const Permittivity host(2.25, 0.0), gold(-5.0, 2.0);
  const double f = 0.05;
  const Permittivity expected =
      host + 3.0 * f * host * (gold - host) / (gold + 2.0 * host - f * (gold - host));
  const std::vector<MixingPart> parts{{f, gold}, {1.0 - f, host}};
  CHECK(std::abs(rule("maxwell-garnett").mixed(parts, 1) - expected) < 1e-13);
}

// Wiener 1912 and Hashin-Shtrikman: for real parts every rule lies between the harmonic mean and
// the mean.
TEST_CASE("rules keep to Wiener's bounds", "[index_mixture]") {
  std::mt19937 random(4);
  for (const std::string& name : Registry<MixingRule>::instance().names()) {
    for (int i = 0; i < 1000; ++i) {
      const double f = number(random, 0, 1), a = number(random, 1, 20), b = number(random, 1, 20);
      const std::vector<MixingPart> parts{{f, a}, {1.0 - f, b}};
      const double mixed = rule(name).mixed(parts, 0).real();
      const double upper = f * a + (1.0 - f) * b, lower = 1.0 / (f / a + (1.0 - f) / b);
      if (mixed < lower * (1 - 1e-12) || mixed > upper * (1 + 1e-12)) FAIL_CHECK(name << mixed);
    }
  }
}

TEST_CASE("the square of an index and back", "[index_mixture]") {
  std::mt19937 random(5);
  for (int i = 0; i < 1000; ++i) {
    const ComplexIndex index{std::pow(10.0, number(random, -4, 2)),
                             std::pow(10.0, number(random, -4, 2))};
    const ComplexIndex back = index_of(permittivity_of(index));
    CHECK(back.n == Approx(index.n).epsilon(1e-13));
    CHECK(back.k == Approx(index.k).epsilon(1e-13));
  }
  CHECK(index_of({0.0, 0.0}).n == 0.0);
  CHECK(index_of({-4.0, 0.0}).k == 2.0);
  CHECK(index_of({-4.0, 0.0}).n == 0.0);
}

TEST_CASE("mixtures: range, provenance and bad parts", "[index_mixture]") {
  const IndexTablePtr glass = find_index_table("specs/SCHOTT-optical/N-BK7");
  const IndexTablePtr gold = find_index_table("main/Au/Johnson");
  const IndexTablePtr mixed = mixed_index({{gold, 0.1}, {glass, 0.9}}, rule("maxwell-garnett"), 1,
                                          {"ruby", "", "", "", ""});
  CHECK(mixed->range().min_nm == glass->range().min_nm);
  CHECK(mixed->range().max_nm == gold->range().max_nm);
  CHECK(mixed->has_k());
  CHECK(mixed->provenance().name == "ruby");
  CHECK(mixed->at(100.0).n == mixed->at(mixed->range().min_nm).n);  // the end value is held
  const auto one_value = [](double nm) {
    return index_from_spectra(table_spectrum({nm, nm + 10.0}, {1.0, 1.0}, ""), nullptr,
                              {"x", "", "", "", ""});
  };
  CHECK_THROWS_AS(
      mixed_index({{one_value(300), 0.5}, {one_value(500), 0.5}}, rule("linear"), 0, {}),
      InputError);
  const IndexTablePtr gain = constant_index({1.0, -0.5});
  CHECK_THROWS_AS(mixed_index({{gain, 1.0}}, rule("linear"), 0, {})->at(500.0), InputError);
  // Spheres of permittivity -2 in vacuum resonate without loss.
  const IndexTablePtr pole =
      mixed_index({{constant_index({0.0, std::sqrt(2.0)}), 0.1}, {constant_index({1.0, 0.0}), 0.9}},
                  rule("maxwell-garnett"), 1, {});
  const double resonance = std::abs(pole->at(500.0).n) + pole->at(500.0).k;
  CHECK(std::isfinite(resonance));
}

TEST_CASE("between tables: ends, middle and neighbours", "[index_mixture]") {
  const std::vector<IndexAtValue> tables{{constant_index({1.0, 4.0}), 0.0},
                                         {constant_index({2.0, 3.0}), 1.0},
                                         {constant_index({6.0, 1.0}), 3.0}};
  const auto at = [&](double value) { return index_between(tables, value, {})->at(500.0); };
  CHECK(at(0.0).n == Approx(1.0));
  // (1 + 4i)^2 = -15 + 8i and (2 + 3i)^2 = -5 + 12i.
  CHECK(permittivity_of(at(0.25)).real() == Approx(-12.5));
  CHECK(permittivity_of(at(0.25)).imag() == Approx(9.0));
  CHECK(at(1.0).n == Approx(2.0));
  CHECK(permittivity_of(at(2.0)).real() == Approx(15.0));  // -5 and 35
  CHECK(at(3.0).k == Approx(1.0));
  CHECK_THROWS_AS(at(3.01), std::invalid_argument);
  CHECK_THROWS_AS(at(-0.01), std::invalid_argument);
}

Lab lab(const IndexTable& table) { return lab_of_xyz(*normal_colour(table), white_xyz("D65")); }

std::string rioux(int gold) {
  return "other/Au-Ag/Rioux-Au" + std::to_string(gold) + "Ag" + std::to_string(100 - gold);
}

// What docs/alloys_and_layers.md states: leaving out one measured composition and going between its
// neighbours is far nearer to the measurement than any effective medium of the pure metals.
TEST_CASE("gold and silver: neighbours predict a measured alloy, effective media do not",
          "[index_mixture]") {
  double between = 0.0, bruggeman = 0.0, linear = 0.0;
  for (int gold = 10; gold <= 90; gold += 10) {
    const IndexTablePtr measured = find_index_table(rioux(gold));
    const double share = gold / 100.0;
    const IndexTablePtr neighbours =
        index_between({{find_index_table(rioux(gold - 10)), share - 0.1},
                       {find_index_table(rioux(gold + 10)), share + 0.1}},
                      share, {});
    // Gold and silver have the same atomic volume to 1 %: by atoms is by volume.
    const std::vector<MixturePart> parts{{find_index_table(rioux(100)), share},
                                         {find_index_table(rioux(0)), 1.0 - share}};
    const auto error = [&](const IndexTablePtr& table) {
      return delta_e_2000(lab(*table), lab(*measured));
    };
    const double b = error(mixed_index(parts, rule("bruggeman"), 0, {}));
    const double l = error(mixed_index(parts, rule("linear"), 0, {}));
    const double n = error(neighbours);
    UNSCOPED_INFO(gold << " % gold: neighbours " << n << ", bruggeman " << b << ", linear " << l);
    between = std::max(between, n);
    bruggeman = std::max(bruggeman, b);
    linear = std::max(linear, l);
  }
  CHECK(between < 0.35);
  CHECK(bruggeman == Approx(4.19).margin(0.02));
  CHECK(linear == Approx(3.55).margin(0.02));
}

TEST_CASE("elements by symbol and by the name of their table", "[index_mixture]") {
  REQUIRE(find_element("Au"));
  CHECK(find_element("Au")->density_g_cm3 == 19.3);
  CHECK(find_element("Cu")->atomic_mass == 63.546);
  CHECK(element_of_table("main/Ag/Johnson")->symbol == "Ag");
  CHECK(element_of_table("main/Ag/nk/Johnson.yml")->symbol == "Ag");
  for (const char* none : {"", "main", "main/SiO2/Malitson", "Au", "a/~/b", "my/metal.yml"}) {
    CHECK(!element_of_table(none));
  }
  CHECK(!find_element("Xx"));
  // Volumes of atoms, M / density: gold and silver are alike, copper is 30 % smaller.
  const auto volume = [](const char* symbol) {
    const Element e = *find_element(symbol);
    return e.atomic_mass / e.density_g_cm3;
  };
  CHECK(volume("Ag") / volume("Au") == Approx(1.0).margin(0.01));
  CHECK(volume("Cu") / volume("Au") == Approx(0.695).margin(0.005));
}

}  // namespace
}  // namespace karat
