#include "materials/index/index_catalogue.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "spectral/support/error.h"

using namespace karat;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

// A folder of tables laid out like the database, on KARAT_NK_PATH while it lives.
class TableFolder {
 public:
  TableFolder() {
    static int count = 0;  // a fresh name each: what a folder holds is remembered per process
    path_ = fs::temp_directory_path() /
            ("karat_index_catalogue_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    fs::create_directories(path_);
    setenv("KARAT_NK_PATH", path_.c_str(), 1);
  }
  ~TableFolder() {
    unsetenv("KARAT_NK_PATH");
    fs::remove_all(path_);
  }
  void write(const std::string& relative, const std::string& text) const {
    fs::create_directories((path_ / relative).parent_path());
    std::ofstream(path_ / relative) << text;
  }
  void table(const std::string& relative, const std::string& n) const {
    write(relative,
          "REFERENCES: x\nDATA:\n  - type: tabulated n\n    data: |\n        0.5 " + n + "\n");
  }
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

constexpr const char* kCatalogue =
    "- SHELF: specs\n  content:\n    - DIVIDER: x\n    - BOOK: MAKER-glass\n      content:\n"
    "        - PAGE: G1\n          data: specs/maker/G1.yml\n"
    "        - PAGE: G2\n          data: specs/maker/G2.yml\n"
    "        - PAGE: G2\n          data: specs/maker/old/G2.yml\n"
    "        - PAGE: G3\n          data: specs/maker/G1.yml\n"
    "        - PAGE: G3\n          data: specs/maker/G1.yml\n";

}  // namespace

TEST_CASE("a shipped table is found by id and by path, and loaded once", "[index][catalogue]") {
  const auto gold = find_index_table("main/Au/Johnson");
  CHECK(gold->provenance().name == "main/Au/Johnson");
  CHECK(gold->at(1937.0).n == 0.92);
  CHECK(gold == find_index_table("main/Au/Johnson"));
  CHECK(find_index_table("main/Au/nk/Johnson.yml")->at(550.0).n == gold->at(550.0).n);
  CHECK(find_index_table(gold->provenance().file)->at(550.0).k == gold->at(550.0).k);
  CHECK(find_index_table("specs/SCHOTT-optical/N-BK7")->at(587.5618).n ==
        Approx(1.5168).margin(5e-6));
  CHECK(find_index_table("3d/metals/brass")->provenance().file ==
        find_index_table("other/Cu-Zn/Querry-Cu70Zn30")->provenance().file);
}

TEST_CASE("an unknown name is answered with the nearest one", "[index][catalogue]") {
  CHECK_THROWS_WITH(find_index_table("main/Au/Jonson"),
                    Contains("unknown index table \"main/Au/Jonson\"") &&
                        Contains("did you mean \"main/Au/Johnson\"?") && Contains("KARAT_NK_PATH"));
  CHECK_THROWS_WITH(find_index_table("3d/metals/bras"), Contains("\"3d/metals/brass\""));
  for (const char* name :
       {"", "/", "///", "..", "main/Au", "../../nk/main/Au/nk/Johnson.yml", "."}) {
    INFO(name);
    CHECK_THROWS_AS(find_index_table(name), InputError);
  }
}

TEST_CASE("folders on KARAT_NK_PATH add tables, with or without a catalogue",
          "[index][catalogue]") {
  const TableFolder folder;
  folder.table("data/main/Xy/nk/Some.yml", "1.25");
  folder.table("data/main/Au/nk/Johnson.yml", "7");
  folder.table("data/specs/maker/G1.yml", "1.75");
  folder.table("data/specs/maker/G2.yml", "1.8");
  folder.table("data/specs/maker/old/G2.yml", "1.9");
  CHECK(find_index_table("main/Xy/Some")->at(500.0).n == 1.25);
  CHECK(find_index_table("main/Au/Johnson")->at(500.0).n < 1.0);  // the earlier folder's
  CHECK(find_index_table("specs/maker/G1.yml")->at(500.0).n == 1.75);
  CHECK(list_index_tables(true).size() == list_index_tables(false).size() + 4);
}

TEST_CASE("the catalogue is read only where the id does not tell the path", "[index][catalogue]") {
  const TableFolder folder;
  folder.table("data/main/Xy/nk/Some.yml", "1.25");
  folder.write("catalog-nk.yml", "- [not a catalogue");
  CHECK(find_index_table("main/Xy/Some")->at(500.0).n == 1.25);
  CHECK_THROWS_WITH(find_index_table("specs/MAKER-glass/G1"),
                    Contains("catalog-nk.yml") && Contains("line"));
}

TEST_CASE("an id of the catalogue names its file; two files are an error that lists them",
          "[index][catalogue]") {
  const TableFolder folder;
  folder.write("catalog-nk.yml", kCatalogue);
  folder.table("data/specs/maker/G1.yml", "1.75");
  folder.table("data/specs/maker/G2.yml", "1.8");
  folder.table("data/specs/maker/old/G2.yml", "1.9");
  CHECK(find_index_table("specs/MAKER-glass/G1")->at(500.0).n == 1.75);
  CHECK(find_index_table("specs/MAKER-glass/G3")->at(500.0).n == 1.75);  // twice the same file
  CHECK_THROWS_WITH(find_index_table("specs/MAKER-glass/G2"),
                    Contains("\"specs/maker/G2.yml\"") && Contains("\"specs/maker/old/G2.yml\""));
  CHECK(find_index_table("specs/maker/old/G2.yml")->at(500.0).n == 1.9);
}

TEST_CASE("every listed name finds its own file, even where the catalogue is wrong",
          "[index][catalogue]") {
  const TableFolder folder;
  folder.write("catalog-nk.yml",
               "- SHELF: main\n  content:\n    - BOOK: Xy\n      content:\n"
               "        - PAGE: A\n          data: main/Zz/nk/A.yml\n");
  folder.table("main/Xy/nk/A.yml", "1.25");
  folder.table("main/Zz/nk/A.yml", "1.75");
  int seen = 0;
  for (const IndexTableEntry& entry : list_index_tables(true)) {
    INFO(entry.name);
    CHECK(find_index_table(entry.name)->provenance().file == entry.file);
    seen += entry.file.starts_with(folder.path());
  }
  CHECK(seen == 2);
}

TEST_CASE("a table that is bad does not hinder the others", "[index][catalogue]") {
  const TableFolder folder;
  folder.table("main/Xy/nk/Good.yml", "1.25");
  folder.write("main/Xy/nk/Bad.yml",
               "REFERENCES: x\nDATA:\n  - type: tabulated n\n    data: |\n        0.5 1,5\n");
  CHECK(find_index_table("main/Xy/Good")->at(500.0).n == 1.25);
  CHECK_THROWS_WITH(
      find_index_table("main/Xy/Bad"),
      Contains(folder.path() + "/main/Xy/nk/Bad.yml") && Contains("line 5") && Contains("\"1,5\""));
}
