// SOPRA, IMD, permittivity and YAML.
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <catch2/catch.hpp>
#include <complex>
#include <filesystem>
#include <random>

#include "materials/index/import/permittivity.h"
#include "tests/imported.h"

using namespace karat;
using Catch::Contains;

namespace {

// The file of FreeSnell's manual, shortened: 4 intervals from 1.6 to 3.6 eV.
constexpr const char* kSopra =
    "1             1.6            3.6           4\n"
    " 1.064         14.4\n .987875;       3.155;\n .844          2.2\n .672625;1.445\n .514 1.1\n";

}  // namespace

TEST_CASE("SOPRA: n and k at the ends of even intervals", "[index][import]") {
  IndexImportOptions accept;
  accept.accept_implausible = true;  // k = 14.4
  const IndexImport import = imported(kSopra, accept, "Ag.nk");
  CHECK(import.format == "SOPRA .nk");
  CHECK(import.unit == "eV (the SOPRA header)");
  CHECK(import.rows == 5);
  const IndexTablePtr table = table_of(import);
  CHECK(table->range().max_nm == Approx(1239.8419843320026 / 1.6).epsilon(1e-14));
  const ComplexIndex index = table->at(1239.8419843320026 / 2.1);
  CHECK(index.n == Approx(0.987875).epsilon(1e-12));
  CHECK(index.k == Approx(3.155).epsilon(1e-12));
  CHECK_THAT(import.yaml, Contains(" .514 1.1\n"));

  const auto um = imported_table("2 .4 .8 2\n1.5 .1 1.4 .2\n1.3 .3\n", {}, "x.nk");
  CHECK(um->at(600.0).n == Approx(1.4).epsilon(1e-13));
  const auto nm = imported_table("4 400 800 2\n1.5 .1\n1.4 .2\n1.3 .3\n", {}, "x.dat");
  CHECK(nm->at(700.0).k == Approx(0.25).epsilon(1e-13));
  const auto per_cm = imported_table("3 12500 25000 2\n1.5 .1\n1.4 .2\n1.3 .3\n", {}, "x.nk");
  CHECK(per_cm->at(800.0).n == Approx(1.5).epsilon(1e-13));
  CHECK(per_cm->at(1e7 / 18750.0).n == Approx(1.4).epsilon(1e-13));
}

TEST_CASE("SOPRA: what is wrong is named with its place", "[index][import]") {
  CHECK(import_error("1 1.6 3.6 4\n1 2\n1 2\n1 2\n1 2\n", {}, "a.nk") ==
        "a.nk: 4 pairs of n and k; the header's 4 intervals have 5");
  CHECK(import_error("1 1.6 3.6 2\n1 2\n1 2\n1 2\n1 2\n", {}, "a.nk") ==
        "a.nk: line 5, column 1: more than the 3 pairs of n and k that the header's 2 intervals "
        "have");
  CHECK(import_error("1 1.6 3.6 2\n1 2\n1 2\n1\n", {}, "a.nk") ==
        "a.nk: line 4, column 1: an n without a k behind it");
  CHECK(import_error("1 1.6 3.6 2\n1 2\n1 x\n1 2\n", {}, "a.nk") ==
        "a.nk: line 3, column 2: \"x\" is not a finite number such as 0.5876 or 1.2e-5");
  CHECK(import_error("1 0 3.6 2\n1 2\n1 2\n1 2\n", {}, "a.nk") ==
        "a.nk: line 1: an axis from 0 to 3.6; both ends must be positive and differ");
  CHECK(import_error("1 1 2 900000000\n1 2\n", {}, "a.nk") ==
        "a.nk: line 1: 900000000 intervals; at most 1000000 rows are read");
  IndexImportOptions sopra;
  sopra.format = "sopra";
  CHECK_THAT(import_error("5 1 2 3\n", sopra), Contains("line 1: not a SOPRA header: unit (1 eV"));
  CHECK_THAT(import_error("", sopra), Contains("not a SOPRA header"));
  CHECK_THAT(import_error(kSopra, with_columns({"wavelength", "n"}), "a.nk"),
             Contains("leave --columns out"));
}

TEST_CASE("IMD and luxpop: angstroms below semicolon comments", "[index][import]") {
  const IndexImport import = imported(
      "; Ag, Palik I\n;\n4000 0.173 1.95\n5000 0.13 2.917\n7000 0.143 4.523\n", {}, "Ag_palik.nk");
  CHECK(import.format == "IMD .nk");
  CHECK(import.unit == "angstrom (IMD's .nk files have angstroms)");
  CHECK_THAT(import.yaml, Contains("Ag, Palik I") && Contains("0.5000 0.13 2.917\n"));
  // Another program's .nk in nm: what IMD's unit would make of it is no optical table.
  CHECK_THAT(import_error("400 0.17 1.95\n500 0.13 2.9\n700 0.14 4.5\n", {}, "Ag.nk"),
             Contains("as nm (400 to 700 nm) it would reach the visible: say --unit nm"));
}

