#include "materials/fresnel_study/fresnel_fit.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "apps/karat/fresnel/study_options.h"
#include "materials/fresnel_study/fresnel_fit_material.h"
#include "materials/index/index_catalogue.h"
#include "spectral/support/error.h"
#include "tests/reference_fresnel.h"

using namespace karat;

namespace {

const FresnelModel& model(const std::string& name) {
  return *Registry<FresnelModel>::instance().find(name);
}

std::vector<double> cosines() {
  std::vector<double> c;
  for (int degrees = 0; degrees < 90; ++degrees) c.push_back(std::cos(degrees * M_PI / 180.0));
  return c;
}

// Reflectances that the model itself has with these values.
FresnelData synthetic(const FresnelModel& m, std::vector<ComplexIndex> indices,
                      const std::vector<double>& values) {
  FresnelData data{std::move(indices), cosines(), {}};
  for (const ComplexIndex& index : data.indices) {
    for (const double c : data.cosines)
      data.reflectances.push_back(m.evaluate_with(index, c, values));
  }
  return data;
}

// Twelve metals at three wavelengths, each by itself and all three together.
std::vector<std::vector<ComplexIndex>> measured_metals() {
  std::vector<std::vector<ComplexIndex>> all;
  for (const std::string& name : usual_study_tables()) {
    std::vector<ComplexIndex> together;
    for (const double nm : {400.0, 500.0, 700.0}) {
      together.push_back(find_index_table(name)->at(nm));
      all.push_back({together.back()});
    }
    all.push_back(together);
  }
  return all;
}

// Values over a parameter's range, close to one another where metals have theirs.
std::vector<double> spread_values(const FresnelParameter& info) {
  if (info.min > 0.0) return {1.0, 1.7, 3.1, 5.0, 7.3, 15.0, 41.0, 100.0};
  if (info.min < 0.0) return {info.min, -0.7, -0.05, 0.0, 0.02, 0.3, 1.2, info.max};
  return {0.0, 0.3, 0.7, 0.89, 0.97, 0.995, 0.9999, info.max};
}

const ComplexIndex kGold{0.42, 2.40}, kAluminium{0.96, 6.69}, kIron{2.95, 2.93};

}  // namespace

TEST_CASE("a fit recovers the parameters that its data were made with", "[fresnel_fit]") {
  struct Case {
    const char* name;
    std::vector<double> values;
  };
  for (const Case& c :
       {Case{"lazanyi-compensated", {0.37, 4.3}}, Case{"lazanyi-compensated-metal", {1.1, 6.5}},
        Case{"schlick-exponent", {3.7, 0.9}}, Case{"hoffman-f82", {0.72}},
        Case{"gulbrandsen", {0.8}}, Case{"fresnel-decomposition", {0.06, -0.03}}}) {
    for (const auto& indices :
         {std::vector{kGold}, std::vector{kIron}, std::vector{kGold, kAluminium, kIron}}) {
      const FresnelData data = synthetic(model(c.name), indices, c.values);
      const FresnelFit fit = fit_fresnel(model(c.name), data);
      CAPTURE(c.name, indices.size(), fit.rms_error);
      REQUIRE(fit.values.size() == c.values.size());
      for (std::size_t p = 0; p < fit.values.size(); ++p) {
        CHECK(fit.values[p] == Approx(c.values[p]).epsilon(1e-5));
      }
      CHECK(fit.max_abs_error <= 1e-7);
    }
  }
}

