#include "materials/index/index_search.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <thread>

#include "materials/index/index_catalogue.h"
#include "tests/run_cli.h"

namespace {

namespace fs = std::filesystem;
using namespace karat;
using Catch::Contains;
using test::karat_run;

const fs::path kDatabase = fs::path(KARAT_TEST_REFERENCE_DIR) / "refractiveindex.info/database";

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

// A cache of its own and a folder of tables on KARAT_NK_PATH, while it lives.
class Workplace {
 public:
  Workplace() : cache_(variable("XDG_CACHE_HOME")) {
    static int count = 0;
    path_ = fs::temp_directory_path() /
            ("karat_search_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    fs::create_directories(tables());
    setenv("XDG_CACHE_HOME", cache().c_str(), 1);
    setenv("KARAT_NK_PATH", tables().c_str(), 1);
  }
  ~Workplace() {
    unsetenv("KARAT_NK_PATH");
    if (cache_.empty()) {
      unsetenv("XDG_CACHE_HOME");
    } else {
      setenv("XDG_CACHE_HOME", cache_.c_str(), 1);
    }
    fs::remove_all(path_);
  }
  fs::path cache() const { return path_ / "cache"; }
  fs::path tables() const { return path_ / "tables"; }
  fs::path file() const { return index_search_cache_file(tables().string()); }

  void write(const std::string& relative, const std::string& text) const {
    fs::create_directories((tables() / relative).parent_path());
    std::ofstream(tables() / relative) << text;
  }
  void table(const std::string& page, const std::string& reference) const {
    write("main/Xy/nk/" + page + ".yml", "REFERENCES: \"" + reference +
                                             "\"\nDATA:\n  - type: tabulated nk\n    data: |\n"
                                             "        0.3 1 5\n        0.9 1 5\n");
  }

 private:
  fs::path path_;
  std::string cache_;
};

IndexSearchResult search(std::vector<std::string> words) {
  return search_index_tables({std::move(words), std::nullopt, false, ""});
}

std::vector<std::string> names(const IndexSearchResult& result) {
  std::vector<std::string> found;
  for (const IndexSearchHit& hit : result.hits) found.push_back(hit.name);
  return found;
}

bool has(const IndexSearchResult& result, const std::string& name) {
  const auto all = names(result);
  return std::find(all.begin(), all.end(), name) != all.end();
}

}  // namespace

TEST_CASE("element, chemical name, author, year and page find a shipped table",
          "[index][index-search]") {
  const Workplace work;
  for (const std::vector<std::string>& words : {std::vector<std::string>{"Au", "Johnson"},
                                                {"gold", "johnson"},
                                                {"GOLD", "1972"},
                                                {"main/Au/Johnson"},
                                                {"Christy", "gold", "noble"},
                                                {"gol", "john"}}) {
    INFO(words.front());
    const auto result = search(words);
    REQUIRE_FALSE(result.hits.empty());
    CHECK(result.hits.front().name == "main/Au/Johnson");
    CHECK(result.hits.front().facts.samples == 49);
    CHECK(result.hits.front().facts.range.max_nm == 1937.0);
    CHECK(result.hits.front().facts.kind == "nk");
    CHECK(result.storage_problem.empty());
  }
  CHECK(has(search({"brass"}), "other/Cu-Zn/Querry-Cu70Zn30"));
  CHECK(has(search({"Cu-Zn"}), "other/Cu-Zn/Querry-Cu70Zn30"));
  CHECK(has(search({"diamond"}), "main/C/Phillip"));
  CHECK(has(search({"BK7"}), "specs/SCHOTT-optical/N-BK7"));
  CHECK(search({"Rakic"}).hits.size() == search({"Raki\u0107"}).hits.size());
}

TEST_CASE("what a material is called counts more than a mention; whole words more than starts",
          "[index][index-search]") {
  const Workplace work;
  work.write("main/Xy/nk/A.yml",
             "REFERENCES: Optics of zirconia\nDATA:\n  - type: tabulated n\n    data: 0.5 1\n");
  work.write("main/Zirconia/nk/B.yml",
             "REFERENCES: x\nDATA:\n  - type: tabulated n\n    data: 0.5 1\n");
  work.write("main/Zirconiate/nk/C.yml",
             "REFERENCES: x\nDATA:\n  - type: tabulated n\n    data: 0.5 1\n");
  CHECK(names(search({"zirconia"})) ==
        std::vector<std::string>{"main/Zirconia/B", "main/Zirconiate/C", "main/Xy/A"});
}

TEST_CASE("filters: range, kind, metal", "[index][index-search]") {
  const Workplace work;
  const auto visible = search_index_tables({{"Zn"}, kVisible, false, ""});
  CHECK(has(visible, "main/Zn/Werner"));
  CHECK_FALSE(has(visible, "main/Zn/Motulevich"));
  for (const auto& hit : search_index_tables({{}, std::nullopt, false, "n"}).hits)
    CHECK(hit.facts.kind == "n");
  const auto metals = search_index_tables({{}, std::nullopt, true, ""});
  for (const char* name :
       {"main/Au/Johnson", "main/Ag/Johnson", "main/Cu/Johnson", "main/Fe/Johnson",
        "main/Hg/Inagaki", "main/W/Rakic-BB", "main/V/Johnson", "main/Ti/Johnson",
        "other/Cu-Zn/Querry-Cu70Zn30", "other/stainless_steel/Karlsson-ferritic"}) {
    INFO(name);
    CHECK(has(metals, name));
  }
  for (const char* name : {"main/Si/Aspnes", "main/Ge/Aspnes", "main/SiO2/Malitson",
                           "main/H2O/Hale", "main/TiO2/Devore-o", "main/C/Djurisic-o"}) {
    INFO(name);
    CHECK_FALSE(has(metals, name));
  }
}

TEST_CASE("a word that nobody has is answered with the nearest one", "[index][index-search]") {
  const Workplace work;
  const auto result = search({"gold", "jonson"});
  CHECK(result.hits.empty());
  CHECK(result.unknown_word == "jonson");
  CHECK(result.nearest_word == "johnson");
  CHECK(search({"rakci"}).nearest_word == "rakic");
  CHECK(search({"ruby"}).nearest_word != "by");
  CHECK(search({"white"}).nearest_word.empty());
  CHECK(search({"gold", "titanium"}).unknown_word.empty());  // both exist, in no table together
}

TEST_CASE("words that are syntax to SQLite are words", "[index][index-search]") {
  const Workplace work;
  for (const char* word : {"\"", "'", "*", "gold OR silver", "NOT", "NEAR(", "-", "(", "a\"b", ":",
                           "material:gold", "^gold", "", " ", "\xff\xfe", "\u0394"}) {
    INFO(word);
    CHECK_NOTHROW(search({word}));
  }
}

TEST_CASE("a table that is added, changed or removed is seen at once", "[index][index-search]") {
  const Workplace work;
  work.table("A", "Quuxinium by Nobody");
  CHECK(names(search({"quuxinium"})) == std::vector<std::string>{"main/Xy/A"});
  work.table("B", "Quuxinium by Somebody");
  CHECK(search({"quuxinium"}).hits.size() == 2);
  work.table("B", "Another thing");
  CHECK(search({"quuxinium"}).hits.size() == 1);
  fs::remove(work.tables() / "main/Xy/nk/A.yml");
  CHECK(search({"quuxinium"}).hits.empty());
  work.write(
      "catalog-nk.yml",
      "- SHELF: main\n  content:\n    - BOOK: Xy\n      name: Plughium\n      content: []\n");
  CHECK(names(search({"plughium"})) == std::vector<std::string>{"main/Xy/B"});
}

TEST_CASE("a file that is no table is found with its problem", "[index][index-search]") {
  const Workplace work;
  work.table("Good", "Quuxinium");
  work.write("main/Xy/nk/Bad.yml", "REFERENCES: Quuxinium\nDATA: [");
  work.write(
      "main/Xy/nk/Alone.yml",
      "REFERENCES: x\nDATA:\n  - type: tabulated k\n    data: |\n        0.5 1\n        0.6 1\n");
  const auto result = search({"Xy"});
  REQUIRE(result.hits.size() == 3);
  CHECK(result.hits[0].name == "main/Xy/Good");
  for (const auto& hit : result.hits) {
    if (hit.name == "main/Xy/Bad") CHECK_THAT(hit.facts.problem, Contains("YAML"));
    if (hit.name == "main/Xy/Alone") CHECK((hit.facts.kind == "k" && hit.facts.samples == 2));
  }
}

TEST_CASE("a damaged, foreign or unwritable cache changes no answer", "[index][index-search]") {
  const Workplace work;
  for (int i = 0; i < 60; ++i) work.table(fmt::format("P{}", i), fmt::format("Quuxinium {}", i));
  const auto expected = names(search({"quuxinium"}));
  REQUIRE(expected.size() == 60);
  REQUIRE(fs::exists(work.file()));
  const auto size = fs::file_size(work.file());

  std::ofstream(work.file()) << "this is no database";
  CHECK(names(search({"quuxinium"})) == expected);
  CHECK(fs::file_size(work.file()) == size);

  fs::resize_file(work.file(), size / 2);
  CHECK(names(search({"quuxinium"})) == expected);
  CHECK(fs::file_size(work.file()) == size);

  for (std::uintmax_t page = 0; page < size / 4096; ++page) {  // noise in one page at a time
    std::fstream file(work.file(), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(page * 4096 + 100));
    for (int i = 0; i < 1000; ++i) file.put(static_cast<char>(37 * i + 11));
    file.close();
    INFO("page " << page);
    CHECK(names(search({"quuxinium"})) == expected);
  }

  fs::remove(work.file());
  fs::create_directory(work.file());  // where a file should be
  const auto result = search({"quuxinium"});
  CHECK(names(result) == expected);
  CHECK_FALSE(result.storage_problem.empty());
}

TEST_CASE("no cache folder can be made: the answer is the same, and the user is told",
          "[index][index-search]") {
  const Workplace work;
  work.table("A", "Quuxinium");
  std::ofstream(work.cache().string()) << "a file, where a folder should be";
  const auto outcome = karat_run({"nk", "search", "quuxinium"});
  CHECK(outcome.code == 0);
  CHECK_THAT(outcome.out, Contains("main/Xy/A"));
  CHECK_THAT(outcome.err, Contains("not kept"));
}

// What a child process of the next test does: it finds everything, or fails.
TEST_CASE("one process among several", "[.][index-search-child]") {
  if (variable("KARAT_TEST_SEARCH_CHILD").empty()) return;
  CHECK(search({"quuxinium"}).hits.size() == 100);
}

TEST_CASE("processes and threads that build the index at once all get the answer",
          "[index][index-search]") {
  const Workplace work;
  for (int i = 0; i < 100; ++i) work.table(fmt::format("P{}", i), "Quuxinium");
  setenv("KARAT_TEST_SEARCH_CHILD", "1", 1);
  std::vector<pid_t> children;
  for (int i = 0; i < 3; ++i) {
    children.push_back(fork());
    REQUIRE(children.back() >= 0);
    if (children.back() == 0) {
      execl("/proc/self/exe", "karat_tests", "[index-search-child]", "-o", "/dev/null", nullptr);
      _exit(99);
    }
  }
  unsetenv("KARAT_TEST_SEARCH_CHILD");
  std::vector<std::size_t> found(4);
  std::vector<std::thread> threads;
  for (std::size_t& count : found)
    threads.emplace_back([&count] { count = search({"quuxinium"}).hits.size(); });
  for (std::thread& thread : threads) thread.join();
  CHECK(found == std::vector<std::size_t>(4, 100));
  for (const pid_t child : children) {
    int status = 0;
    waitpid(child, &status, 0);
    CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 0));
  }
  for (const auto& entry : fs::directory_iterator(work.file().parent_path()))
    CHECK(entry.path().extension() == ".sqlite");  // no temporary file is left
}

TEST_CASE("the whole database is searched in less than 0.3 s", "[index][index-search]") {
  if (!fs::exists(kDatabase)) {
    WARN("skipped: no " << kDatabase.string());
    return;
  }
  const Workplace work;
  setenv("KARAT_NK_PATH", kDatabase.c_str(), 1);
  CHECK(search({"gold"}).hits.size() > 50);  // builds the index
  double best = 1e9;                         // of processor time: other programs may be running
  for (int i = 0; i < 5; ++i) {
    const std::clock_t start = std::clock();
    CHECK(has(search({"gold", "olmon"}), "main/Au/Olmon-ev"));
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  CHECK(best < 0.3);
  CHECK(search_index_tables({{}, std::nullopt, false, ""}).hits.size() >= 3461);
}
