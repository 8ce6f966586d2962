// The approximations once more, from their papers' formulas and in complex amplitudes, against what
// the renderer computes in float and the command line in double.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

#include "materials/fresnel_eval.h"
#include "tests/reference_fresnel.h"

using namespace karat;

namespace {

double exact(double n, double k, double c) { return reference::fresnel(n, k, c).unpolarised(); }
double f0_of(double n, double k) { return exact(n, k, 1.0); }
double schlick(double f0, double c) { return f0 + (1.0 - f0) * std::pow(1.0 - c, 5.0); }

double large_nk(double n, double k, double c) {
  const double q = n * n + k * k;
  const double s = (q - 2 * n * c + c * c) / (q + 2 * n * c + c * c);
  const double p = (q * c * c - 2 * n * c + 1) / (q * c * c + 2 * n * c + 1);
  return (s + p) / 2;
}

// 1/(mu (1 - mu)^6) = 17.6513846 for mu = 1/7.
double f82(double n, double k, double c, bool clamped) {
  const double f0 = f0_of(n, k), s = schlick(f0, 1.0 / 7.0);
  const double wanted = clamped ? std::min(exact(n, k, 1.0 / 7.0), s) : exact(n, k, 1.0 / 7.0);
  const double b = (s - wanted) * (std::pow(7.0, 7.0) / std::pow(6.0, 6.0));
  const double r = schlick(f0, c) - b * c * std::pow(1.0 - c, 6.0);
  return clamped ? std::clamp(r, 0.0, 1.0) : r;
}

double table(double n, double k, double c, double angles) {
  const double last = angles - 1.0, x = last * 4.0 * c / (1.0 + 3.0 * c);
  const double below = std::min(std::floor(x), last - 1.0);
  const auto node = [&](double j) { return exact(n, k, (j / last) / (4.0 - 3.0 * j / last)); };
  return node(below) + (x - below) * (node(below + 1.0) - node(below));
}

struct Formula {
  std::string model;
  std::function<double(double n, double k, double c)> value;
  std::vector<double> values = {};  // of free parameters
};

const std::vector<Formula>& formulas() {
  static const std::vector<Formula> all{
      {"exact", exact},
      {"schlick-n",
       [](double n, double, double c) {
         return ((n - 1) * (n - 1) + 4 * n * std::pow(1 - c, 5)) / ((n + 1) * (n + 1));
       }},
      {"schlick", [](double n, double k, double c) { return schlick(f0_of(n, k), c); }},
      {"lazanyi",
       [](double n, double k, double c) {
         return ((n - 1) * (n - 1) + 4 * n * std::pow(1 - c, 5) + k * k) /
                ((n + 1) * (n + 1) + k * k);
       }},
      {"large-nk", large_nk},
      {"cook-torrance-n",
       [](double n, double k, double c) {
         const double root = std::sqrt(f0_of(n, k));
         return exact((1 + root) / (1 - root), 0.0, c);
       }},
      {"cook-torrance-k",
       [](double n, double k, double c) {
         const double f0 = f0_of(n, k);
         return exact(1.0, 2 * std::sqrt(f0 / (1 - f0)), c);
       }},
      {"gulbrandsen",
       [](double n, double k, double c) {
         const double r = f0_of(n, k), root = std::sqrt(r), g = 0.6;
         const double m = g * (1 - r) / (1 + r) + (1 - g) * (1 + root) / (1 - root);
         const double k2 = (r * (m + 1) * (m + 1) - (m - 1) * (m - 1)) / (1 - r);
         return exact(m, std::sqrt(k2), c);
       },
       {0.6}},
      {"hoffman-f82", [](double n, double k, double c) { return f82(n, k, c, false); }},
      {"schlick-exponent",
       [](double n, double k, double c) {
         const double f0 = f0_of(n, k);
         return f0 + (0.9 - f0) * std::pow(1 - c, 3.7);
       },
       {3.7, 0.9}},
      {"lazanyi-compensated",
       [](double n, double k, double c) {
         return schlick(f0_of(n, k), c) - 0.4 * c * std::pow(1 - c, 4.0);
       },
       {0.4, 4.0}},
      {"lazanyi-compensated-metal",
       [](double n, double k, double c) {
         return schlick(f0_of(n, k), c) - 1.2 * c * std::pow(1 - c, 6.0);
       },
       {1.2, 6.0}},
      {"table", [](double n, double k, double c) { return table(n, k, c, 16.0); }},
      {"table", [](double n, double k, double c) { return table(n, k, c, 2.0); }, {2.0}},
      {"table", [](double n, double k, double c) { return table(n, k, c, 93.0); }, {93.0}},
      // A material without colour is the same in every channel.
      {"rgb-exact-average", exact},
      {"rgb-exact-650-550-450", exact},
      {"rgb-exact-611-549-464", exact},
      {"rgb-schlick", [](double n, double k, double c) { return schlick(f0_of(n, k), c); }},
      {"rgb-f82", [](double n, double k, double c) { return f82(n, k, c, true); }}};
  return all;
}

const FresnelModel& model(const std::string& name) {
  const FresnelModel* found = Registry<FresnelModel>::instance().find(name);
  REQUIRE(found != nullptr);
  return *found;
}

}  // namespace

