// karat nk add, remove, path and fetch-help.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/karat/run_karat.h"
#include "materials/index/index_catalogue.h"
#include "materials/index/index_path.h"
#include "render/scene_loader.h"
#include "spectral/support/error.h"
#include "tests/imported.h"
#include "tests/scene_text.h"

using namespace karat;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

// A user's folder of its own, and a file glass.csv, while it lives.
class User {
 public:
  User() {
    static int count = 0;  // a fresh name each: what a folder holds is remembered per process
    path_ = fs::temp_directory_path() /
            ("karat_nk_add_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    fs::create_directories(path_);
    setenv("XDG_DATA_HOME", (path_ / "share").c_str(), 1);
    std::ofstream(file("glass.csv")) << "wavelength_nm,n,k\n" << glass_rows();
  }
  ~User() {
    unsetenv("XDG_DATA_HOME");
    unsetenv("KARAT_NK_PATH");
    fs::remove_all(path_);
  }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  fs::path tables() const { return path_ / "share/karat/nk"; }

 private:
  fs::path path_;
};

struct Outcome {
  int code;
  std::string out, err;
};

// Runs the program with its two outputs in files.
Outcome karat_run(const User& user, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"karat", "nk"});
  std::vector<const char*> argv;
  for (const auto& argument : arguments) argv.push_back(argument.c_str());
  Outcome outcome{};
  std::fflush(nullptr);
  const int saved[2] = {dup(STDOUT_FILENO), dup(STDERR_FILENO)};
  std::string* const texts[2] = {&outcome.out, &outcome.err};
  const std::string names[2] = {user.file("out"), user.file("err")};
  for (int i = 0; i < 2; ++i) {
    std::FILE* file = std::fopen(names[i].c_str(), "w");
    dup2(fileno(file), i == 0 ? STDOUT_FILENO : STDERR_FILENO);
    std::fclose(file);
  }
  outcome.code = run_karat(static_cast<int>(argv.size()), argv.data());
  std::fflush(nullptr);
  for (int i = 0; i < 2; ++i) {
    dup2(saved[i], i == 0 ? STDOUT_FILENO : STDERR_FILENO);
    close(saved[i]);
    std::ifstream stream(names[i]);
    texts[i]->assign(std::istreambuf_iterator<char>(stream), {});
  }
  return outcome;
}

Outcome add(const User& user, const std::string& name, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"add", user.file("glass.csv"), "--name",
                                     name,  "--reference",          "A. Author, 2026"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return karat_run(user, arguments);
}

}  // namespace

TEST_CASE("a table that was added is shown, found and used by a scene at once", "[nk][add]") {
  const User user;
  const Outcome added = add(user, "my/glass/film");
  INFO(added.err);
  REQUIRE(added.code == 0);
  CHECK_THAT(added.out,
             Contains("read as     comma-separated text; column 1 wavelength, 2 n, 3 k") &&
                 Contains("unit        nm (line 1)") &&
                 Contains("rows        21, 21 of them in 380 to 780 nm") &&
                 Contains("covers 380 to 780 nm") && Contains("F0 (D65)") &&
                 Contains("karat nk show my/glass/film"));
  CHECK(fs::exists(user.tables() / "my/glass/nk/film.yml"));
  const Outcome shown = karat_run(user, {"show", "my/glass/film", "--nm", "400", "--json"});
  REQUIRE(shown.code == 0);
  CHECK(nlohmann::json::parse(shown.out)["values"][0]["n"] == 1.52);
  CHECK(find_index_table("my/glass/film")->provenance().reference == "A. Author, 2026");
  CHECK(karat_run(user, {"path", "my/glass/film"}).out ==
        (user.tables() / "my/glass/nk/film.yml").string() + "\n");
  CHECK_THAT(karat_run(user, {"list", "my/"}).out, Contains("my/glass/film"));
  nlohmann::json scene = small_scene();
  scene["materials"]["film"] = {{"type", "conductor"}, {"nk", "my/glass/film"}};
  CHECK_NOTHROW(load_scene_text(scene.dump(), "scene.json", "."));
}

TEST_CASE("nothing is overwritten, hidden or written by accident", "[nk][add]") {
  const User user;
  CHECK(add(user, "my/glass/film", {"--dry-run"}).code == 0);
  CHECK_FALSE(fs::exists(user.tables()));
  REQUIRE(add(user, "my/glass/film").code == 0);
  const Outcome again = add(user, "my/glass/film");
  CHECK(again.code == 3);
  CHECK_THAT(again.err, Contains("exists already") && Contains("--force replaces it"));
  const Outcome forced = add(user, "my/glass/film", {"--force", "--json"});
  CHECK(forced.code == 0);
  const auto facts = nlohmann::json::parse(forced.out);
  CHECK(facts["rows"] == 21);
  CHECK(facts["written"] == true);
  CHECK(facts["range_nm"][1].get<double>() == Approx(780.0));
  const Outcome own = add(user, "main/Au/Johnson", {"--force"});
  CHECK(own.code == 3);
  CHECK_THAT(own.err, Contains("one of Karat's own tables") && Contains("my/Au/Johnson"));
  // A refused table leaves nothing behind.
  CHECK(add(user, "my/glass/other", {"--unit", "um"}).code == 3);
  CHECK_FALSE(fs::exists(user.tables() / "my/glass/nk/other.yml"));
}

