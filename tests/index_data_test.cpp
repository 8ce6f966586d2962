// The tables that ship, and the published database that they come from.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "materials/index/index_catalogue.h"
#include "materials/index/index_table_file.h"
#include "spectral/support/data_path.h"
#include "spectral/support/error.h"

using namespace karat;
namespace fs = std::filesystem;

namespace {

const fs::path kShared = KARAT_TEST_REFERENCE_DIR;
const fs::path kDatabase = kShared / "refractiveindex.info/database";

bool missing(const fs::path& path) {
  if (fs::exists(path)) return false;
  WARN("skipped: no " << path.string());
  return true;
}

// Joint range up to the rounding of micrometres to nanometres.
bool inside(const IndexTable& table, double nm) {
  return table.range().min_nm * (1 - 1e-12) <= nm && nm <= table.range().max_nm * (1 + 1e-12);
}

void check_value(const IndexTable& table, const nlohmann::json& value) {
  const double nm = value["wavelength_um"].get<double>() * 1000.0;
  INFO(nm << " nm");
  const bool both = !value["n"].is_null() && (!table.has_k() || !value["k"].is_null());
  CHECK(inside(table, nm) == both);
  if (!both) return;
  const ComplexIndex index = table.at(nm);
  CHECK(std::abs(index.n - value["n"].get<double>()) < 1e-9);
  if (table.has_k()) CHECK(std::abs(index.k - value["k"].get<double>()) < 1e-9);
}

// One row "um,n,k" of a figure; k may be blank. Sampled rows carry nine digits.
int compare_row(const IndexTable& table, double um, const std::string& row) {
  double n = 0.0, k = 0.0;
  const int count = std::sscanf(row.c_str(), "%*f,%lf,%lf", &n, &k);
  if (count < 1 || !inside(table, um * 1000.0)) return 0;
  const ComplexIndex index = table.at(um * 1000.0);
  if (std::abs(index.n - n) > 1e-8) FAIL_CHECK(um << " um: n " << index.n << " not " << n);
  if (count == 2 && table.has_k() && std::abs(index.k - k) > 1e-8) {
    FAIL_CHECK(um << " um: k " << index.k << " not " << k);
  }
  return 1;
}

}  // namespace

TEST_CASE("published pages agree with an independent reader to 1e-9", "[index][index-data]") {
  const fs::path file = kShared / "reference/nk_pages_public.json";
  if (missing(file) || missing(kDatabase)) return;
  const auto reference = nlohmann::json::parse(std::ifstream(file));
  CHECK(reference["pages"].size() == 25);
  for (const auto& page : reference["pages"]) {
    const std::string name = page["page"];
    INFO(name);
    const auto table = load_index_table_file((kDatabase / "data" / name).string(), name);
    for (const auto& value : page["values"]) check_value(*table, value);
  }
}

TEST_CASE("every file of the database is a table or a clear error", "[index][index-data]") {
  if (missing(kDatabase)) return;
  std::map<std::string, int> counts;
  for (const auto& entry : fs::recursive_directory_iterator(kDatabase / "data")) {
    if (entry.path().extension() != ".yml" || entry.path().filename() == "about.yml") continue;
    INFO(entry.path().string());
    ++counts["files"];
    IndexTablePtr table;
    try {
      table = load_index_table_file(entry.path().string(), "t");
    } catch (const InputError& error) {
      const std::string message = error.what();
      const bool n2 = message.find("only the nonlinear index") != std::string::npos;
      const bool k = message.find("k alone") != std::string::npos;
      CHECK((n2 || k));
      ++counts[n2 ? "n2 only" : "k only"];
      continue;
    }
    ++counts["tables"];
    counts["cover the visible"] += table->has_k() && table->range().covers(kVisible);
    CHECK_FALSE(table->provenance().reference.empty());
    for (int i = 0; i < 50; ++i) {
      const double nm = table->range().min_nm + table->range().width_nm() * i / 49.0;
      try {
        const ComplexIndex index = table->at(nm);
        if (!std::isfinite(index.n) || !std::isfinite(index.k)) FAIL_CHECK(nm << " nm: not finite");
      } catch (const InputError&) {
        ++counts["wavelengths without an index"];
      }
    }
  }
  // Counted by a separate script over commit ff11b58.
  CHECK(counts["files"] == 3720);
  CHECK(counts["n2 only"] == 240);
  CHECK(counts["k only"] == 19);
  CHECK(counts["tables"] == 3461);
  CHECK(counts["wavelengths without an index"] < 4 * 50);
}

