#include "materials/index/index_colour.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "materials/index/index_catalogue.h"

using namespace karat;

TEST_CASE("normal reflectance at the values that need no calculation", "[index][index-colour]") {
  CHECK(normal_reflectance({1.0, 0.0}) == 0.0);
  CHECK(normal_reflectance({1.5, 0.0}) == Approx(0.04).epsilon(1e-14));
  CHECK(normal_reflectance({0.0, 3.0}) == 1.0);
  CHECK(normal_reflectance({1.0, 2.0}) == 0.5);
}

TEST_CASE("colours of metals at normal incidence agree with an independent calculation",
          "[index][index-colour]") {
  const std::filesystem::path file =
      std::filesystem::path(KARAT_TEST_REFERENCE_DIR) / "reference/spectral_colour_public.json";
  if (!std::filesystem::exists(file)) {
    WARN("skipped: no " << file.string());
    return;
  }
  const auto reference = nlohmann::json::parse(std::ifstream(file));
  int compared = 0;
  for (const auto& material : reference["materials"]) {
    const std::string page = material["page"];
    INFO(page);
    const auto table = find_index_table(page);
    const auto xyz = normal_colour(*table);
    REQUIRE(xyz);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(std::abs((*xyz)[i] - material["D65"]["XYZ"][i].get<double>()) < 1e-4);
    }
    for (const auto& [nm, value] : material["R_normal_at_nm"].items()) {
      CHECK(std::abs(normal_reflectance(table->at(std::stod(nm))) - value.get<double>()) < 1e-9);
    }
    ++compared;
  }
  CHECK(compared >= 4);
}

TEST_CASE("a table that leaves the visible has no colour", "[index][index-colour]") {
  CHECK_FALSE(normal_colour(*find_index_table("main/Zn/Motulevich")));
  CHECK(normal_colour(*constant_index({1.5, 0.0})));
}
