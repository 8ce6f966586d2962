// Measuring costs: kernels of known relative cost come out in their proportion.
#include "materials/fresnel_study/fresnel_cost.h"

#include <catch2/catch.hpp>

#include "materials/index/index_catalogue.h"
#include "spectral/support/error.h"

using namespace karat;

namespace {

// Work that takes `units` times as long as one unit of it: a chain of dependent operations.
CostKernel work(int units) {
  return [units](const std::vector<float>& cosines) {
    float x = 0.0f;
    for (const float c : cosines) {
      for (int i = 0; i < 40 * units; ++i) x = x * 0.5f + c;
    }
    return x;
  };
}

}  // namespace

TEST_CASE("a kernel that does three times the work costs three times as much", "[fresnel_cost]") {
  FresnelCostOptions options;
  options.rounds = 41;
  options.calls = 512;
  const auto costs = measure_costs({{"triple", work(3)}, {"exact", work(1)}}, options);
  REQUIRE(costs.size() == 2);
  CHECK(costs[0].model == "triple");
  // Loops have overhead, and machines are never quite quiet.
  CHECK(costs[0].relative.median == Approx(3.0).epsilon(0.15));
  CHECK(costs[1].relative.median == 1.0);
  CHECK(costs[0].ns.lower <= costs[0].ns.median);
  CHECK(costs[0].ns.median <= costs[0].ns.upper);
}

TEST_CASE("quartiles and median of a sample", "[fresnel_cost]") {
  const CostSpread spread = cost_spread({5.0, 1.0, 3.0, 2.0, 4.0});
  CHECK(spread.lower == 2.0);
  CHECK(spread.median == 3.0);
  CHECK(spread.upper == 4.0);
  CHECK(cost_spread({7.0}).upper == 7.0);
}

TEST_CASE("costs of registered models, and of doing nothing", "[fresnel_cost]") {
  FresnelCostOptions options;
  options.rounds = 21;
  options.calls = 1024;
  const IndexTablePtr gold = find_index_table("main/Au/Johnson");
  const auto costs = fresnel_costs({"schlick"}, *gold, options);
  REQUIRE(costs.size() == 3);
  CHECK(costs[0].model == "schlick");
  CHECK(costs[1].model == "exact");
  CHECK(costs[2].model.empty());
  // In one wavelength's scalar form Schlick is far from the price of exact on any machine; in lanes
  // the call itself weighs more.
  CHECK(costs[0].relative.median < 1.0);
  CHECK(costs[2].ns.median < costs[1].ns.median);
  CHECK(fresnel_single_costs({"schlick"}, *gold, options)[0].relative.median < 0.9);
  CHECK_THROWS_AS(fresnel_costs({"schlik"}, *gold, options), InputError);
}

TEST_CASE("the machine has a name, and flags are known", "[fresnel_cost]") {
  CHECK_FALSE(processor_name().empty());
  CHECK(compiler_flags() != "unknown flags");
  CHECK_FALSE(vector_instructions().empty());
}
