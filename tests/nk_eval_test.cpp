// karat nk eval, colour and compare, as they are typed.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/run_cli.h"

namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using karat::test::karat_run;
using karat::test::Outcome;
using nlohmann::json;

const fs::path kShared = KARAT_TEST_REFERENCE_DIR;

// The reference of that name, with the whole database on the path of tables while it lives; null
// where it does not exist.
class Reference {
 public:
  explicit Reference(const std::string& name) {
    const fs::path file = kShared / "reference" / name;
    const fs::path database = kShared / "refractiveindex.info/database";
    if (!fs::exists(file) || !fs::exists(database)) {
      WARN("skipped: no " << file.string() << " or no " << database.string());
      return;
    }
    value = json::parse(std::ifstream(file));
    setenv("KARAT_NK_PATH", database.c_str(), 1);
  }
  ~Reference() { unsetenv("KARAT_NK_PATH"); }
  json value;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

json json_of(std::vector<std::string> arguments) {
  arguments.push_back("--json");
  const Outcome outcome = karat_run(std::move(arguments));
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  return json::parse(outcome.out);
}

void check_cell(const std::string& cell, const json& expected) {
  if (expected.is_null()) {
    CHECK(cell.empty());
  } else {
    CHECK(std::abs(std::stod(cell) - expected.get<double>()) < 1e-9);
  }
}

void check_row(const std::string& row, const json& expected) {
  INFO(row);
  const std::size_t first = row.find(','), second = row.find(',', first + 1);
  check_cell(row.substr(first + 1, second - first - 1), expected["n"]);
  check_cell(row.substr(second + 1), expected["k"]);
}

void check_near(const json& found, const json& expected, double tolerance) {
  REQUIRE(found.size() == 3);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(std::abs(found[i].get<double>() - expected[i].get<double>()) < tolerance);
}

}  // namespace

TEST_CASE("published pages agree through the command line to 1e-9", "[nk-eval]") {
  const Reference reference("nk_pages_public.json");
  if (reference.value.is_null()) return;
  std::size_t rows = 0;
  for (const auto& page : reference.value["pages"]) {
    const std::string name = page["page"];
    INFO(name);
    std::string wavelengths;
    json expected = json::array();
    for (const auto& value : page["values"]) {
      if (value["n"].is_null()) continue;  // outside the range: an error, below
      if (!wavelengths.empty()) wavelengths += ',';
      wavelengths += json(value["wavelength_um"].get<double>() * 1000.0).dump();
      expected.push_back(value);
    }
    const Outcome outcome = karat_run({"nk", "eval", name, "--nm", wavelengths});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const auto lines = lines_of(outcome.out);
    REQUIRE(lines.size() == expected.size() + 1);
    CHECK(lines.front() == "wavelength_nm,n,k");
    for (std::size_t i = 0; i < expected.size(); ++i) check_row(lines[i + 1], expected[i]);
    rows += expected.size();
  }
  CHECK(rows > 400);
}

TEST_CASE("lists and ranges of wavelengths", "[nk-eval]") {
  const Outcome outcome =
      karat_run({"nk", "eval", "Au/Johnson", "--nm", "400,550:600:10", "--nm", "700.1:700.3:.1"});
  CHECK(outcome.code == 0);
  const auto lines = lines_of(outcome.out);
  REQUIRE(lines.size() == 1 + 1 + 6 + 3);
  CHECK(lines[1].rfind("400,", 0) == 0);
  CHECK(lines[2].rfind("550,", 0) == 0);
  CHECK(lines[7].rfind("600,", 0) == 0);
  CHECK(lines[9].rfind("700.2,", 0) == 0);
  CHECK(lines_of(karat_run({"nk", "eval", "Au/Johnson", "--nm", "400:409:2"}).out)
            .back()
            .rfind("408,", 0) == 0);
  CHECK(karat_run({"nk", "eval", "--nm", "400,500", "Au/Johnson"}).code == 0);
  for (const char* wrong : {"", "400:", "400:500", "500:400:10", "400:500:0", "400:500:-1",
                            "400:500:1e-9", "1:2:3:4", "inf", "0", "-5", "400;500"}) {
    INFO(wrong);
    const Outcome failed = karat_run({"nk", "eval", "Au/Johnson", "--nm", wrong});
    CHECK(failed.code == 2);
    CHECK(failed.out.empty());
  }
}