TEST_CASE("the residual of a fit is what its formula leaves", "[fresnel_fit]") {
  const FresnelFit fit =
      fit_fresnel(model("lazanyi-compensated"), exact_data({kGold, kAluminium}, cosines()));
  double largest = 0.0, squares = 0.0;
  for (const auto& [n, k] : {kGold, kAluminium}) {
    const double f0 = reference::fresnel(n, k, 1.0).unpolarised();
    for (const double c : cosines()) {
      const double approximated = f0 + (1.0 - f0) * std::pow(1.0 - c, 5.0) -
                                  fit.values[0] * c * std::pow(1.0 - c, fit.values[1]);
      const double error = approximated - reference::fresnel(n, k, c).unpolarised();
      largest = std::max(largest, std::abs(error));
      squares += error * error;
    }
  }
  CHECK(fit.max_abs_error == Approx(largest).margin(1e-12));
  CHECK(fit.rms_error == Approx(std::sqrt(squares / 180.0)).margin(1e-12));
}

TEST_CASE("no point of a fine grid does better than a fit", "[fresnel_fit]") {
  const auto least_on_grid = [](const FresnelModel& m, const FresnelData& data,
                                std::vector<double> first, std::vector<double> last, int steps) {
    double least = 1e30;
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= (first.size() > 1 ? steps : 0); ++j) {
        std::vector<double> values{first[0] + (last[0] - first[0]) * i / steps};
        if (first.size() > 1) values.push_back(first[1] + (last[1] - first[1]) * j / steps);
        least = std::min(least, fresnel_residual(m, data, values).rms_error);
      }
    }
    return least;
  };
  for (const auto& indices : {std::vector{kGold}, std::vector{kAluminium}, std::vector{kIron},
                              std::vector{ComplexIndex{1.5, 0.0}}}) {
    const FresnelData data = exact_data(indices, cosines());
    CAPTURE(indices[0].n, indices[0].k);
    const auto best = [&](const char* name) { return fit_fresnel(model(name), data).rms_error; };
    CHECK(best("lazanyi-compensated") <=
          least_on_grid(model("lazanyi-compensated"), data, {-3.0, 1.0}, {3.0, 25.0}, 120));
    CHECK(best("schlick-exponent") <=
          least_on_grid(model("schlick-exponent"), data, {1.0, 0.0}, {20.0, 1.0}, 120));
    CHECK(best("hoffman-f82") <= least_on_grid(model("hoffman-f82"), data, {0.0}, {1.0}, 2000));
    CHECK(best("gulbrandsen") <= least_on_grid(model("gulbrandsen"), data, {0.0}, {1.0}, 2000));
    CHECK(best("fresnel-decomposition") <=
          least_on_grid(model("fresnel-decomposition"), data, {-0.5, -0.5}, {0.5, 0.5}, 120));
  }
}

// With f90 = 1 there is another minimum, at an exponent of 41, with an RMS error of 0.01818.
TEST_CASE("aluminium's exponent is not the one of a local minimum", "[fresnel_fit]") {
  const FresnelData data = exact_data({find_index_table("main/Al/Rakic")->at(500.0)}, cosines());
  const FresnelFit fit = fit_fresnel(model("schlick-exponent"), data);
  CHECK(fit.values[0] == 1.0);
  CHECK(fit.values[1] == Approx(0.8897).margin(1e-4));
  CHECK(fit.rms_error == Approx(0.0135).margin(1e-5));
}

TEST_CASE("one more fixed parameter never makes a fit better", "[fresnel_fit]") {
  for (const std::string& name : Registry<FresnelModel>::instance().names()) {
    const FresnelModel& m = model(name);
    for (const auto& indices : measured_metals()) {
      if (m.parameters().empty()) continue;
      const FresnelData data = exact_data(indices, cosines());
      const double best = fit_fresnel(m, data).rms_error;
      for (const FresnelParameter& info : m.parameters()) {
        if (info.whole_number) continue;
        for (const double value : spread_values(info)) {
          const FresnelFit fixed = fit_fresnel(m, data, {{info.name, value}});
          CAPTURE(name, indices.size(), indices[0].n, indices[0].k, info.name, value);
          CAPTURE(fixed.values);
          REQUIRE(best <= fixed.rms_error * (1.0 + 1e-9) + 1e-12);
        }
      }
    }
  }
}