// Indices as metals and glasses have them in the visible. The requirement is 1e-6 in float.
TEST_CASE("every approximation is its paper's formula", "[fresnel]") {
  std::mt19937_64 generator(21);
  std::uniform_real_distribution<double> uniform;
  std::vector<FresnelQuery> queries;
  for (int i = 0; i < 300; ++i) {
    const double n = 0.05 * std::pow(120.0, uniform(generator));
    const double k = i % 5 == 0 ? 0.0 : 0.3 * std::pow(40.0, uniform(generator));
    // A dielectric thinner than its exterior is left to the exact model's own tests.
    for (int j = 0; j < 5; ++j) {
      queries.push_back({k == 0.0 ? 1.0 + n : n, k, 90.0 * uniform(generator), 1.0});
    }
  }
  for (const Formula& formula : formulas()) {
    double worst = 0.0, worst_double = 0.0;
    const FresnelModel& m = model(formula.model);
    const auto in_float = evaluate_fresnel(m, queries, FresnelPrecision::kFloat, formula.values);
    const auto in_double = evaluate_fresnel(m, queries, FresnelPrecision::kDouble, formula.values);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const auto& q = queries[i];
      const double c = std::sin(reference::radians(90.0 - q.theta_deg));
      const double expected = formula.value(q.n, q.k, c);
      worst = std::max(worst, std::abs(in_float[i].unpolarised - expected));
      worst_double = std::max(worst_double, std::abs(in_double[i].unpolarised - expected));
    }
    CAPTURE(formula.model, worst, worst_double);
    CHECK(worst <= 1e-6);
    CHECK(worst_double <= 1e-11);
  }
}

TEST_CASE("every model has its formula in this test, or one of its own", "[fresnel]") {
  for (const std::string& name : Registry<FresnelModel>::instance().names()) {
    if (name == "fresnel-decomposition") continue;  // fresnel_basis_test.cpp
    bool found = false;
    for (const Formula& formula : formulas()) found |= formula.model == name;
    CAPTURE(name);
    CHECK(found);
  }
}

TEST_CASE("the approximations agree with tabulated values within 1e-6", "[fresnel]") {
  const std::filesystem::path file = std::filesystem::path(KARAT_TEST_REFERENCE_DIR) /
                                     "reference/fresnel_approximations_public.json";
  if (!std::filesystem::exists(file)) {
    WARN("skipped: no reference folder");
    return;
  }
  std::ifstream in(file);
  const auto check = [](const std::string& name, const nlohmann::json& c, double expected,
                        const std::vector<double>& values = {}) {
    const std::vector<FresnelQuery> query{{c["n"], c["k"], c["theta_deg"], 1.0}};
    const auto at = [&](FresnelPrecision precision) {
      return evaluate_fresnel(model(name), query, precision, values)[0].unpolarised;
    };
    CAPTURE(name, c["label"].get<std::string>(), query[0].theta_deg);
    CHECK(std::abs(at(FresnelPrecision::kDouble) - expected) <= 1e-12);
    CHECK(std::abs(at(FresnelPrecision::kFloat) - expected) <= 1e-6);
  };
  for (const auto& c : nlohmann::json::parse(in).at("cases")) {
    check("schlick", c, c["schlick_F0"]);
    check("lazanyi", c, c["lazanyi_rescaled"]);
    check("schlick-n", c, c["schlick_real_4n"]);
    for (const auto& [key, value] : c["lazanyi_compensated"].items()) {
      double a = 0.0, alpha = 0.0;
      REQUIRE(std::sscanf(key.c_str(), "a=%lf,alpha=%lf", &a, &alpha) == 2);
      check("lazanyi-compensated", c, value, {a, alpha});
      check("lazanyi-compensated-metal", c, value, {a, alpha});
    }
    check("hoffman-f82", c, c["f82"]);
  }
}

TEST_CASE("the models are exact where they claim to be", "[fresnel]") {
  const auto difference = [](const std::string& name, double n, double k, double c) {
    return std::abs(model(name).evaluate({n, k}, c).unpolarised - exact(n, k, c));
  };
  for (const auto& [n, k] : {std::pair{0.42, 2.40},
                             {0.96, 6.69},
                             {2.95, 2.93},
                             {1.5, 0.0},
                             // Below the n that a tint of 1 gives: no metal, but an index.
                             {0.21, 0.51},
                             {0.7, 0.0}}) {
    CAPTURE(n, k);
    for (const std::string& name : Registry<FresnelModel>::instance().names()) {
      CAPTURE(name);
      if (name != "schlick-n" || k == 0.0) CHECK(difference(name, n, k, 1.0) <= 1e-12);
      CHECK(model(name).evaluate({n, k}, 0.0).unpolarised == Approx(1.0).margin(1e-12));
    }
    CHECK(difference("hoffman-f82", n, k, 1.0 / 7.0) <= 1e-12);
    for (int j = 0; j < 16; ++j) {
      const double u = j / 15.0;
      CHECK(difference("table", n, k, u / (4.0 - 3.0 * u)) <= 1e-12);
    }
    // One edge tint for a material of one index: only another name for it. Next to a critical angle
    // a k of 0 comes back as the root of a rounding.
    const double name_only = k == 0.0 && n < 1.0 ? 1e-7 : 1e-9;
    for (const double c : {0.05, 0.3, 0.8}) {
      CHECK(difference("gulbrandsen", n, k, c) <= name_only);
    }
  }
  for (const double c : {0.05, 0.3, 0.8}) {
    CHECK(difference("cook-torrance-n", 1.7, 0.0, c) <= 1e-12);
    CHECK(difference("cook-torrance-k", 1.0, 3.1, c) <= 1e-12);
    CHECK(difference("large-nk", 200.0, 300.0, c) <= 1e-5);
  }
}
