// What a scene names: tables, files beside it, presets of alloys, columns of spectra.
#include "render/named_index.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "render/alloy_presets.h"
#include "render/scene_path.h"
#include "render/spectrum_columns.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using Catch::Matchers::Contains;
namespace fs = std::filesystem;

constexpr const char* kTable =
    "REFERENCES: x\nDATA:\n  - type: tabulated nk\n    data: |\n        0.3 1.5 2\n        0.9 1.5 "
    "2\n";

// A scene's folder; the user's data lie in it too while it lives.
class SceneFolder {
 public:
  SceneFolder() {
    static int count = 0;
    path_ = fs::temp_directory_path() /
            ("karat_named_index_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    fs::create_directories(path_);
    if (const char* home = std::getenv("XDG_DATA_HOME")) old_ = home;
    setenv("XDG_DATA_HOME", path_.c_str(), 1);
  }
  ~SceneFolder() {
    if (old_.empty()) {
      unsetenv("XDG_DATA_HOME");
    } else {
      setenv("XDG_DATA_HOME", old_.c_str(), 1);
    }
    fs::remove_all(path_);
  }
  void write(const std::string& relative, const std::string& text) const {
    fs::create_directories((path_ / relative).parent_path());
    std::ofstream(path_ / relative) << text;
  }
  const fs::path& path() const { return path_; }

  IndexTablePtr read(const Json& nk) const {
    ReadContext context;
    context.directory = path_.string();
    std::vector<std::string> warnings;
    std::vector<Provenance> tables;
    context.warnings = &warnings, context.tables = &tables;
    return read_index(JsonValue(nk, "scene.json", "/nk"), context);
  }
  std::string error(const Json& nk) const {
    try {
      read(nk);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

 private:
  fs::path path_;
  std::string old_;
};

SpectrumPtr columns(const std::string& text, const Allowed& allowed = {0.0, 1.0}) {
  return spectrum_of_text(text, "refl.csv", allowed);
}

}  // namespace

TEST_CASE("a table's file beside the scene comes first", "[named_index]") {
  const SceneFolder folder;
  folder.write("main/Au/nk/Johnson.yml", kTable);
  CHECK(folder.read("main/Au/nk/Johnson.yml")->at(500.0).n == 1.5);
  CHECK(folder.read("main/Au/Johnson")->at(500.0).n < 1.0);
}

TEST_CASE("what is no table is told what it is", "[named_index]") {
  const SceneFolder folder;
  folder.write("tin/tin.csv", "nm,n,k\n380,1,2\n780,1,2\n");
  folder.write("tin/tin.yml", kTable);
  CHECK_THAT(folder.error("rose-gold-18k"),
             Contains("is an alloy") && Contains("{\"alloy\": \"rose-gold-18k\"}"));
  CHECK_THAT(folder.error("tin/tin.csv"), Contains("karat nk add") && Contains("tin/tin.csv"));
  CHECK_THAT(folder.error("tin/tinn.yml"),
             Contains("scene.json: /nk: no such file: looked for " + folder.path().string()) &&
                 Contains(fs::current_path().string()) && Contains("data/nk") &&
                 Contains("did you mean \"tin/tin.yml\"?") && !Contains("unknown"));
  CHECK_THAT(folder.error("Au"), Contains("main/Au/Johnson") && !Contains("Ag"));
}

TEST_CASE("files of a scene are looked for beside it, then in the working folder",
          "[named_index]") {
  const SceneFolder folder, elsewhere;
  folder.write("both.spd", "1");
  elsewhere.write("both.spd", "2");
  elsewhere.write("here.spd", "3");
  ReadContext context;
  context.directory = folder.path().string();
  const fs::path old = fs::current_path();
  fs::current_path(elsewhere.path());
  CHECK(find_scene_file("both.spd", context) == (folder.path() / "both.spd").string());
  CHECK(find_scene_file("here.spd", context) == (elsewhere.path() / "here.spd").string());
  CHECK_FALSE(find_scene_file("none.spd", context));
  CHECK_FALSE(find_scene_file("", context));
  fs::current_path(old);
}

TEST_CASE("the user's own presets of alloys, after Karat's", "[named_index]") {
  const SceneFolder folder;
  folder.write("karat/alloys/mine.json",
               R"({"description": "mine", "source": "me", "nk": {"eta": 1.25, "k": 2}})");
  folder.write("karat/alloys/sterling-silver.json", "{");
  folder.write("karat/alloys/loop.json",
               R"({"description": "x", "source": "x", "nk": {"alloy": "loop"}})");
  CHECK(folder.read({{"alloy", "mine"}})->at(500.0).n == 1.25);
  CHECK_NOTHROW(folder.read({{"alloy", "sterling-silver"}}));
  CHECK_THAT(folder.error({{"alloy", "loop"}}), Contains("nested deeper than 16"));
  CHECK_THAT(folder.error({{"alloy", "mime"}}), Contains("did you mean \"mine\"?"));
  CHECK_THAT(folder.error("mine"), Contains("is an alloy"));
}

TEST_CASE("columns of a spectrum: any separator, names above, another unit", "[named_index]") {
  for (const char* text :
       {"380 0.1\n780 0.3\n", "380,0.1\n780,0.3\n", "380;0,1\n780;0,3\n",
        "\xef\xbb\xbfWavelength (nm)\tR\r\n380\t0.1\r\n780\t0.3\r\n", "# x\n780 0.3\n380 0.1 # y\n",
        "Wavelength (um),R\n0.38,0.1\n0.78,0.3\n"}) {
    INFO(text);
    const SpectrumPtr spectrum = columns(text);
    CHECK(spectrum->range().min_nm == Approx(380.0).epsilon(1e-12));
    CHECK((*spectrum)(580.0) == Approx(0.2).epsilon(1e-12));
  }
}

TEST_CASE("columns that are no spectrum: file and line", "[named_index]") {
  CHECK_THROWS_WITH(columns("380,0.1\n780,x\n"), Contains("refl.csv: line 2, column 2"));
  CHECK_THROWS_WITH(columns("380,0.1,3\n"), Contains("refl.csv: line 1") && Contains("allowed"));
  CHECK_THROWS_WITH(columns("380 0.1\n780 45\n"), Contains("line 2: found 45, allowed: 0 to 1"));
  CHECK_THROWS_WITH(columns("380 0.1\nnm R\n780 1\n"), Contains("line 2"));
  CHECK_THROWS_WITH(columns("380 0.1\n500 1\n400 1\n"), Contains("must increase"));
  CHECK_THROWS_WITH(columns("0 0.1\n"), Contains("line 1"));
  CHECK_THROWS_WITH(columns("# nothing\n"), Contains("at least one row"));
  const SceneFolder folder;
  folder.write("refl.csv", "380,0.1\n780,x\n");
  CHECK_THAT(folder.error({{"eta", {{"file", "refl.csv"}}}}),
             Contains("scene.json: /nk/eta/file: ") && Contains("refl.csv: line 2"));
}

}  // namespace karat