// Where the model is not linear the search alone counts: every value of a fine grid, the linear
// parameter at each by the closed form of one column, limited to its range.
TEST_CASE("no exponent of a fine grid does better than the fit", "[fresnel_fit]") {
  for (const auto& indices : measured_metals()) {
    const FresnelData data = exact_data(indices, cosines());
    double least_schlick = 1e30, least_lazanyi = 1e30;
    for (double p = 1.0; p <= 100.0; p *= 1.02) {
      double with_f90[2] = {0.0, 0.0}, with_a[2] = {0.0, 0.0};  // products with the column
      auto wanted = data.reflectances.begin();
      for (const auto& [n, k] : indices) {
        const double f0 = reference::fresnel(n, k, 1.0).unpolarised();
        for (const double c : cosines()) {
          const double power = std::pow(1.0 - c, p), rest = *wanted - f0 * (1.0 - power);
          with_f90[0] += power * rest, with_f90[1] += power * power;
          const double schlick = f0 + (1.0 - f0) * std::pow(1.0 - c, 5.0);
          with_a[0] += c * power * (schlick - *wanted), with_a[1] += c * c * power * power;
          ++wanted;
        }
      }
      const double f90 = std::clamp(with_f90[0] / with_f90[1], 0.0, 1.0);
      const double a = std::clamp(with_a[0] / with_a[1], -100.0, 100.0);
      const auto left = [&](const char* name, std::vector<double> values) {
        return fresnel_residual(model(name), data, std::move(values)).rms_error;
      };
      least_schlick = std::min(least_schlick, left("schlick-exponent", {p, f90}));
      least_lazanyi = std::min(least_lazanyi, left("lazanyi-compensated", {a, p}));
    }
    CAPTURE(indices.size(), indices[0].n, indices[0].k);
    CHECK(fit_fresnel(model("schlick-exponent"), data).rms_error <= least_schlick + 1e-12);
    CHECK(fit_fresnel(model("lazanyi-compensated"), data).rms_error <= least_lazanyi + 1e-12);
  }
}

TEST_CASE("no edge tint of a fine grid does better for a metal than the fit", "[fresnel_fit]") {
  for (const auto& indices : measured_metals()) {
    const FresnelData data = exact_data(indices, cosines());
    const double best = fit_fresnel(model("gulbrandsen"), data).rms_error;
    CAPTURE(indices.size(), indices[0].n, indices[0].k);
    for (double x = 0.0; x <= 20.0; x += 0.05) {
      const double below =
          fresnel_residual(model("gulbrandsen"), data, {1.0 - std::exp(-x)}).rms_error;
      const double above =
          fresnel_residual(model("gulbrandsen"), data, {1.0 + std::exp(-x)}).rms_error;
      REQUIRE(best <= std::min(below, above) + 1e-12);
    }
  }
}

TEST_CASE("a fit never does worse than what the model chooses", "[fresnel_fit]") {
  for (const std::string& name : Registry<FresnelModel>::instance().names()) {
    const FresnelModel& m = model(name);
    if (m.parameters().empty()) continue;
    for (const ComplexIndex index : {kGold, kAluminium, kIron, ComplexIndex{0.05, 3.3}}) {
      const FresnelData data = exact_data({index}, cosines());
      const FresnelFit fit = fit_fresnel(m, data);
      CAPTURE(name, index.n, index.k);
      CHECK(fit.rms_error <= fresnel_residual(m, data, m.chosen(index)).rms_error);
      const auto infos = m.parameters();
      REQUIRE(fit.values.size() == infos.size());
      for (std::size_t p = 0; p < infos.size(); ++p) {
        CHECK_FALSE(infos[p].description.empty());
        CHECK((fit.values[p] >= infos[p].min && fit.values[p] <= infos[p].max));
      }
    }
  }
}

