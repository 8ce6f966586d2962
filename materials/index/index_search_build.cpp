// Makes, stores and opens the searchable form of a folder.
#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "materials/index/index_folder.h"
#include "materials/index/index_markup.h"
#include "materials/index/index_search_folder.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

namespace fs = std::filesystem;

// "KNKS"; the version is of the tables below and of what is read into them.
constexpr int kApplication = 0x4b4e4b53, kVersion = 2;

constexpr const char* kSchema = R"(
  CREATE TABLE source(folder TEXT, fingerprint TEXT);
  CREATE TABLE pages(id INTEGER PRIMARY KEY, name TEXT, file TEXT, material TEXT, title TEXT,
                     kind TEXT, form TEXT, samples INTEGER, min_nm REAL, max_nm REAL,
                     metal INTEGER, reference TEXT, comments TEXT, conditions TEXT, problem TEXT,
                     names TEXT);
  CREATE VIRTUAL TABLE words USING fts5(material, page, reference, notes, content='',
                                        tokenize='unicode61 remove_diacritics 2');
  CREATE VIRTUAL TABLE vocabulary USING fts5vocab(words, row);
)";

struct Page {
  std::string name, file, material, other_names, section, title;
  std::size_t position = 0;  // in the catalogue
  IndexFacts facts;
};

// "Johnson" of "main/Au/Johnson", "stainless steel" of "other/stainless_steel".
std::string last_part(const std::string& name) {
  std::string part = name.substr(name.rfind('/') + 1);
  std::replace(part.begin(), part.end(), '_', ' ');
  return part;
}

// NAMES of the nearest about.yml above a table: "Gold; Au".
class AboutNames {
 public:
  explicit AboutNames(fs::path root) : root_(std::move(root)) {}

  const std::string& of(const fs::path& folder) {
    const auto known = names_.find(folder.string());
    if (known != names_.end()) return known->second;
    std::string names = read(folder / "about.yml");
    const bool inside = folder != root_ && folder.string().size() > root_.string().size();
    if (names.empty() && inside) names = of(folder.parent_path());
    return names_[folder.string()] = names;
  }

 private:
  static std::string read(const fs::path& file) {
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored) || fs::file_size(file, ignored) > (1u << 20)) return "";
    std::string text;
    try {
      for (const YAML::Node& name : YAML::LoadFile(file.string())["NAMES"]) {
        if (name.IsScalar()) text += (text.empty() ? "" : "; ") + plain_text(name.Scalar());
      }
    } catch (const YAML::Exception&) {
      return "";  // it is no table: nobody must be able to render with it
    }
    return text;
  }

  fs::path root_;
  std::map<std::string, std::string> names_;
};

std::vector<Page> pages_of(const IndexFolder& folder) {
  std::map<std::string, const CataloguePage*> page_of_path;
  std::map<std::string, std::size_t> position_of_path;
  std::multimap<std::string, std::string> ids_of_path;
  const IndexCatalogueFile& catalogue = folder.catalogue_file();
  for (const CataloguePage& page : catalogue.pages) {
    position_of_path.emplace(page.path, position_of_path.size());
    page_of_path.emplace(page.path, &page);
    ids_of_path.emplace(page.path, page.id);
  }
  const std::map<std::string, std::string> books(catalogue.books.begin(), catalogue.books.end());
  AboutNames about(folder.root());
  std::vector<Page> pages;
  for (const auto& [name, file] : folder.list()) {
    Page page{
        name, file, "", about.of(fs::path(file).parent_path()), "", "", catalogue.pages.size(), {}};
    const std::string path = fs::path(file).lexically_relative(folder.root()).generic_string();
    const auto book = books.find(name.substr(0, name.rfind('/')));
    if (book != books.end()) page.material = book->second;
    if (const auto found = page_of_path.find(path); found != page_of_path.end()) {
      if (page.material.empty()) page.material = found->second->book_title;
      page.title = found->second->page_title;
      page.section = found->second->section;
      if (found->second->id == name) page.position = position_of_path.at(path);
      // "3d/crystals/diamond" says what main/C/Phillip is.
      const auto [first, last] = ids_of_path.equal_range(path);
      for (auto id = first; id != last; ++id) {
        if (id->second != name) page.other_names += "; " + last_part(id->second);
      }
    }
    pages.push_back(std::move(page));
  }
  std::stable_sort(pages.begin(), pages.end(),
                   [](const Page& a, const Page& b) { return a.position < b.position; });
  return pages;
}

// What a material is called, each whole name between bars: "|au|gold|" for main/Au, "Au (Gold)".
std::string whole_names(const Page& page) {
  const std::string book = page.name.substr(0, page.name.rfind('/'));
  std::string names = "|", name;
  for (const char c : last_part(book) + ";" + page.material + ";" + page.other_names + ";") {
    if (c != ';' && c != ',' && c != '(' && c != ')') {
      if (c != ' ' || !name.empty())
        name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      continue;
    }
    while (name.ends_with(' ')) name.pop_back();
    if (!name.empty()) names += name + "|";
    name.clear();
  }
  return names;
}

