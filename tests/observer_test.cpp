#include "spectral/observer.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "spectral/support/error.h"

using namespace karat;

namespace {

double sum_at_1_nm(const Spectrum& curve, WavelengthRange range) {
  const NanometreGrid grid = nanometre_grid(range);
  double sum = 0.0;
  for (int i = 0; i < grid.count; ++i) sum += curve(grid.first_nm + i);
  return sum;
}

}  // namespace

TEST_CASE("Sums of the observers at 1 nm are those of the standards", "[observer]") {
  struct Sums {
    const char* name;
    double x, y, z;
  };
  // CIE 1931: the sums of CIE 018:2019; CIE 1964: CIE 015:2018, table 6 116.66 for ybar.
  const Sums cie1931{"cie1931", 106.86546949, 106.85691710, 106.89225128};
  const Observer& o = observer(cie1931.name);
  CHECK(sum_at_1_nm(*o.xbar, o.range) == Approx(cie1931.x).epsilon(0).margin(1e-8));
  CHECK(sum_at_1_nm(*o.ybar, o.range) == Approx(cie1931.y).epsilon(0).margin(1e-8));
  CHECK(sum_at_1_nm(*o.zbar, o.range) == Approx(cie1931.z).epsilon(0).margin(1e-8));
  CHECK(o.ybar_integral == Approx(cie1931.y).epsilon(0).margin(1e-8));
  CHECK(o.range.min_nm == 360.0);
  CHECK(o.range.max_nm == 830.0);
  // Every observer is normalised to the same sum for equal energy, within its table's rounding.
  for (const std::string& name : observer_names()) {
    const Observer& any = observer(name);
    INFO(name);
    CHECK(sum_at_1_nm(*any.xbar, any.range) == Approx(any.ybar_integral).epsilon(5e-4));
    CHECK(sum_at_1_nm(*any.zbar, any.range) == Approx(any.ybar_integral).epsilon(5e-4));
  }
  // CIE 170-2 normalises its three curves to equal sums.
  for (const char* name : {"cie2015_2deg", "cie2015_10deg"}) {
    const Observer& equal = observer(name);
    CHECK(sum_at_1_nm(*equal.xbar, equal.range) == Approx(equal.ybar_integral).epsilon(1e-7));
    CHECK(sum_at_1_nm(*equal.zbar, equal.range) == Approx(equal.ybar_integral).epsilon(1e-7));
  }
  CHECK(observer("cie1964").ybar_integral == Approx(116.66).epsilon(0).margin(0.005));
}

TEST_CASE("Observers peak where the standards say", "[observer]") {
  const Observer& o = observer("cie1931");
  CHECK((*o.ybar)(555.0) == Approx(1.0));  // V(lambda)
  CHECK((*o.xbar)(600.0) == Approx(1.0622).epsilon(1e-4));
  CHECK((*o.zbar)(446.0) == Approx(1.7826).epsilon(1e-3));
  CHECK((*observer("cie1964").ybar)(557.0) == Approx(1.0).epsilon(1e-3));
}

// A mistyped digit is a spike of six times the error in the fourth differences. The standards' own
// tables stay below 1 % of the value plus 1e-4 of the peak (the largest: cie1964 xbar at 491 nm),
// so an error of 0.2 % of a value, or of 2e-5 of the peak in the tails, stands out.
TEST_CASE("Observer tables are smooth", "[observer]") {
  for (const std::string& name : observer_names()) {
    const Observer& o = observer(name);
    for (int curve = 0; curve < 3; ++curve) {
      double peak = 0.0;
      for (double nm = o.range.min_nm; nm <= o.range.max_nm; nm += 1.0) {
        peak = std::max(peak, o[curve](nm));
      }
      for (double nm = o.range.min_nm + 2; nm <= o.range.max_nm - 2; nm += 1.0) {
        const Spectrum& f = o[curve];
        const double fourth = f(nm - 2) - 4 * f(nm - 1) + 6 * f(nm) - 4 * f(nm + 1) + f(nm + 2);
        INFO(name << " curve " << curve << " at " << nm << " nm");
        CHECK(std::abs(fourth) <= 0.01 * f(nm) + 1e-4 * peak);
        CHECK(f(nm) >= 0.0);
      }
    }
  }
}

TEST_CASE("Observers are zero outside their range", "[observer]") {
  const Observer& o = observer("cie1931");
  for (int curve = 0; curve < 3; ++curve) {
    CHECK(o[curve](359.9) == 0.0);
    CHECK(o[curve](830.1) == 0.0);
    CHECK(o[curve].mean({300.0, 360.0}) == 0.0);
    CHECK(o[curve].mean({320.0, 400.0}) ==
          Approx(o[curve].mean({360.0, 400.0}) * 0.5).epsilon(1e-12));
  }
}

TEST_CASE("Lattice means of ybar add up to its integral", "[observer]") {
  const Observer& o = observer("cie1931");
  for (const WavelengthRange range : {kVisible, WavelengthRange{360, 830},
                                      WavelengthRange{300, 1000}, WavelengthRange{555, 556}}) {
    const WavelengthLattice lattice(range);
    const LatticeSpectrum means = bin_means(*o.ybar, lattice);
    double lattice_integral = 0.0;
    for (int phase = 0; phase < kPhases; ++phase) {
      for (int lane = 0; lane < kLanes; ++lane) lattice_integral += means[phase][lane];
    }
    lattice_integral *= lattice.bin_width_nm();
    // Trapezoids between whole nanometres are exact for the table itself.
    double integral = 0.0;
    for (double nm = range.min_nm; nm < range.max_nm; nm += 1.0) {
      const bool inside = nm >= o.range.min_nm && nm + 1.0 <= o.range.max_nm;
      if (inside) integral += 0.5 * ((*o.ybar)(nm) + (*o.ybar)(nm + 1.0));
    }
    CHECK(lattice_integral == Approx(integral).epsilon(1e-6));
  }
}

TEST_CASE("An unknown observer is an error that names the known ones", "[observer]") {
  CHECK_THROWS_WITH(observer("cie1932"), Catch::Contains("cie1931") && Catch::Contains("cie1964"));
  CHECK_THROWS_AS(observer("../illuminants/D65"), InputError);
}
