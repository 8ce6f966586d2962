#include "materials/index/index_table.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "materials/index/index_coverage.h"
#include "spectral/support/error.h"

using namespace karat;
using Catch::Contains;

namespace {

IndexTablePtr two_point_table() {
  return index_from_spectra(table_spectrum({400.0, 700.0}, {1.0, 2.5}, "n"),
                            table_spectrum({300.0, 600.0}, {3.0, 6.0}, "k"),
                            {"test/two/points", "", "", "", ""});
}

}  // namespace

TEST_CASE("a constant index holds at every wavelength", "[index]") {
  const auto table = constant_index({1.5, 0.25});
  for (const double nm : {0.0, 1e-3, 550.0, 1e9}) {
    CHECK(table->at(nm).n == 1.5);
    CHECK(table->at(nm).k == 0.25);
  }
  CHECK(require_coverage(*table, {1.0, 1e9}, RangePolicy::kError).empty());
  CHECK(table->provenance().name == "n = 1.5, k = 0.25");
}

TEST_CASE("n and k from spectra count on their joint range and are held outside", "[index]") {
  const auto table = two_point_table();
  CHECK(table->range().min_nm == 400.0);
  CHECK(table->range().max_nm == 600.0);
  CHECK(table->has_k());
  CHECK(table->at(500.0).n == Approx(1.5).epsilon(1e-14));
  CHECK(table->at(500.0).k == Approx(5.0).epsilon(1e-14));
  CHECK(table->at(100.0).k == table->at(400.0).k);
  CHECK(table->at(700.0).n == table->at(600.0).n);
  CHECK_FALSE(index_from_spectra(constant_spectrum(1.5), nullptr, {})->has_k());
  CHECK_THROWS_AS(index_from_spectra(table_spectrum({1.0, 2.0}, {1.0, 1.0}, "n"),
                                     table_spectrum({3.0, 4.0}, {1.0, 1.0}, "k"), {}),
                  InputError);
}

TEST_CASE("the lattice holds the values at its wavelengths", "[index]") {
  const auto table = two_point_table();
  const WavelengthLattice lattice({420.0, 580.0});
  const LatticeIndex index = on_lattice(*table, lattice);
  for (int phase = 0; phase < kPhases; ++phase) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const double nm = lattice.wavelength_nm(lane, phase);
      CHECK(index.n[phase][lane] == Approx(1.0 + (nm - 400.0) / 200.0).epsilon(1e-6));
      CHECK(index.k[phase][lane] == Approx(nm / 100.0).epsilon(1e-6));
    }
  }
}

TEST_CASE("negative values reach no reflection model", "[index]") {
  CHECK_THROWS_WITH(on_lattice(*constant_index({1.5, -0.1}), WavelengthLattice()),
                    Contains("k = -0.1") && Contains("380.3906 nm") && Contains("k >= 0"));
  CHECK_THROWS_AS(on_lattice(*constant_index({-1.5, 0.1}), WavelengthLattice()), InputError);
  CHECK_NOTHROW(on_lattice(*constant_index({0.0, 0.0}), WavelengthLattice()));
}

TEST_CASE("a gap in the range is an error, or a warning where the scene allows it", "[index]") {
  const auto table = two_point_table();
  CHECK(require_coverage(*table, {400.0, 600.0}, RangePolicy::kError).empty());
  CHECK(require_coverage(*table, {400.0 * (1 - 1e-15), 600.0}, RangePolicy::kError).empty());
  CHECK_THROWS_WITH(require_coverage(*table, kVisible, RangePolicy::kError),
                    Contains("\"test/two/points\"") && Contains("400 to 600 nm") &&
                        Contains("380 to 780 nm") && !Contains("clamp"));
  CHECK_THAT(require_coverage(*table, {500.0, 600.1}, RangePolicy::kClamp),
             Contains("400 to 600 nm") && Contains("600.1") && Contains("held"));
}

TEST_CASE("the ends of a range may lack what rounding took, no more", "[index]") {
  // 3.2627 and 1.5896 eV are meant to be 380 and 780 nm.
  CHECK(is_covered({380.0052, 779.9903}, kVisible));
  CHECK(is_covered({380.0002, 780.0005}, kVisible));
  CHECK_FALSE(is_covered({380.011, 780.0}, kVisible));
  CHECK_FALSE(is_covered({380.0, 779.989}, kVisible));
  CHECK_FALSE(is_covered({0.108, 1.0}, {0.1, 1.0}));  // for X-rays a hundredth of a nm is much
  CHECK(is_covered({0.100001, 1.0}, {0.1, 1.0}));
  const auto n = table_spectrum({380.0052, 779.9903}, {1.0, 2.0}, "n");
  const auto table = index_from_spectra(n, nullptr, {});
  CHECK(require_coverage(*table, kVisible, RangePolicy::kError).empty());
  CHECK(table->at(380.0).n == 1.0);
  CHECK(covers_wavelength(*table, 780.0));
}
