#include "materials/index/index_interpolation.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "materials/index/index_catalogue.h"
#include "materials/index/index_rows.h"
#include "render/film_image.h"
#include "render/image_file.h"
#include "spectral/monotone_cubic.h"
#include "tests/scene_text.h"

namespace karat {
namespace {

using Catch::Matchers::Contains;

SpectrumPtr table_of(const std::vector<double>& nm, const std::function<double(double)>& f) {
  std::vector<double> values;
  for (const double at : nm) values.push_back(f(at));
  return table_spectrum(nm, values, "test");
}

std::vector<double> grid(double from, double to, int intervals) {
  std::vector<double> nm;
  for (int i = 0; i <= intervals; ++i) nm.push_back(from + (to - from) * i / intervals);
  return nm;
}

TEST_CASE("the monotone cubic passes through its samples and keeps their range",
          "[index_interpolation]") {
  const SpectrumPtr table = table_spectrum({400, 410, 450, 455}, {1.0, 3.0, 2.5, 2.5}, "test");
  const SpectrumPtr cubic = monotone_cubic(table);
  for (const auto& sample : table->samples()) CHECK((*cubic)(sample.nm) == sample.value);
  CHECK(cubic->range().min_nm == 400.0);
  CHECK(cubic->range().max_nm == 455.0);
  CHECK((*cubic)(300.0) == 1.0);
  CHECK((*cubic)(900.0) == 2.5);
  CHECK(cubic->samples().size() == 4);
  const SpectrumPtr formula = constant_spectrum(2.0);
  CHECK(monotone_cubic(formula) == formula);
}

// Steffen's parabola gives the exact slope of a parabola, and two exact slopes the exact cubic.
TEST_CASE("the monotone cubic reproduces a parabola away from its vertex",
          "[index_interpolation]") {
  const auto parabola = [](double nm) { return 1e-4 * nm * nm - 0.01 * nm; };
  const SpectrumPtr cubic = monotone_cubic(table_of({400, 407, 420, 428, 440, 455, 460}, parabola));
  for (double nm = 400.0; nm <= 460.0; nm += 0.5) {
    INFO(nm);
    CHECK((*cubic)(nm) == Approx(parabola(nm)).epsilon(1e-12));
  }
}

TEST_CASE("the monotone cubic never leaves the interval of two neighbours",
          "[index_interpolation]") {
  const std::vector<double> nm = {1, 2, 2.1, 5, 6, 7, 7.5, 9, 20};
  const SpectrumPtr table = table_spectrum(nm, {0, 0, 10, 10, 11, -3, -3.1, 0.5, 0.4}, "test");
  const SpectrumPtr cubic = monotone_cubic(table);
  const auto samples = table->samples();
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    double last = samples[i].value;
    const double sign = samples[i + 1].value >= samples[i].value ? 1.0 : -1.0;
    for (int step = 1; step <= 50; ++step) {
      const double at = samples[i].nm + (samples[i + 1].nm - samples[i].nm) * step / 50.0;
      const double value = (*cubic)(at);
      CHECK(sign * (value - last) >= -1e-12);
      last = value;
    }
  }
}

TEST_CASE("on a smooth curve the monotone cubic errs less than lines, and has no kinks",
          "[index_interpolation]") {
  const auto edge = [](double nm) { return 1.0 + std::tanh((nm - 520.0) / 40.0); };
  const SpectrumPtr lines = table_of(grid(400, 700, 15), edge);
  const SpectrumPtr cubic = monotone_cubic(lines);
  double worst_lines = 0.0, worst_cubic = 0.0;
  for (double nm = 400.0; nm <= 700.0; nm += 1.0) {
    worst_lines = std::max(worst_lines, std::abs((*lines)(nm)-edge(nm)));
    worst_cubic = std::max(worst_cubic, std::abs((*cubic)(nm)-edge(nm)));
  }
  CHECK(worst_cubic < 0.25 * worst_lines);
  constexpr double kStep = 1e-4;
  for (const auto& sample : lines->samples()) {
    if (sample.nm <= 400.0 || sample.nm >= 700.0) continue;
    const double left = (sample.value - (*cubic)(sample.nm - kStep)) / kStep;
    const double right = ((*cubic)(sample.nm + kStep) - sample.value) / kStep;
    CHECK(left == Approx(right).margin(1e-5));
  }
}

TEST_CASE("where a wavelength is repeated the curve jumps and is not smoothed over",
          "[index_interpolation]") {
  const SpectrumPtr cubic = monotone_cubic(rows_curve({1, 2, 3, 3, 4, 5}, {1, 2, 3, 10, 11, 12}));
  CHECK((*cubic)(3.0) == 10.0);
  CHECK((*cubic)(2.999) == Approx(2.999));
  CHECK((*cubic)(3.001) == Approx(10.001));
  CHECK((*cubic)(2.5) == Approx(2.5));
}

TEST_CASE("a table in another interpolation keeps its rows, range and source",
          "[index_interpolation]") {
  const IndexTablePtr gold = find_index_table("main/Au/Johnson");
  CHECK(interpolated(gold, Interpolation::kLinear) == gold);
  const IndexTablePtr cubic = interpolated(gold, Interpolation::kMonotoneCubic);
  CHECK(cubic->provenance().reference == gold->provenance().reference);
  CHECK(cubic->range().min_nm == gold->range().min_nm);
  CHECK(cubic->range().max_nm == gold->range().max_nm);
  CHECK(gold->n_samples().size() == 49);
  double largest = 0.0;
  for (const auto& row : gold->n_samples()) CHECK(cubic->at(row.nm).n == row.value);
  for (const auto& row : gold->k_samples()) CHECK(cubic->at(row.nm).k == row.value);
  for (double nm = 380.0; nm <= 780.0; nm += 1.0) {
    largest = std::max(largest, std::abs(cubic->at(nm).k - gold->at(nm).k));
  }
  CHECK(largest > 1e-3);  // it is another curve
  CHECK(largest < 0.1);   // but the same gold
  const IndexTablePtr glass = find_index_table("main/SiO2/Malitson");
  CHECK(interpolated(glass, Interpolation::kMonotoneCubic) == glass);
}

TEST_CASE("a scene chooses the interpolation and the image says which", "[index_interpolation]") {
  CHECK_THROWS_WITH(interpolation_named("cubic"), Contains("linear") && Contains("monotone-cubic"));
  nlohmann::json scene = small_scene();
  scene["materials"]["clay"] = {{"type", "conductor"}, {"nk", "main/Au/Johnson"}};
  const auto metadata = [](const nlohmann::json& json) {
    const Scene loaded = load_scene_text(json.dump(), "test.json", "");
    Image image;
    add_provenance(image, loaded, 1, nullptr);
    return image.attributes.at("karat:interpolation");
  };
  CHECK(metadata(scene) == "linear in wavelength on n and k");
  scene["interpolation"] = "monotone-cubic";
  CHECK_THAT(metadata(scene), Contains("monotone cubic") && Contains("Steffen 1990"));
  scene["interpolation"] = "cubic";
  CHECK_THAT(load_error(scene), Contains("/interpolation") && Contains("linear, monotone-cubic"));
}

}  // namespace
}  // namespace karat
