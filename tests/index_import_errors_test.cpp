// What is refused, word by word.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "tests/imported.h"

using namespace karat;
using Catch::Contains;

namespace {

const std::string kHint =
    "; say what the columns are: --columns wavelength,n,k (also energy, wavenumber, eps1, eps2, "
    "and - for one to skip)";

// Rows of a metal: n 0.2, k from 2 to 4, in steps of 10 nm; `form` takes nm, n and k.
std::string metal(const std::string& form, double scale = 1.0, double sign = 1.0) {
  std::string text = "wavelength,n,k\n";
  for (int nm = 380; nm <= 780; nm += 10) {
    text += fmt::format(fmt::runtime(form), nm * scale, 0.2, sign * nm / 200.0) + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("malformed text columns: file, line, column, what was found", "[index][import]") {
  CHECK(import_error("") == "film.csv: empty");
  CHECK(import_error(" \n\r\n\t\n") == "film.csv: empty");
  CHECK(import_error("wavelength,n\n") == "film.csv: no rows of numbers: no line begins with one");
  CHECK(import_error("\xff\xfew\0") == "film.csv: UTF-16 text; save it as UTF-8 or plain text");
  CHECK(import_error(std::string("PK\3\4\0\0", 6)) ==
        "film.csv: a binary file; a table is text: columns of numbers, SOPRA .nk, or YAML");
  CHECK(import_error("nm,n,k\n400,1.5,0\n500,abc,0\n") ==
        "film.csv: line 3, column 2: \"abc\" is not a finite number such as 0.5876 or 1.2e-5");
  CHECK(import_error("nm,n,k\n400,1.5,0\n500,,0\n") ==
        "film.csv: line 3, column 2: an empty cell; a row needs a number here");
  CHECK(import_error("nm,n,k\n400,1.5,0\n500,nan,0\n") ==
        "film.csv: line 3, column 2: \"nan\" is not a finite number such as 0.5876 or 1.2e-5");
  CHECK(import_error("nm,n,k\n400,1.5,0\n500,1e999,0\n") ==
        "film.csv: line 3, column 2: \"1e999\" is not a finite number such as 0.5876 or 1.2e-5");
  CHECK(import_error("nm,n,k\n400,1.5,0\nnan,1.5,0\n") ==
        "film.csv: line 3, column 1: \"nan\" is no number; a row begins with its wavelength (a "
        "comment begins with #)");
  CHECK(import_error("nm,n,k\n400,1.5,0\n,1.5,0\n") ==
        "film.csv: line 3, column 1: an empty cell; a row needs a number here");
  CHECK(import_error("nm;n;k\n400;1,5;0\n;1,5;0\n") ==
        "film.csv: line 3, column 1: an empty cell; a row begins with its wavelength (a comment "
        "begins with #)");
  CHECK(import_error("n/a,1.5,0\n400,1.5,0\n500,1.4,0\n") ==
        "film.csv: line 1, column 1: \"n/a\" is no number; a row begins with its wavelength (a "
        "comment begins with #)");
  CHECK(import_error("nm,n,k\n400,1.5,0\n500,1.5\n") ==
        "film.csv: line 3: 2 columns, but line 2 has 3");
  CHECK(import_error("nm,n,k\n400,1.5,0\n500,1.5,0,7\n") ==
        "film.csv: line 3: 4 columns, but line 2 has 3");
  CHECK(
      import_error("nm;n;k\n400;1,5;0\n500;1.5;0\n") ==
      "film.csv: line 3, column 2: \"1.5\" has a decimal point, but line 2 has decimal commas: use "
      "one of them throughout");
  CHECK(import_error("nm;n;k\n1.400,5;1,5;0\n") ==
        "film.csv: line 2, column 1: \"1.400,5\" has a comma and a point; write numbers without "
        "separators of thousands");
  CHECK(import_error("nm,n,k\n0,1.5,0\n500,1.5,0\n") ==
        "film.csv: line 2: 0 nm; it must be positive");
  CHECK(import_error("nm,n,k\n400,1.5,0\n-500,1.5,0\n") ==
        "film.csv: line 3: -500 nm; it must be positive");
  CHECK(import_error("nm,n\n400,1.5\n") ==
        "film.csv: one wavelength with n; a table needs two at least (a scene takes one value as "
        "\"n\" and \"k\")");
  std::string wide;
  for (int i = 0; i < 80; ++i) wide += "1 ";
  CHECK(import_error(wide + "\n") == "film.csv: line 1: more than 64 columns");
}

TEST_CASE("columns whose meaning is not told", "[index][import]") {
  CHECK(import_error("400,1,2,3\n500,1,2,3\n") ==
        "film.csv: line 1: 4 columns without names that tell which is which" + kHint);
  CHECK(import_error("400\n500\n") ==
        "film.csv: line 1: 1 column without names that tell which is which" + kHint);
  CHECK(import_error("nm,T,R\n400,1,2\n500,1,2\n") ==
        "film.csv: line 1: the names \"nm\", \"T\", \"R\" do not tell where wavelength and n are" +
            kHint);
  CHECK(import_error("nm,n,n\n400,1,2\n500,1,2\n") ==
        "film.csv: line 1: columns 2 and 3 are both called n" + kHint);
  CHECK(import_error("400,1,2\n500,1,2\n", with_columns({"wavelength", "n", "-", "k"})) ==
        "film.csv: line 1: 3 columns; --columns names 4");
  CHECK_THAT(import_error("400,1,2\n", with_columns({"wavelength", "eps1"})),
             Contains("--columns: names no table; needed are wavelength with n"));
  CHECK_THROWS_WITH(column_names({"wavelength", "m"}),
                    "--columns: \"m\": unknown; allowed are wavelength (or energy, wavenumber), n, "
                    "k, eps1, eps2, and - for a column to skip");
  IndexImportOptions format;
  format.format = "colums";
  CHECK_THAT(import_error("400,1,2\n", format), Contains("did you mean \"columns\"?"));
}

TEST_CASE("a unit that cannot be meant is refused with the one that can", "[index][import]") {
  const std::string um = metal("{:.3f},{},{}", 1e-3), nm = metal("{:.0f},{},{}");
  const std::string end = "\n  (--accept-implausible adds the table all the same)";
  CHECK(import_error(um, with_unit(AxisUnit::kNm)) ==
        "film.csv: the axis runs from 0.38 to 0.78 nm, which no optical table does; as um (380 to "
        "780 nm) it would reach the visible: say --unit um" +
            end);
  CHECK_THAT(import_error(nm, with_unit(AxisUnit::kUm)), Contains("say --unit nm"));
  CHECK_THAT(import_error(nm, with_unit(AxisUnit::kAngstrom)), Contains("say --unit nm"));
  CHECK_THAT(import_error(nm, with_unit(AxisUnit::kEv)), Contains("say --unit nm"));
  CHECK_THAT(import_error("E,n,k\n1.6,1,2\n2,1,2\n3.3,1,2\n", with_unit(AxisUnit::kNm)),
             Contains("say --unit eV"));
  IndexImportOptions accept = with_unit(AxisUnit::kNm);
  accept.accept_implausible = true;
  CHECK(imported_table(um, accept)->range().max_nm == Approx(0.78));

  CHECK(imported(nm).unit == "nm (guessed from the numbers)");
  CHECK(imported(um).unit == "um (guessed from the numbers)");
  CHECK_THAT(imported(nm).warnings.at(0), Contains("the unit is not stated: nm is taken"));
  CHECK(import_error("0.3 1.5\n3.5 1.4\n") ==
        "film.csv: the unit is not stated, and 0.3 to 3.5 may be um (300 to 3500 nm) or eV (354.2 "
        "to 4133 nm): say --unit um or --unit eV");
  CHECK_THAT(import_error("wl,n\n5,1.5\n14,1.4\n"), Contains("say --unit nm or --unit um or"));
  CHECK_THAT(imported("wl (um),n\n5,1.5\n14,1.4\n").warnings.at(0),
             Contains("none of it is visible"));
  CHECK_THAT(imported(um, with_unit(AxisUnit::kUm)).unit, Contains("--unit"));
  CHECK_THAT(imported("wl_nm,n\n0.4,1.5\n0.7,1.4\n", with_unit(AxisUnit::kUm)).warnings.at(0),
             Contains("--unit um is used; the file says nm (line 1)"));
}

TEST_CASE("signs and magnitudes", "[index][import]") {
  const std::string negative = metal("{:.0f},{},{}", 1.0, -1.0);
  CHECK_THAT(import_error(negative), Contains("film.csv: k is negative throughout") &&
                                         Contains("n - ik") && Contains("--negate-k"));
  IndexImportOptions negate;
  negate.negate_k = true;
  CHECK(imported_table(negative, negate)->at(400.0).k == 2.0);
  CHECK_THAT(imported_table(negative, negate)->provenance().comments,
             Contains("The sign of k was changed"));
  CHECK_THAT(import_error("nm,n,k\n400,1.5,1e-3\n500,1.5,-1e-4\n600,1.4,1e-3\n"),
             Contains("k = -1e-4 at line 3 (500 nm): a negative k amplifies light"));
  CHECK_THAT(import_error("nm,n\n400,1.5\n500,-1.5\n600,-1\n"),
             Contains("n = -1.5 at line 3 (500 nm) and 1 more: n of a material is not negative"));
  CHECK_THAT(import_error("nm,n,k\n400,1.5,2e4\n600,1.4,3e4\n"),
             Contains("k = 2e4 at line 2 (400 nm) and 1 more") &&
                 Contains("An absorption coefficient is not k"));
  CHECK_THAT(import_error("nm,n\n400,15\n600,14\n"), Contains("n = 15 at line 2"));
  CHECK_THAT(import_error("nm,n,k\n400,0,0\n500,1.5,1\n600,1.4,1\n"),
             Contains("n = 0 and k = 0 at line 2 (400 nm): some programs write that"));
  // Zero is no sign: glass whose k is 0 in places.
  CHECK(import_error("nm,n,k\n400,1.5,0\n500,1.5,1e-7\n600,1.4,0\n").empty());
}

TEST_CASE("n and k in each other's place, and too few rows", "[index][import]") {
  std::string gold = "nm,k,n\n", silica = "nm,n,k\n";
  for (int nm = 400; nm <= 780; nm += 10) {
    gold += fmt::format("{},{:.3f},{:.3f}\n", nm, nm < 550 ? 1.9 : 1.9 + (nm - 550) / 90.0, 0.3);
    silica += fmt::format("{},0.0000001,1.46\n", nm);
  }
  CHECK(import_error(gold).empty());
  gold.replace(0, 6, "nm,n,k");
  CHECK_THAT(import_error(gold), Contains("n rises from 600 to 750 nm by more than 15 %") &&
                                     Contains("--columns wavelength,k,n"));
  CHECK_THAT(import_error(silica), Contains("n is below 0.02 and k above 0.8 in the visible"));
  CHECK_THAT(import_error("nm,n\n300,1.5\n900,1.4\n"),
             Contains("0 rows in 380 to 780 nm, up to 400 nm apart: too few to tell a colour"));
  CHECK_THAT(imported("nm,n\n300,1.5\n400,1.5\n500,1.5\n600,1.5\n900,1.4\n").warnings.at(0),
             Contains("3 rows in 380 to 780 nm, up to 180 nm apart"));
}

TEST_CASE("limits hold before memory is taken", "[index][import]") {
  CHECK_THAT(import_error(std::string((16u << 20) + 1, '1')), Contains("a table has at most"));
  std::string many;
  for (int i = 0; i < 1'000'001; ++i) many += "5 1\n";
  CHECK_THAT(import_error(many), Contains("line 1000001: more than 1000000 rows"));
  CHECK(import_error("um,n\n0.4,1.5\n1e13,1.4\n") ==
        "film.csv: line 3: a wavelength of 10000000000000 um; allowed are 1e-09 to 1000000000000");
  CHECK(import_error("nm,n\n400,1.5\n500,1e7\n") ==
        "film.csv: line 3: an index of 10000000; at most 1000000 is plausible");
  CHECK_THAT(import_error("eV,eps1,eps2\n2,1e308,1e308\n3,1,1\n"),
             Contains("line 2: an index of") && Contains("is plausible"));
  CHECK_THROWS_WITH(import_index_file("/nonexistent/a.csv", {}),
                    "/nonexistent/a.csv: no such file");
  CHECK_THROWS_WITH(import_index_file("/tmp", {}), "/tmp: a folder, not a file");
}