TEST_CASE("the index of a permittivity is its complex square root", "[index][import]") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-12.0, 6.0), sign(-1.0, 1.0);
  for (int i = 0; i < 20'000; ++i) {
    const double eps1 = std::copysign(std::pow(10.0, exponent(random)), sign(random));
    const double eps2 = std::pow(10.0, exponent(random));
    const std::complex<long double> root = std::sqrt(std::complex<long double>(eps1, eps2));
    const ComplexIndex index = index_of_permittivity(eps1, eps2);
    CHECK(index.n == Approx(static_cast<double>(root.real())).epsilon(1e-14));
    CHECK(index.k == Approx(static_cast<double>(root.imag())).epsilon(1e-14));
    CHECK((index.n >= 0.0 && index.k >= 0.0));
  }
  CHECK(index_of_permittivity(4.0, 0.0).n == 2.0);
  CHECK(index_of_permittivity(4.0, 0.0).k == 0.0);
  CHECK(index_of_permittivity(-4.0, 0.0).k == 2.0);
  CHECK(index_of_permittivity(-4.0, 0.0).n == 0.0);
  CHECK(index_of_permittivity(-4.0, -1e-3).k < 0.0);
  CHECK(index_of_permittivity(0.0, 2.0).n == 1.0);
  CHECK(index_of_permittivity(0.0, 2.0).k == 1.0);
  CHECK(index_of_permittivity(0.0, 0.0).n == 0.0);
}

TEST_CASE("columns of the permittivity", "[index][import]") {
  const IndexImport import =
      imported("E (eV)\teps1\teps2\n1.6\t-25\t1.5\n2.0\t-12\t1.2\n2.5\t-4\t2.0\n3.1\t-1\t6\n", {},
               "eps.txt");
  CHECK_THAT(import.description, Contains("column 1 energy, 2 eps1, 3 eps2"));
  const IndexTablePtr table = table_of(import);
  CHECK_THAT(table->provenance().comments, Contains("computed from the permittivity"));
  const std::complex<double> root = std::sqrt(std::complex<double>(-12.0, 1.2));
  const ComplexIndex index = table->at(1239.8419843320026 / 2.0);
  CHECK(index.n == Approx(root.real()).epsilon(1e-12));
  CHECK(index.k == Approx(root.imag()).epsilon(1e-12));
  CHECK_THAT(import_error("E (eV)\teps1\teps2\n1.6\t-25\t-1.5\n2.0\t-12\t-1.2\n2.5\t-4\t-2\n"),
             Contains("other sign convention") && Contains("--negate-k"));
  CHECK_THAT(import_error("nm,eps1\n400,-3\n700,-9\n"),
             Contains("line 1: the names \"nm\", \"eps1\" do not tell"));
}

TEST_CASE("a table of the database is taken over as it stands", "[index][import]") {
  const std::string text =
      "# kept\nREFERENCES: \"B. Author\"\nDATA:\n  - type: formula 1\n"
      "    wavelength_range: 0.3 2.5\n    coefficients: 0 1.2 0.1\n";
  CHECK(imported(text, {}, "glass.txt").yaml == text);
  CHECK_THAT(imported(text, {}, "glass.yml").warnings.at(0), Contains("--reference is not used"));
  const auto added = imported(text.substr(text.find("DATA")), {}, "glass.yml");
  CHECK(table_of(added)->provenance().reference == "A. Author, 2026");
  CHECK_THAT(import_error(text, with_unit(AxisUnit::kNm), "glass.yml"),
             Contains("leave out --unit, --columns and --negate-k"));
  CHECK_THAT(
      import_error("DATA:\n  - type: tabulated n\n    data: |\n      0.5 1,5\n", {}, "a.yml"),
      Contains("line 4") && Contains("\"1,5\""));
  CHECK_THAT(
      import_error("DATA:\n  - type: tabulated n\n    data: |\n      400 1.5\n      700 1.4\n"),
      Contains("400 to 700, and the format's unit is the micrometre"));
}

TEST_CASE("the database's own tables are plausible; with n and k exchanged many are not",
          "[index][import]") {
  namespace fs = std::filesystem;
  const fs::path main =
      fs::path(KARAT_TEST_REFERENCE_DIR) / "refractiveindex.info/database/data/main";
  if (!fs::is_directory(main)) {
    WARN("skipped: no " + main.string());
    return;
  }
  int tables = 0, refused = 0, exchanged = 0;
  for (const char* book : {"Au", "Ag", "Cu", "Al", "Si", "Ge", "GaAs", "TiO2", "SiO2", "TiN"}) {
    for (const auto& file : fs::directory_iterator(main / book / "nk")) {
      const YAML::Node data = YAML::LoadFile(file.path().string())["DATA"][0];
      if (data["type"].Scalar() != "tabulated nk") continue;
      const std::string rows = data["data"].Scalar();
      ++tables;
      const std::string error = import_error("wavelength (um)  n  k\n" + rows);
      INFO(file.path() << ": " << error);
      CHECK_THAT(error, !Contains("each other's place"));
      refused += !error.empty();
      exchanged += import_error("wavelength (um)  k  n\n" + rows).find("each other's place") !=
                   std::string::npos;
    }
  }
  CHECK(tables > 100);
  CHECK(refused == 0);
  CHECK(exchanged > tables * 2 / 5);  // the rest do not reach from 600 to 750 nm, or absorb
}
