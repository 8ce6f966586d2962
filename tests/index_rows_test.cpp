#include "materials/index/index_rows.h"

#include <catch2/catch.hpp>

#include "spectral/support/error.h"

using namespace karat;
using Catch::Contains;

TEST_CASE("numbers in every way that the files write them", "[index][rows]") {
  const std::vector<std::pair<const char*, double>> good = {
      {"0.5", 0.5},         {".5", 0.5},       {"5.", 5.0},           {"1e5", 1e5},
      {"+2.5E-03", 2.5e-3}, {"-0.1", -0.1},    {"1.80-17", 1.80e-17}, {"1.8+3", 1800.0},
      {"1.8D-17", 1.8e-17}, {"8E-018", 8e-18}, {"-.5", -0.5}};
  for (const auto& [text, value] : good) {
    INFO(text);
    REQUIRE(index_number(text));
    CHECK(*index_number(text) == value);
  }
  for (const char* text : {"", "+", "-", "+-1", "abc", "1.2x", "1,2", "nan", "inf", "-inf", "1e999",
                           "1e5-3", "0x10", "1.8D", "1.8+", "1.8--3", "1e", "1D400"}) {
    INFO(text);
    CHECK_FALSE(index_number(text));
  }
}

TEST_CASE("rows are sorted, kept in order where repeated, and say what is odd", "[index][rows]") {
  std::vector<std::string> warnings;
  const auto rows = index_rows("0.6 1.6 0\n0.4 1.4 0\r\n\n\t0.5 1.5 -0.1\n0.5\t1.7 -0.2", "nk",
                               {"f.yml", "DATA block 1", 10}, warnings);
  CHECK(rows.wavelengths_nm == std::vector<double>{400.0, 500.0, 500.0, 600.0});
  CHECK(rows.first == std::vector<double>{1.4, 1.5, 1.7, 1.6});
  CHECK(rows.second == std::vector<double>{0.0, -0.1, -0.2, 0.0});
  REQUIRE(warnings.size() == 3);
  CHECK_THAT(warnings[0], Contains("line 11: rows are not in order"));
  CHECK_THAT(warnings[1], Contains("line 14: wavelength listed twice"));
  CHECK_THAT(warnings[2], Contains("line 13: negative k (and 1 more)"));
}

TEST_CASE("bad rows are refused with file, block and line", "[index][rows]") {
  std::vector<std::string> warnings;
  const auto message = [&](const char* text) -> std::string {
    try {
      index_rows(text, "n", {"f.yml", "DATA block 2", 7}, warnings);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(message("0.4 1.5\n0.5 x1.6") ==
        "f.yml: DATA block 2, line 8: \"x1.6\" is not a finite number such as 0.5876 or 1.2e-5");
  CHECK_THAT(message("0.4 1.5 0.2"), Contains("line 7") && Contains("more than the 2 numbers"));
  CHECK_THAT(message("0.4"), Contains("1 numbers; a row has 2"));
  CHECK_THAT(message("-0.4 1.5"), Contains("wavelength of -0.4 um"));
  CHECK_THAT(message("0 1.5"), Contains("wavelength of 0 um"));
  CHECK_THAT(message("0.4 1e300"), Contains("1e+300"));
  CHECK_THAT(message("\n \n"), Contains("no rows"));
}

TEST_CASE("too many rows are refused", "[index][rows]") {
  std::string text;
  for (int i = 0; i <= 1'000'000; ++i) text += "1 1\n";
  std::vector<std::string> warnings;
  CHECK_THROWS_WITH(index_rows(text, "n", {"f.yml", "DATA block 1", 1}, warnings),
                    Contains("more than 1000000 rows"));
}

TEST_CASE("between rows values are linear; at a repeated wavelength the last row counts",
          "[index][rows]") {
  const auto curve = rows_curve({400.0, 500.0, 500.0, 700.0}, {1.0, 2.0, 3.0, 5.0});
  CHECK((*curve)(450.0) == 1.5);
  CHECK((*curve)(500.0) == 3.0);
  CHECK((*curve)(600.0) == 4.0);
  CHECK((*curve)(300.0) == 1.0);
  CHECK((*curve)(900.0) == 5.0);
  CHECK((*rows_curve({500.0}, {1.25}))(480.0) == 1.25);
  CHECK((*rows_curve({500.0, 500.0}, {1.0, 2.0}))(500.0) == 2.0);
}