// And so are a and alpha, to which a golden-section search over alpha comes by another way: the
// best a is linear in the errors.
TEST_CASE("the compensation that lazanyi-compensated chooses is the least-squares one",
          "[fresnel_fit]") {
  std::vector<double> own;
  for (int j = 0; j < 64; ++j) own.push_back(std::cos((j + 0.5) / 64 * M_PI / 2));
  for (const ComplexIndex index : {kGold, kAluminium, kIron, ComplexIndex{0.05, 3.3}}) {
    const double f0 = reference::fresnel(index.n, index.k, 1.0).unpolarised();
    const auto strength = [&](double alpha) {
      double product = 0.0, square = 0.0;
      for (const double c : own) {
        const double b = c * std::pow(1.0 - c, alpha);
        const double rescaled = f0 + (1.0 - f0) * std::pow(1.0 - c, 5.0);
        product += b * (rescaled - reference::fresnel(index.n, index.k, c).unpolarised());
        square += b * b;
      }
      return std::pair{product / square, product * product / square};
    };
    const std::vector<double> chosen = model("lazanyi-compensated").chosen(index);
    CAPTURE(index.n, index.k, chosen[0], chosen[1]);
    double low = 0.98 * chosen[1], high = 1.02 * chosen[1];
    for (int i = 0; i < 100; ++i) {
      const double a = high - (high - low) / 1.618033988749895, b = low + high - a;
      (strength(a).second > strength(b).second ? high : low) =
          strength(a).second > strength(b).second ? b : a;
    }
    // The sum is flat to rounding within a ten-millionth of its maximum.
    CHECK(chosen[1] == Approx(0.5 * (low + high)).epsilon(3e-7));
    CHECK(chosen[0] == Approx(strength(chosen[1]).first).epsilon(1e-10));
    CHECK(strength(chosen[1]).second >= strength(0.5 * (low + high)).second * (1.0 - 1e-14));
  }
}

// The exponent that the model chooses with F90 = 1 is the one that the fit finds, over the model's
// own angles.
TEST_CASE("the exponent that schlick-exponent chooses is the least-squares one", "[fresnel_fit]") {
  std::vector<double> own;
  for (int j = 0; j < 64; ++j) own.push_back(std::cos((j + 0.5) / 64 * M_PI / 2));
  for (const ComplexIndex index : {kGold, kAluminium, kIron, ComplexIndex{1.5, 0.0}}) {
    const FresnelModel& m = model("schlick-exponent");
    const FresnelFit fit = fit_fresnel(m, exact_data({index}, own), {{"f90", 1.0}});
    CAPTURE(index.n, index.k);
    CHECK(fit.values[1] == 1.0);
    CHECK(m.chosen(index)[0] == Approx(fit.values[0]).epsilon(1e-5));
  }
}

TEST_CASE("a fit refuses unknown and impossible fixed values", "[fresnel_fit]") {
  const FresnelData data = exact_data({kGold}, cosines());
  CHECK_THROWS_AS(fit_fresnel(model("schlick-exponent"), data, {{"exponnt", 5.0}}), InputError);
  CHECK_THROWS_AS(fit_fresnel(model("schlick-exponent"), data, {{"f90", 1.5}}), InputError);
  CHECK_THROWS_AS(fit_fresnel(model("table"), data, {{"angles", 7.5}}), InputError);
  CHECK_THROWS_AS(fit_fresnel(model("table"), data, {{"angles", 1.0}}), InputError);
  CHECK(fit_fresnel(model("table"), data, {{"angles", 7.0}}).values == std::vector<double>{7.0});
  CHECK(fit_fresnel(model("table"), data).values == std::vector<double>{16.0});
  const FresnelFit fixed =
      fit_fresnel(model("schlick-exponent"), data, {{"f90", 1.0}, {"exponent", 5.0}});
  CHECK(fixed.values == std::vector<double>{5.0, 1.0});
  CHECK(fixed.rms_error ==
        Approx(fresnel_residual(model("schlick"), data, {}).rms_error).margin(1e-12));
}
