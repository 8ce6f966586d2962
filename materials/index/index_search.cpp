#include "materials/index/index_search.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "materials/index/index_path.h"
#include "materials/index/index_search_folder.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

namespace fs = std::filesystem;

SqliteDatabase rebuilt(const std::string& folder, const std::string& fingerprint,
                       std::string& problem) {
  SqliteDatabase database = build_search_database(folder, fingerprint);
  const std::string file = index_search_cache_file(folder);
  try {
    if (file.empty()) throw SqliteError("neither XDG_CACHE_HOME nor HOME is set");
    store_search_database(database, file);
  } catch (const std::exception& error) {
    problem = error.what();
  }
  return database;
}

// Calls `use` with the folder's database: the stored one where it is sound and up to date. Damage
// that shows only when it is read ends in a second try, with a new one.
void with_database(const std::string& folder, std::string& problem,
                   const std::function<void(const SqliteDatabase&)>& use) {
  const std::string fingerprint = folder_fingerprint(folder);
  try {
    return use(open_search_database(index_search_cache_file(folder), folder, fingerprint));
  } catch (const SqliteError&) {
  }
  use(rebuilt(folder, fingerprint, problem));
}

// Why nothing was found: the first word that no table has, and its neighbour.
void explain(const std::vector<std::string>& words, const std::vector<std::string>& folders,
             IndexSearchResult& result) {
  std::set<std::string> known;
  std::vector<std::string> others;
  for (const std::string& folder : folders) {
    with_database(folder, result.storage_problem, [&](const SqliteDatabase& database) {
      for (const std::string& word : words) {
        if (has_word(database, word)) known.insert(word);
      }
      const std::vector<std::string> more = all_words(database);
      others.insert(others.end(), more.begin(), more.end());
    });
  }
  for (const std::string& word : words) {
    if (known.count(word) > 0) continue;
    result.unknown_word = word;
    result.nearest_word = nearest_name(word, others);
    return;
  }
}

bool is_usual(const IndexSearchHit& hit) {
  return hit.facts.kind == "nk" && hit.facts.range.covers(kVisible);
}

}  // namespace

IndexSearchResult search_index_tables(const IndexSearchQuery& query) {
  IndexSearchResult result;
  std::map<std::string, std::size_t> place;  // of a name in the hits
  std::vector<std::string> folders;
  for (const IndexPathEntry& entry : index_path()) {
    if (entry.exists()) folders.push_back(fs::absolute(entry.folder).lexically_normal().string());
  }
  for (const std::string& folder : folders) {
    with_database(folder, result.storage_problem, [&](const SqliteDatabase& database) {
      for (IndexSearchHit& hit : search_database(database, query)) {
        const auto [known, is_new] = place.emplace(hit.name, result.hits.size());
        if (is_new) {
          result.hits.push_back(std::move(hit));
        } else if (std::string& title = result.hits[known->second].title; title.empty()) {
          title = hit.title;  // the same table, from a folder whose catalogue has titles
        }
      }
    });
  }
  std::stable_sort(result.hits.begin(), result.hits.end(),
                   [](const IndexSearchHit& a, const IndexSearchHit& b) {
                     if (a.score != b.score) return a.score > b.score;
                     return is_usual(a) && !is_usual(b);
                   });
  if (result.hits.empty()) explain(query.words, folders, result);
  return result;
}

}  // namespace karat
