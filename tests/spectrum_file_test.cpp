#include "spectral/spectrum_file.h"

#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "spectral/support/error.h"

using namespace karat;

namespace {

// The file is read at once, so it need not outlive the call.
SpectrumFile file_with(const std::string& text) {
  const std::string path = (std::filesystem::temp_directory_path() /
                            ("karat_" + std::to_string(getpid()) + "_spectrum_file.json"))
                               .string();
  std::ofstream(path) << text;
  SpectrumFile file(path);
  std::filesystem::remove(path);
  return file;
}

std::string table_with(const std::string& start, const std::string& step,
                       const std::string& values) {
  return R"({"description": "d", "wavelength_nm": {"start": )" + start + R"(, "step": )" + step +
         R"(}, "values": )" + values + "}";
}

}  // namespace

TEST_CASE("A file's table is linear inside and zero outside", "[spectrum_file]") {
  const SpectrumFile file = file_with(table_with("400", "10", "[1, 2, 4]"));
  const SpectrumPtr s = file.table("values", "three");
  CHECK((*s)(400.0) == 1.0);
  CHECK((*s)(405.0) == 1.5);
  CHECK((*s)(420.0) == 4.0);
  CHECK((*s)(399.999) == 0.0);
  CHECK((*s)(420.001) == 0.0);
  CHECK(s->mean({390, 410}) == Approx(0.75));
  CHECK(s->mean({410, 430}) == Approx(1.5));
  CHECK(s->mean({420, 430}) == 0.0);
  CHECK(s->description() == "three");
  CHECK(file.text("description") == "d");
  CHECK(file.number("wavelength_nm/step") == 10.0);
  CHECK_FALSE(file.has("constant"));
}

TEST_CASE("Invalid spectrum files name the place", "[spectrum_file]") {
  for (const char* text : {"", "[", "[]", "7", "{\"values\": NaN}"}) {
    INFO(text);
    CHECK_THROWS_AS(file_with(text), InputError);
  }
  struct Case {
    std::string text, place;
  };
  for (const Case& c :
       {Case{table_with("0", "1", "[1, 2]"), "wavelength_nm/start"},
        Case{table_with("1e300", "1", "[1, 2]"), "wavelength_nm/start"},
        Case{table_with("400", "0", "[1, 2]"), "wavelength_nm/step"},
        Case{table_with("400", "-1", "[1, 2]"), "wavelength_nm/step"},
        Case{table_with("\"400\"", "1", "[1, 2]"), "wavelength_nm/start"},
        Case{table_with("400", "1", "[1, \"2\"]"), "values/1"},
        Case{table_with("400", "1", "[1, 2, null]"), "values/2"},
        Case{table_with("400", "1", "[]"), "values"}, Case{table_with("400", "1", "{}"), "values"},
        Case{R"({"values": [1, 2]})", "wavelength_nm/start"},
        Case{R"({"wavelength_nm": 3, "values": [1, 2]})", "wavelength_nm/start"}}) {
    INFO(c.text);
    const SpectrumFile file = file_with(c.text);
    CHECK_THROWS_WITH(file.table("values", ""), Catch::Contains("_spectrum_file.json: " + c.place));
  }
  CHECK_THROWS_AS(SpectrumFile("/nonexistent.json"), InputError);
}

TEST_CASE("Names of data files are found by listing the folder", "[spectrum_file]") {
  const auto names = data_names("illuminants");
  CHECK(std::is_sorted(names.begin(), names.end()));
  CHECK(std::find(names.begin(), names.end(), "FL3.12") != names.end());
  CHECK(std::filesystem::exists(named_data_file("illuminants", "illuminant", "FL3.12")));
  CHECK_THROWS_WITH(named_data_file("illuminants", "illuminant", "FL13"),
                    Catch::Contains("unknown illuminant \"FL13\""));
}