TEST_CASE("n alone leaves k empty; outside the range is an error that names it", "[nk-eval]") {
  const Outcome glass = karat_run({"nk", "eval", "main/SiO2/Malitson", "--nm", "587.6"});
  CHECK(glass.code == 0);
  CHECK(lines_of(glass.out).back().back() == ',');
  CHECK(json_of({"nk", "eval", "main/SiO2/Malitson", "--nm", "587.6"})["k"][0].is_null());
  const json ends = json_of({"nk", "eval", "main/Au/Johnson", "--nm", "187.9,1937"});
  CHECK(ends["n"] == json({1.28, 0.92}));
  const Outcome outside = karat_run({"nk", "eval", "main/Au/Johnson", "--nm", "400,2000"});
  CHECK(outside.code == 3);
  CHECK(outside.out.empty());
  CHECK_THAT(outside.err,
             Contains("main/Au/Johnson") && Contains("187.9 to 1937 nm") && Contains("2000 nm"));
  CHECK(karat_run({"nk", "eval", "Johnson", "--nm", "500"}).code == 3);
}

TEST_CASE("colours agree with sums at 1 nm to 1e-4, at 0 degrees and at acos(1/7)", "[nk-eval]") {
  const Reference reference("spectral_colour_public.json");
  if (reference.value.is_null()) return;
  for (const auto& material : reference.value["materials"]) {
    const std::string name = material["page"];
    INFO(name);
    const json d65 = json_of({"nk", "colour", name});
    check_near(d65["XYZ"], material["D65"]["XYZ"], 1e-4);
    check_near(d65["Lab"], material["D65"]["Lab"], 1e-2);  // 1e-4 in Y is 4e-3 in L* of a metal
    check_near(d65["linear_srgb"], material["D65"]["linear_sRGB_no_adaptation"], 4e-4);
    const json e = json_of({"nk", "colour", name, "--illuminant", "E"});
    check_near(e["XYZ"], material["E"]["XYZ"], 1e-4);
    check_near(e["linear_srgb"], material["E"]["linear_sRGB_bradford_to_D65"], 4e-4);
    const json oblique = json_of({"nk", "colour", name, "--angle", "81.786789298261812"});
    check_near(oblique["XYZ"], material["D65"]["XYZ_theta_acos_1_7"], 1e-4);
  }
}

TEST_CASE("a mirror at grazing incidence is white; sRGB is cut, linear sRGB is not", "[nk-eval]") {
  const json grazing = json_of({"nk", "colour", "main/Au/Johnson", "--angle", "90"});
  check_near(grazing["Lab"], json({100.0, 0.0, 0.0}), 1e-9);
  const json gold = json_of({"nk", "colour", "main/Au/Johnson"});
  CHECK(gold["linear_srgb"][0].get<double>() > 1.0);
  CHECK(gold["srgb"][0] == 1.0);
  CHECK(gold["srgb_hex"].get<std::string>().substr(0, 3) == "#ff");
  CHECK(json_of({"nk", "colour", "Au/Johnson", "Ag/Johnson"}).size() == 2);
}

TEST_CASE("a table that leaves the visible has a colour only when asked to hold its ends",
          "[nk-eval]") {
  const Outcome refused = karat_run({"nk", "colour", "main/Zn/Motulevich"});
  CHECK(refused.code == 3);
  CHECK_THAT(refused.err, Contains("main/Zn/Motulevich") && Contains("covers"));
  const json held = json_of({"nk", "colour", "main/Zn/Motulevich", "--extrapolate", "clamp"});
  CHECK(held["covers_visible"] == false);
  CHECK(karat_run({"nk", "colour", "main/Au/Johnson", "--illuminant", "D66"}).code == 2);
}

TEST_CASE("a comparison: differences are symmetric, the picture is written", "[nk-eval]") {
  const json result = json_of({"nk", "compare", "Au"});
  const json& tables = result["tables"];
  const json& differences = result["ciede2000"];
  REQUIRE(tables.size() >= 10);
  REQUIRE(differences.size() == tables.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    for (std::size_t j = 0; j < tables.size(); ++j) {
      CHECK(differences[i][j] == differences[j][i]);
      if (i == j) CHECK((differences[i][j].is_null() || differences[i][j] == 0.0));
      if (!differences[i][j].is_null())
        largest = std::max(largest, differences[i][j].get<double>());
    }
  }
  CHECK(result["summary"]["largest"] == largest);
  CHECK(largest > 1.0);  // measured gold differs visibly from measured gold

  const fs::path folder = fs::temp_directory_path();
  for (const char* ending : {".png", ".svg"}) {
    const fs::path file = folder / ("karat_compare_" + std::to_string(::getpid()) + ending);
    CHECK(karat_run({"nk", "compare", "Au", "-o", file.string()}).code == 0);
    CHECK(fs::file_size(file) > 5000);
    fs::remove(file);
  }
  CHECK(karat_run({"nk", "compare", "Au", "-o", "gold.jpg"}).code == 2);
  CHECK(karat_run({"nk", "compare", "Au", "-o", "/no/such/folder/gold.png"}).code == 1);
}
