// Search in all index tables that can be had by name.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "materials/index/index_facts.h"

namespace karat {

struct IndexSearchQuery {
  // All must occur, each as a word or the start of one, without regard to case and accents, in a
  // table's name, the names of its material, title, reference, comments or conditions. No words
  // find every table.
  std::vector<std::string> words;
  std::optional<WavelengthRange> covers;  // measured in all of it
  bool metal = false;                     // looks_metallic
  std::string kind;                       // "nk", "n", "k", or "" for all
};

struct IndexSearchHit {
  std::string name;  // for find_index_table
  std::string file;
  std::string material;  // "Au (Gold)"; "" where the folder's catalogue does not say
  std::string title;     // "Johnson and Christy 1972: n,k 0.188-1.937 um"
  IndexFacts facts;
  double score = 0.0;  // see search_index_tables
};

struct IndexSearchResult {
  std::vector<IndexSearchHit> hits;
  // A word of the query that no table has, and the nearest that one has; "" where there is none.
  std::string unknown_word, nearest_word;
  // Why the index could not be stored (it is made again the next time); "" where it was.
  std::string storage_problem;
};

// The tables that fit, best first. A word counts 8 in the material's names and in the name's book,
// 5 in its page and title (the author), 2 in the reference, 1 in comments and conditions, and six
// tenths of it where only the start of a word fits; one that is all of what a material is called,
// "gold" but not "gold-silver alloy", counts 4 more. Of equal scores those come first that cover
// the visible with n and k, then those of earlier folders, then the catalogue's order.
//
// Each folder's words are stored in the file index_search_cache_file(folder), a SQLite database
// that is made anew when a table or catalogue in the folder appeared, vanished or has another size
// or time. It is written beside its place and renamed, so that processes which build it at once do
// not disturb each other; a file that is damaged or something else is replaced; where none can be
// written the answer is the same.
IndexSearchResult search_index_tables(const IndexSearchQuery& query);

// In $XDG_CACHE_HOME/karat, or ~/.cache/karat; "" where neither variable is set.
std::string index_search_cache_file(const std::string& folder);

}  // namespace karat