TEST_CASE("every shipped table loads, names its source and covers the visible unless it says so",
          "[index][index-data]") {
  const auto entries = list_index_tables();
  CHECK(entries.size() >= 130);
  for (const IndexTableEntry& entry : entries) {
    if (entry.file.rfind(data_path("nk"), 0) != 0) continue;  // the user's own
    INFO(entry.name);
    const auto table = find_index_table(entry.name);
    CHECK(table->provenance().reference.size() > 20);
    CHECK(table->range().width_nm() > 0.0);
    std::ifstream file(entry.file);
    std::stringstream text;
    text << file.rdbuf();
    CHECK(text.str().find("CC0") != std::string::npos);
    if (table->range().covers(kVisible)) CHECK_NOTHROW(on_lattice(*table, WavelengthLattice()));
  }
}

TEST_CASE("the usual materials are shipped and cover the visible", "[index][index-data]") {
  for (const char* name : {"main/Au/Johnson",
                           "main/Ag/Johnson",
                           "main/Cu/Johnson",
                           "main/Al/Rakic",
                           "main/Hg/Inagaki",
                           "main/Fe/Johnson",
                           "main/Cr/Johnson",
                           "main/Ni/Johnson",
                           "main/Ti/Johnson",
                           "main/Pt/Rakic-BB",
                           "main/Pd/Johnson",
                           "main/W/Rakic-BB",
                           "main/Zn/Werner",
                           "other/Cu-Zn/Querry-Cu70Zn30",
                           "other/Cu-Zn/Querry-Cu85Zn15",
                           "other/Cu-Zn/Querry-Cu90Zn10",
                           "other/stainless_steel/Karlsson-austenitic",
                           "other/stainless_steel/Karlsson-ferritic",
                           "specs/SCHOTT-optical/N-BK7",
                           "main/H2O/Hale",
                           "main/SiO2/Malitson",
                           "main/H2O/Daimon-20.0C",
                           "main/Al2O3/Malitson-o",
                           "main/Al2O3/Malitson-e",
                           "main/C/Phillip"}) {
    INFO(name);
    const auto table = find_index_table(name);
    CHECK(table->range().covers(kVisible));
    CHECK_NOTHROW(on_lattice(*table, WavelengthLattice()));
  }
}

TEST_CASE("shipped tables equal the rows that they were written from", "[index][index-data]") {
  const fs::path folder = kShared / "figures/nk";
  if (missing(folder)) return;
  std::ifstream list(folder / "INDEX.csv");
  std::string line;
  std::getline(list, line);
  int compared = 0;
  while (std::getline(list, line)) {
    const std::size_t quote = line.find('"');
    const std::string csv = line.substr(0, line.find(','));
    const std::string page = line.substr(quote + 1, line.find('"', quote + 1) - quote - 1);
    INFO(page);
    const auto table = find_index_table(page);
    std::ifstream rows(folder / csv);
    std::map<double, std::string> last_at;  // of a repeated wavelength the last row counts
    for (std::string row; std::getline(rows, row);) {
      double um = 0.0;
      if (std::sscanf(row.c_str(), "%lf,", &um) == 1) last_at[um] = row;
    }
    for (const auto& [um, row] : last_at) compared += compare_row(*table, um, row);
  }
  CHECK(compared > 30000);
}
