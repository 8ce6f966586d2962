#include "materials/index/index_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "tests/imported.h"

using namespace karat;
using Catch::Contains;

namespace {

// What every way of writing glass_rows() must give.
void check_glass(const IndexTable& table) {
  CHECK(table.range().min_nm == Approx(380.0).epsilon(1e-14));
  CHECK(table.range().max_nm == Approx(780.0).epsilon(1e-14));
  CHECK(table.at(400.0).n == Approx(1.52).margin(1e-12));
  CHECK(table.at(500.0).n == Approx(1.515).margin(1e-12));
  CHECK(table.at(640.0).k == Approx(0.0064).margin(1e-12));
}

}  // namespace

TEST_CASE("separators, decimal commas, comments and line ends are found out", "[index][import]") {
  const std::string rows = glass_rows();
  check_glass(*imported_table("wavelength_nm,n,k\n" + rows));
  check_glass(*imported_table("Wavelength (nm), n, k\n" + rows));
  check_glass(
      *imported_table("\xef\xbb\xbf"
                      "Wellenl\xc3\xa4nge (nm);n;k\n" +
                      glass_rows(";", true)));
  check_glass(*imported_table("lambda/nm\tn\tk\n" + glass_rows("\t")));
  check_glass(*imported_table("lambda/nm\tn\tk\n" + glass_rows("\t", true)));
  check_glass(*imported_table("# wavelength(nm) n k\n" + glass_rows("   ")));
  check_glass(*imported_table("% measured today\n// twice\n! thrice\n; lambda (nm)  n  k\n" +
                              glass_rows("  ")));
  check_glass(*imported_table(glass_rows("  ", true)));
  check_glass(*imported_table("Gold film, sample 7\n\nwl,n,k\nnm,,\n" + rows));
  check_glass(*imported_table("\"wavelength\",\"n\",\"k\"\n\"nm\",\"\",\"\"\n" + rows));
  std::string quoted = "wl [nm],n,k\n";
  for (const char c : glass_rows(";", true)) {
    quoted += c == ';' ? "\",\"" : c == '\n' ? "\"\n" : std::string(1, c);
    if (c == '\n') quoted += '"';
  }
  quoted.insert(12, "\"");
  quoted.pop_back();
  check_glass(*imported_table(quoted));
  std::string windows = "wavelength_nm,n,k\n" + rows, mac = windows;
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2) {
    windows.insert(at, "\r");
  }
  std::replace(mac.begin(), mac.end(), '\n', '\r');
  check_glass(*imported_table(windows));
  check_glass(*imported_table(mac));
  check_glass(*imported_table("wavelength_nm,n,k\n380,1.5210,0.00380 # first\n" + rows.substr(19)));
}

TEST_CASE("what was understood is said", "[index][import]") {
  const IndexImport import = imported(
      "Wavelength (nm);n;k;sd\n380;1,5;0,1;9\n500;1,5;0,1;9\n"
      "560;1,5;0,1;9\n780;1,5;0,1;9\n");
  CHECK(import.format == "columns of numbers");
  CHECK(import.description ==
        "semicolon-separated text with decimal commas; column 1 wavelength, 2 n, 3 k; column 4 "
        "\"sd\" not used");
  CHECK(import.unit == "nm (line 1)");
  CHECK(import.rows == 4);
  CHECK(import.visible_rows == 4);
  CHECK(import.n->min == 1.5);
  CHECK(import.k->max == 0.1);
  CHECK(imported(glass_rows()).unit == "nm (guessed from the numbers)");
}

TEST_CASE("digits stay as they were written", "[index][import]") {
  const IndexImport import = imported(
      "wavelength_nm,n,k\n380.0000000001,1.50000000000000000001,1.0E-07\n"
      "500.10,1.4900,+2.5e-3\n780.000,.75,0\n");
  CHECK_THAT(import.yaml, Contains("        0.3800000000001 1.50000000000000000001 1.0E-07\n"
                                   "        0.50010 1.4900 2.5e-3\n"
                                   "        0.780000 .75 0\n"));
  CHECK_THAT(imported("wavelength (\xc3\x85)  n k\n3800 1.5 0\n5000.5 1.5 0\n7.8e3 1.5 0\n").yaml,
             Contains("        0.3800 1.5 0\n        0.50005 1.5 0\n        0.00078e3 1.5 0\n"));
}

