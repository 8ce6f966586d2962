#include "materials/index/index_search.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <set>

#include "materials/index/index_coverage.h"
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

std::multiset<std::string> letter_pairs(const std::string& word) {
  std::multiset<std::string> pairs;
  for (std::size_t i = 0; i + 1 < word.size(); ++i) pairs.insert(word.substr(i, 2));
  return pairs;
}

// Whether one word may be a slip for the other: half of their pairs of letters are the same (Dice
// 1945), or all letters in another order. "white" is none for "with".
bool are_alike(const std::string& typed, const std::string& word) {
  const auto letters = [](std::string text) {
    std::sort(text.begin(), text.end());
    return text;
  };
  if (letters(typed) == letters(word)) return true;
  const auto a = letter_pairs(typed), b = letter_pairs(word);
  std::vector<std::string> shared;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
  return 4 * shared.size() >= a.size() + b.size();
}

// Words of which references are full, and which nobody looks for.
bool is_stop_word(const std::string& word) {
  static const std::set<std::string> words{
      "after", "also", "and",  "are",   "been",  "between", "both",  "from", "have", "into",
      "only",  "that", "than", "their", "then",  "these",   "the",   "this", "for",  "used",
      "using", "was",  "were", "when",  "where", "which",   "while", "with"};
  return words.count(word) > 0;
}

std::string nearest_word(std::string typed, const std::vector<std::string>& words) {
  constexpr std::size_t kShortest = 3;
  for (char& c : typed) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  std::vector<std::string> candidates;
  std::copy_if(words.begin(), words.end(), std::back_inserter(candidates),
               [&](const std::string& word) {
                 return word.size() >= kShortest && !is_stop_word(word) && are_alike(typed, word);
               });
  return nearest_name(typed, candidates);
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
    result.nearest_word = nearest_word(word, others);
    return;
  }
}

bool is_usual(const IndexSearchHit& hit) {
  return hit.facts.kind == "nk" && is_covered(hit.facts.range, kVisible);
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