void insert(SqliteDatabase& database, const std::vector<Page>& pages) {
  SqliteStatement row = database.prepare(
      "INSERT INTO pages VALUES(?1,?2,?3,?4,?5,?6,?7,?8,?9,?10,?11,?12,?13,?14,?15,?16)");
  SqliteStatement words = database.prepare(
      "INSERT INTO words(rowid,material,page,reference,notes) "
      "VALUES(?1,?2,?3,?4,?5)");
  std::int64_t id = 0;
  for (const Page& page : pages) {
    const IndexFacts& facts = page.facts;
    row.bind(1, ++id).bind(2, page.name).bind(3, page.file).bind(4, page.material);
    row.bind(5, page.title).bind(6, facts.kind).bind(7, facts.form);
    row.bind(8, static_cast<std::int64_t>(facts.samples)).bind(9, facts.range.min_nm);
    row.bind(10, facts.range.max_nm).bind(11, std::int64_t{facts.metal}).bind(12, facts.reference);
    row.bind(13, facts.comments).bind(14, facts.conditions).bind(15, facts.problem);
    row.bind(16, whole_names(page)).run();
    const std::string book = page.name.substr(0, page.name.rfind('/'));
    words.bind(1, id).bind(2, book + "; " + page.material + "; " + page.other_names);
    words.bind(3, page.name + "; " + page.title + "; " + page.section).bind(4, facts.reference);
    words.bind(5, facts.comments + "; " + facts.conditions).run();
  }
}

// FNV-1a, 64 bits (Fowler, Noll and Vo).
std::uint64_t hash(const std::string& text) {
  std::uint64_t h = 0xcbf29ce484222325u;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return h;
}

std::string cache_folder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value ? value : "");
  };
  if (const std::string cache = variable("XDG_CACHE_HOME"); !cache.empty())
    return (fs::path(cache) / "karat").string();
  const std::string home = variable("HOME");
  return home.empty() ? "" : (fs::path(home) / ".cache/karat").string();
}

}  // namespace

std::string index_search_cache_file(const std::string& folder) {
  const std::string cache = cache_folder();
  return cache.empty() ? "" : fmt::format("{}/nk-search-{:016x}.sqlite", cache, hash(folder));
}

std::string folder_fingerprint(const std::string& folder) {
  // A sum of hashes, so that the order in which a folder lists its files does not matter.
  std::uint64_t sum = 0, count = 0;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    if (it->path().extension() != ".yml") continue;
    std::error_code ignored;
    const auto time = it->last_write_time(ignored).time_since_epoch().count();
    sum += hash(fmt::format("{}\n{}\n{}", it->path().string(), it->file_size(ignored), time));
    ++count;
  }
  return fmt::format("{}-{:016x}", count, sum);
}

SqliteDatabase open_search_database(const std::string& file, const std::string& folder,
                                    const std::string& fingerprint) {
  SqliteDatabase database = SqliteDatabase::open_immutable(file);
  const auto number = [&](const char* pragma) {
    SqliteStatement statement = database.prepare(pragma);
    return statement.step() ? statement.integer(0) : 0;
  };
  if (number("PRAGMA application_id") != kApplication || number("PRAGMA user_version") != kVersion)
    throw SqliteError(file + " is not an index of this version of Karat");
  SqliteStatement source = database.prepare("SELECT folder, fingerprint FROM source");
  if (!source.step() || source.text(0) != folder || source.text(1) != fingerprint)
    throw SqliteError(file + " is out of date");
  SqliteStatement sound = database.prepare("PRAGMA quick_check(1)");
  if (!sound.step() || sound.text(0) != "ok") throw SqliteError(file + " is damaged");
  return database;
}

SqliteDatabase build_search_database(const std::string& folder, const std::string& fingerprint) {
  const IndexFolder tables{folder};
  std::vector<Page> pages = pages_of(tables);
  tbb::parallel_for(std::size_t{0}, pages.size(), [&](std::size_t i) {
    pages[i].facts = index_facts(pages[i].file, pages[i].name);
  });
  SqliteDatabase database;
  database.execute(
      fmt::format("PRAGMA application_id={}; PRAGMA user_version={};", kApplication, kVersion));
  database.execute("BEGIN");
  database.execute(kSchema);
  database.prepare("INSERT INTO source VALUES(?1,?2)").bind(1, folder).bind(2, fingerprint).run();
  insert(database, pages);
  database.execute("INSERT INTO words(words) VALUES('optimize')");
  database.execute("COMMIT");
  return database;
}

void store_search_database(SqliteDatabase& database, const std::string& file) {
  fs::create_directories(fs::path(file).parent_path());
  static std::atomic<int> count{0};
  const std::string own = fmt::format("{}.{}.{}.tmp", file, ::getpid(), ++count);
  try {
    database.prepare("VACUUM INTO ?1").bind(1, own).run();
    fs::rename(own, file);
  } catch (...) {
    std::error_code ignored;
    fs::remove(own, ignored);
    throw;
  }
}

}  // namespace karat