TEST_CASE("values read back equal what was written, to the last digit", "[index][import]") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::string text = "lambda_um n k\n";
  std::vector<std::array<double, 3>> rows;
  for (int i = 0; i < 3000; ++i) {
    const std::array<double, 3> row{0.3 + 0.0002 * (i + uniform(random)), 1.0 + uniform(random),
                                    1.0 + 2.0 * uniform(random)};
    rows.push_back(row);
    text += fmt::format("{} {} {}\n", row[0], row[1], row[2]);
  }
  const IndexTablePtr table = imported_table(text);
  for (const auto& [um, n, k] : rows) {
    const ComplexIndex index = table->at(um * 1000.0);
    CHECK((index.n == n && index.k == k));
  }
}

TEST_CASE("decimal points are shifted digit by digit", "[index][import]") {
  CHECK(shifted_decimal("400.5", -3) == "0.4005");
  CHECK(shifted_decimal("5", -4) == "0.0005");
  CHECK(shifted_decimal("1234567", -3) == "1234.567");
  CHECK(shifted_decimal("1000", -3) == "1.000");
  CHECK(shifted_decimal(".5", -3) == "0.0005");
  CHECK(shifted_decimal("3.8e2", -3) == "0.0038e2");
  CHECK(shifted_decimal("-12.5", 1) == "-125");
  CHECK(shifted_decimal("0400", -3) == "0.400");
}

TEST_CASE("energies and wavenumbers by the exact constants", "[index][import]") {
  // CODATA 2018: hc = 1239.841984... eV nm.
  CHECK(kEvMicrometres * 1e3 == Approx(1239.841984332002).epsilon(1e-15));
  std::string energies = "Photon energy (eV), n, k\n", numbers = "wavenumber (cm-1)  n  k\n";
  for (int i = 0; i <= 40; ++i) {
    energies += fmt::format("{},{},0.5\n", 1.5 + 0.05 * i, 2.0 + 0.01 * i);
    numbers += fmt::format("{} {} 0.5\n", 12000 + 400 * i, 2.0 + 0.01 * i);
  }
  const IndexTablePtr by_energy = imported_table(energies);
  CHECK(by_energy->at(1239.8419843320026 / 2.5).n == Approx(2.2).epsilon(1e-14));
  CHECK(by_energy->range().min_nm == Approx(1239.8419843320026 / 3.5).epsilon(1e-15));
  CHECK(by_energy->warnings().empty());  // an energy axis runs backwards by nature
  const IndexTablePtr by_number = imported_table(numbers);
  CHECK(by_number->at(1e7 / 20000.0).n == Approx(2.2).epsilon(1e-14));
  CHECK(imported(energies).warnings.empty());
}

TEST_CASE("columns by name, by --columns, and skipped", "[index][import]") {
  const std::string rows = "500,9,0.25,1.5\n600,9,0.25,1.5\n700,9,0.25,1.5\n";
  CHECK(imported_table(rows, with_columns({"wavelength", "-", "k", "n"}))->at(600.0).n == 1.5);
  CHECK(imported_table("nm,T,k,n\n" + rows)->at(600.0).k == 0.25);
  CHECK(imported_table("wl (nm),T,Im(n),Re(n)\n" + rows)->at(600.0).k == 0.25);
  const IndexImport fewer = imported(rows, with_columns({"wavelength", "-", "n"}));
  CHECK_THAT(fewer.description, Contains("column 1 wavelength, 3 n; column 4 not used"));
  CHECK_FALSE(table_of(fewer)->has_k());
  // The file still says what its unit is: 10 to 30 nm could be um as well.
  const std::string soft = "10,0.9,0.1\n20,0.9,0.1\n30,0.9,0.1\n";
  const auto named = with_columns({"wavelength", "n", "k"});
  CHECK(imported("Wavelength (nm),index,loss\n" + soft, named).unit == "nm (line 1)");
  CHECK(imported("# wl (nm), a, b\n" + soft, named).unit == "nm (line 1)");
  CHECK_THROWS_WITH(imported(soft, named), Contains("the unit is not stated"));
  CHECK(imported_table("wavelength_nm,n\n400,1.5\n500,1.5\n700,1.4\n")->at(600.0).n ==
        Approx(1.45));
}

