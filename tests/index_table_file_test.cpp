#include "materials/index/index_table_file.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "spectral/support/error.h"

using namespace karat;
using Catch::Contains;

namespace {

const std::string kHead = "REFERENCES: \"R\"\n";

IndexTablePtr table_of(const std::string& text) { return load_index_table_text(kHead + text, "t"); }

// A file of one block of rows.
std::string rows(const std::string& type, const std::string& lines) {
  return "DATA:\n  - type: tabulated " + type + "\n    data: |\n" + lines;
}

std::string error_of(const std::string& text) {
  try {
    load_index_table_text(text, "t");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool warns(const IndexTable& table, const std::string& words) {
  for (const std::string& warning : table.warnings()) {
    if (warning.find(words) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("a file of rows becomes a table with its provenance", "[index][index-file]") {
  const auto table = load_index_table_text(
      "REFERENCES: |\n    A. Author.<br>\n    <i>J.</i>\nCOMMENTS: |\n    a film\nCONDITIONS:\n"
      "    temperature: 293\n    substrate: c-Si\nDATA:\n  - type: tabulated nk\n    data: |\n"
      "        0.4 1.5 0.1\n        0.6 1.7 0.3",
      "my/table/x");
  CHECK(table->provenance().name == "my/table/x");
  CHECK(table->provenance().reference == "A. Author. J.");
  CHECK(table->provenance().comments == "a film");
  CHECK(table->provenance().conditions == "temperature: 293; substrate: c-Si");
  CHECK(table->range().min_nm == 400.0);
  CHECK(table->range().max_nm == 600.0);
  CHECK(table->at(450.0).n == Approx(1.55).epsilon(1e-14));
  CHECK(table->at(450.0).k == Approx(0.15).epsilon(1e-14));
  CHECK(table->warnings().empty());
}

TEST_CASE("n and k of different blocks count on their joint range", "[index][index-file]") {
  const auto table = table_of(
      "DATA:\n- type: formula 2\n  wavelength_range: 0.3 2.5\n  coefficients: 1.25\n"
      "- type: tabulated k\n  data: |\n    0.4 0.1\n    3.0 0.2\n");
  CHECK(table->range().min_nm == 400.0);
  CHECK(table->range().max_nm == 2500.0);
  CHECK(table->has_k());
  CHECK(table->at(400.0).n == 1.5);
  CHECK(table->at(100.0).k == 0.1);
}

TEST_CASE("where k lies elsewhere n is used alone and that is said", "[index][index-file]") {
  const auto table = table_of(rows("n", "        0.4 1.5\n        0.7 1.4\n") +
                              "  - type: tabulated k\n    data: |\n        0.28 0.1\n");
  CHECK_FALSE(table->has_k());
  CHECK(warns(*table, "k covers 280 to 280 nm"));
}

TEST_CASE("the first block that lists a quantity counts", "[index][index-file]") {
  const auto table = table_of(rows("n", "        0.4 1.5\n        0.7 1.5\n") +
                              "  - type: formula 5\n    range: 0.2 1\n    coefficients: 9\n");
  CHECK(table->at(500.0).n == 1.5);
  CHECK(table->range().min_nm == 400.0);
  CHECK(warns(*table, "DATA block 2: lists n again"));
}

TEST_CASE("the nonlinear index is left out, and said", "[index][index-file]") {
  const std::string n2 = "  - type: tabulated n2\n    data: |\n        1.03 1E-19\n";
  CHECK(warns(*table_of(rows("n", "        0.4 1.5\n") + n2), "nonlinear index n2 is not used"));
  CHECK_THAT(error_of("DATA:\n" + n2), Contains("only the nonlinear index"));
  CHECK_THAT(error_of(rows("k", "        0.4 1.5\n")), Contains("k alone"));
}

TEST_CASE("tabs, blank lines, odd numbers and a missing last newline are read",
          "[index][index-file]") {
  const auto table =
      table_of(rows("nk", "        .4\t1.5 1.80-17\n\n \t0.5   +1.6 1e-5\r\n        6e-1 1.7 0"));
  CHECK(table->at(400.0).k == 1.80e-17);
  CHECK(table->at(500.0).n == 1.6);
  CHECK(table->range().max_nm == 600.0);
}

TEST_CASE("one row is a table of one wavelength", "[index][index-file]") {
  const auto table = table_of(rows("n", "        0.58929 1.452\n"));
  CHECK(table->range().width_nm() == 0.0);
  CHECK(table->at(400.0).n == 1.452);
  CHECK_THROWS_AS(require_coverage(*table, kVisible, RangePolicy::kError), InputError);
}

TEST_CASE("negative values stay as they are and are warned of", "[index][index-file]") {
  const auto table = table_of(rows("nk", "        0.4 1.5 0.1\n        0.7 1.4 -0.02\n"));
  CHECK(table->at(700.0).k == -0.02);
  CHECK(warns(*table, "line 6: negative k"));
  CHECK(warns(*table_of(rows("nk", "        0.4 1.5 0\n        0.7 1.4 -0.0\n")),
              "k is zero in every row"));
}

TEST_CASE("a formula without an index in its range is an error where it is asked, never a NaN",
          "[index][index-file]") {
  const auto table = table_of(
      "DATA:\n  - type: formula 2\n    wavelength_range: 0.3 12\n"
      "    coefficients: 0 1.4 0.03 0.09 43.5\n");
  CHECK(warns(*table, "a resonance at 6595"));
  CHECK(warns(*table, "n^2 is negative"));
  CHECK(std::isfinite(table->at(550.0).n));
  CHECK_THROWS_WITH(table->at(6594.0), Contains("t: DATA block 1") && Contains("6594 nm"));
  CHECK_THAT(error_of("DATA:\n - type: formula 2\n   range: 0.3 1\n   coefficients: -3"),
             Contains("no index anywhere"));
}

TEST_CASE("a lost coefficient is warned of", "[index][index-file]") {
  CHECK(warns(*table_of("DATA:\n - type: formula 2\n   range: 0.7 1\n   coefficients: 3 2 0.1 1\n"),
              "4 coefficients"));
}

TEST_CASE("a key that is a slip is warned of", "[index][index-file]") {
  CHECK(warns(*table_of("REFERENCE: x\n" + rows("n", "        0.4 1.5\n")),
              "meant to be REFERENCES"));
  CHECK(warns(*load_index_table_text(rows("n", "        0.4 1.5\n"), "t"), "no REFERENCES"));
}

TEST_CASE("errors name the table, the line, and what is allowed", "[index][index-file]") {
  CHECK(error_of(rows("nk", "        0.4 1 2\n        0.5 1 2x\n")) ==
        "t: DATA block 1, line 5: \"2x\" is not a finite number such as 0.5876 or 1.2e-5");
  CHECK_THAT(error_of(rows("kn", "        0.4 1 2\n")),
             Contains("line 2") && Contains("\"tabulated kn\"; did you mean \"tabulated") &&
                 Contains("formula 9"));
  CHECK_THAT(error_of("DATA:\n - type: formula 2\n   range: 1 0.4\n   coefficients: 0"),
             Contains("line 2") && Contains("two increasing wavelengths"));
  CHECK_THAT(error_of("DATA:\n - type: formula 2\n   range: 0.4 1\n   coefficients: 0 x"),
             Contains("coefficients: \"x\""));
  CHECK_THAT(error_of("DATA:\n - type: formula 2\n   coefficients: 0"),
             Contains("has no \"range\""));
  CHECK_THAT(error_of("DATA:\n - type: formula 2\n   range: 0.4 1"),
             Contains("has no \"coefficients\""));
  CHECK_THAT(error_of("DATA:\n - data: 1 2"), Contains("has no \"type\""));
  CHECK_THAT(error_of("DATA: 3"), Contains("list of 1 to 64 blocks"));
  CHECK_THAT(error_of("REFERENCES: x"), Contains("no DATA"));
  CHECK_THAT(error_of("A: [1, 2"), Contains("t: line") && Contains("not valid YAML"));
  for (const char* text : {"", "x", "- 1", "~", "[[[[", "DATA: [1]", "? [a]\n: b"}) {
    INFO(text);
    CHECK_FALSE(error_of(text).empty());
  }
}

TEST_CASE("files that cannot be a table are refused before they are read", "[index][index-file]") {
  CHECK_THROWS_WITH(load_index_table_file("/nonexistent/x.yml", "x"),
                    Contains("/nonexistent/x.yml: no such file"));
  CHECK_THROWS_AS(load_index_table_file("/", "x"), InputError);
  const auto large = std::filesystem::temp_directory_path() / "karat_index_table_large.yml";
  std::ofstream(large) << "x";
  std::filesystem::resize_file(large, (std::uintmax_t{16} << 20) + 1);
  CHECK_THROWS_WITH(load_index_table_file(large.string(), "x"), Contains("at most 16777216"));
  std::filesystem::remove(large);
}