TEST_CASE("--columns ends where the file begins", "[nk][add]") {
  const User user;
  const Outcome outcome =
      karat_run(user, {"add", "--columns", "wavelength,-,n", user.file("glass.csv"), "--name",
                       "my/glass/film", "--reference", "x", "--unit", "nm", "--json"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(nlohmann::json::parse(outcome.out)["n"][1] == 0.0078);
}

TEST_CASE("names that cannot be kept, and options that are missing", "[nk][add]") {
  const User user;
  for (const char* name : {"film", "my/film", "a/b/c/d", "/b/c", "a//c", "a/b/", "../b/c", "a/../c",
                           "a/b/.c", "a/b/c d", "a/b/c\n", "data/b/c", "a/b/c.yml", "a/b/-c", ""}) {
    INFO(name);
    const Outcome outcome = add(user, name);
    CHECK(outcome.code == 3);
    CHECK_THAT(outcome.err, Contains("a table cannot be called") && Contains("SHELF/BOOK/PAGE"));
  }
  CHECK_FALSE(fs::exists(user.tables()));
  const Outcome no_reference =
      karat_run(user, {"add", user.file("glass.csv"), "--name", "my/glass/film"});
  CHECK(no_reference.code == 2);
  CHECK_THAT(no_reference.err, Contains("--reference: is required"));
  CHECK(karat_run(user, {"add", user.file("glass.csv")}).code == 2);
  const Outcome unit = add(user, "my/glass/film", {"--unit", "nmm"});
  CHECK(unit.code == 2);
  CHECK_THAT(unit.err, Contains("unknown unit \"nmm\"; did you mean \"nm\"?"));
  CHECK_THAT(karat_run(user, {"add", "none.csv", "--name", "a/b/c", "--reference", "x"}).err,
             Contains("none.csv: no such file"));
}

TEST_CASE("only tables of one's own are removed", "[nk][remove]") {
  const User user;
  CHECK_THAT(karat_run(user, {"remove", "my/glass/film"}).err,
             Contains("there are no tables of your own"));
  REQUIRE(add(user, "my/glass/film").code == 0);
  REQUIRE(add(user, "my/glass/other").code == 0);
  const Outcome own = karat_run(user, {"remove", "main/Au/Johnson"});
  CHECK(own.code == 3);
  CHECK_THAT(own.err, Contains("one of Karat's own tables; only tables in"));
  CHECK(fs::exists(find_index_table("main/Au/Johnson")->provenance().file));
  CHECK_THAT(karat_run(user, {"remove", "my/glass/flm"}).err,
             Contains("did you mean \"my/glass/film\"?"));
  CHECK(karat_run(user, {"remove", "../../../glass.csv"}).code == 3);
  CHECK(karat_run(user, {"remove", "my/glass/film"}).code == 0);
  CHECK_FALSE(fs::exists(user.tables() / "my/glass/nk/film.yml"));
  CHECK(fs::exists(user.tables() / "my/glass/nk/other.yml"));
  CHECK(karat_run(user, {"remove", "my/glass/nk/other.yml"}).code == 0);
  CHECK_FALSE(fs::exists(user.tables() / "my"));
  CHECK(fs::exists(user.tables()));
}

TEST_CASE("tables of KARAT_NK_PATH are neither removed nor hidden in silence", "[nk][remove]") {
  const User user;
  REQUIRE(add(user, "my/glass/film").code == 0);
  fs::create_directories(user.file("more"));
  fs::rename(user.tables() / "my", fs::path(user.file("more")) / "my");
  setenv("KARAT_NK_PATH", (user.file("more") + "::/nonexistent").c_str(), 1);
  const Outcome removed = karat_run(user, {"remove", "my/glass/film"});
  CHECK(removed.code == 3);
  CHECK_THAT(removed.err, Contains("is in KARAT_NK_PATH"));
  CHECK_THAT(add(user, "my/glass/film").out,
             Contains("comes before the table of the same name in KARAT_NK_PATH"));
  const auto folders = nlohmann::json::parse(karat_run(user, {"path", "--json"}).out);
  REQUIRE(folders.size() == 4);
  CHECK(folders[0]["origin"] == "Karat's own");
  CHECK(folders[1]["folder"] == user.tables().string());
  CHECK(folders[2]["exists"] == true);
  CHECK(folders[3]["folder"] == "/nonexistent");
  CHECK(folders[3]["exists"] == false);
  CHECK_THAT(karat_run(user, {"path"}).out, Contains("/nonexistent  (does not exist)"));
}

TEST_CASE("how to get the whole database", "[nk]") {
  const User user;
  CHECK_THAT(karat_run(user, {"fetch-help"}).out,
             Contains("git clone --depth 1 "
                      "https://github.com/polyanskiy/refractiveindex.info-database.git") &&
                 Contains("KARAT_NK_PATH"));
}