TEST_CASE("n and k in blocks one below the other, as refractiveindex.info exports them",
          "[index][import]") {
  const auto same =
      imported("wl,n\n0.4,1.5\n0.5,1.4\n0.7,1.3\n\nwl,k\n0.4,0.1\n0.5,0.2\n0.7,0.3\n");
  CHECK_THAT(same.yaml, Contains("tabulated nk") && Contains("0.5 1.4 0.2\n"));
  const auto apart = imported("wl,n\n0.4,1.5\n0.5,1.4\n0.7,1.3\n\nwl,k\n0.45,0.1\n0.65,0.2\n");
  CHECK_THAT(apart.yaml, Contains("tabulated n\n") && Contains("tabulated k\n"));
  CHECK(table_of(apart)->at(550.0).k == Approx(0.15));
  CHECK_THAT(import_error("wl,n\n0.4,1.5\n0.7,1.4\nwl,n\n0.4,1.5\n0.7,1.4\n"),
             Contains("several blocks list the same quantity"));
  CHECK_THAT(import_error("wl,k\n0.4,1.5\n0.7,1.4\n"), Contains("k alone is listed"));
}

TEST_CASE("order and repeats", "[index][import]") {
  std::string backwards = "wavelength_nm,n,k\n";
  for (int nm = 780; nm >= 380; nm -= 20) backwards += fmt::format("{},1.5,0.{}\n", nm, nm);
  CHECK(imported(backwards).warnings.empty());
  CHECK(imported_table(backwards)->at(500.0).k == Approx(0.5));

  const auto mixed = imported("wavelength_nm,n\n380,1.5\n500,1.4\n450,1.45\n650,1.35\n780,1.3\n");
  CHECK_THAT(mixed.warnings.at(0), Contains("line 4") && Contains("sorted"));
  CHECK(table_of(mixed)->at(475.0).n == Approx(1.425));

  const auto equal = imported("wavelength_nm,n\n500,1.5\n600,1.4\n600,1.40\n700,1.3\n");
  CHECK_THAT(equal.warnings.at(0), Contains("line 4: repeats another row; left out"));
  CHECK(equal.rows == 3);
  const auto step = imported("wavelength_nm,n\n500,1.5\n600,1.4\n600,1.2\n700,1.3\n");
  CHECK_THAT(step.warnings.at(0), Contains("line 4") && Contains("a step"));
  CHECK(table_of(step)->at(600.0).n == 1.2);
}

TEST_CASE("reference and comments of the file go along", "[index][import]") {
  IndexImportOptions options;
  options.reference = "A. Author.\n\tTitle: \"x\" # y, J. Opt. 1 (2026)";
  options.file_name = "film.csv";
  options.date = "2026-11-22";
  const auto table = imported_table(
      "# Sample 7: { polished }\n# 20 \xb0"
      "C\nwavelength_nm,n\n500,1.5\n700,1.4\n",
      options);
  CHECK(table->provenance().reference == "A. Author. Title: \"x\" # y, J. Opt. 1 (2026)");
  CHECK(
      table->provenance().comments ==
      "Added from film.csv on 2026-11-22: comma-separated text; column 1 wavelength, 2 n; unit nm "
      "(line 3). Sample 7: { polished } 20 \xc2\xb0"
      "C");
}

TEST_CASE("a hundred thousand rows", "[index][import]") {
  std::string text = "wavelength_nm;n;k\n";
  for (int i = 0; i < 100'000; ++i) text += fmt::format("{:.3f};1.5;0.1\n", 300.0 + i * 0.01);
  std::replace(text.begin(), text.end(), '.', ',');
  CHECK(imported(text).rows == 100'000);
}
