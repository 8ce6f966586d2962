// What a folder's search database answers.
#include <algorithm>
#include <cctype>
#include <unordered_map>

#include "materials/index/index_coverage.h"
#include "materials/index/index_search_folder.h"

namespace karat {
namespace {

struct Column {
  const char* name;
  double weight;
};
constexpr Column kColumns[]{{"material", 8.0}, {"page", 5.0}, {"reference", 2.0}, {"notes", 1.0}};
constexpr double kStartOnly = 0.6, kWholeName = 4.0;

// A word as a phrase of FTS5: whatever separates its parts, as in Cu-Zn, they must follow another.
std::string phrase(const std::string& word) {
  std::string quoted(1, '"');
  for (const char c : word) {
    if (c == '"') quoted.push_back(c);
    quoted.push_back(c);
  }
  quoted.push_back('"');
  return quoted;
}

using Scores = std::unordered_map<std::int64_t, double>;

// The best weight with which each page has the word.
Scores word_scores(const SqliteDatabase& database, const std::string& word) {
  Scores scores;
  SqliteStatement match = database.prepare("SELECT rowid FROM words WHERE words MATCH ?1");
  for (const Column& column : kColumns) {
    for (const bool whole : {true, false}) {
      const double weight = column.weight * (whole ? 1.0 : kStartOnly);
      match.bind(1, std::string(column.name) + " : " + phrase(word) + (whole ? "" : " *"));
      while (match.step()) {
        double& score = scores[match.integer(0)];
        score = std::max(score, weight);
      }
      match.reset();
    }
  }
  return scores;
}

// Sums over the words, of the pages that have all of them.
Scores scores_of(const SqliteDatabase& database, const std::vector<std::string>& words) {
  Scores sums = word_scores(database, words.front());
  for (std::size_t i = 1; i < words.size(); ++i) {
    const Scores more = word_scores(database, words[i]);
    for (auto it = sums.begin(); it != sums.end();) {
      const auto found = more.find(it->first);
      if (found == more.end()) {
        it = sums.erase(it);
      } else {
        (it++)->second += found->second;
      }
    }
  }
  return sums;
}

// For words that are all of what a material is called, singly ("gold", but not for gold-silver
// alloy) or together ("stainless steel").
double whole_name_bonus(const std::string& names, const std::vector<std::string>& words) {
  const auto is_name = [&](const std::string& text) {
    std::string sought(1, '|');
    sought.append(text).push_back('|');
    for (char& c : sought) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return names.find(sought) != std::string::npos;
  };
  double bonus = 0.0;
  std::string all;
  for (const std::string& word : words) {
    bonus += is_name(word) ? kWholeName : 0.0;
    all += (all.empty() ? "" : " ") + word;
  }
  return bonus > 0.0 || !is_name(all) ? bonus : kWholeName;
}

bool fits(const IndexFacts& facts, const IndexSearchQuery& query) {
  return (query.kind.empty() || facts.kind == query.kind) && (!query.metal || facts.metal) &&
         (!query.covers || is_covered(facts.range, *query.covers));
}

}  // namespace

std::vector<IndexSearchHit> search_database(const SqliteDatabase& database,
                                            const IndexSearchQuery& query) {
  Scores scores;
  if (!query.words.empty()) scores = scores_of(database, query.words);
  std::vector<IndexSearchHit> hits;
  SqliteStatement row = database.prepare(
      "SELECT id, name, file, material, title, kind, form, samples, min_nm, max_nm, metal, "
      "reference, comments, conditions, problem, names FROM pages ORDER BY id");
  while (row.step()) {
    const auto score = scores.find(row.integer(0));
    if (!query.words.empty() && score == scores.end()) continue;
    IndexFacts facts{row.text(5),
                     row.text(6),
                     static_cast<std::size_t>(row.integer(7)),
                     {row.real(8), row.real(9)},
                     row.integer(10) != 0,
                     row.text(11),
                     row.text(12),
                     row.text(13),
                     row.text(14)};
    if (!fits(facts, query)) continue;
    const double bonus = whole_name_bonus(row.text(15), query.words);
    hits.push_back({row.text(1), row.text(2), row.text(3), row.text(4), std::move(facts),
                    score == scores.end() ? 0.0 : score->second + bonus});
  }
  return hits;
}

bool has_word(const SqliteDatabase& database, const std::string& word) {
  SqliteStatement match = database.prepare("SELECT rowid FROM words WHERE words MATCH ?1 LIMIT 1");
  return match.bind(1, phrase(word) + " *").step();
}

std::vector<std::string> all_words(const SqliteDatabase& database) {
  std::vector<std::string> words;
  SqliteStatement row = database.prepare("SELECT term FROM vocabulary");
  while (row.step()) words.push_back(row.text(0));
  return words;
}

}  // namespace karat
