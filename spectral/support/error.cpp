#include "spectral/support/error.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <limits>
#include <utility>

namespace karat {
namespace {

std::string joined(const std::string& file, const std::string& place, const std::string& message) {
  std::string text;
  for (const std::string& part : {file, place}) {
    if (!part.empty()) text += part + ": ";
  }
  return text + message;
}

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

std::string lower(std::string text) {
  for (char& c : text) c = lower(c);
  return text;
}

// Damerau's edit distance with adjacent transpositions (restricted form, Boytsov 2011, section 2.1)
// in half edits: a change of letter case costs 1, every other edit 2.
int half_edits(const std::string& a, const std::string& b) {
  std::vector<int> before, above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = 2 * static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(above, row);
    row[0] = 2 * static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const char x = a[i - 1], y = b[j - 1];
      const int change = x == y ? 0 : lower(x) == lower(y) ? 1 : 2;
      row[j] = std::min({above[j] + 2, row[j - 1] + 2, above[j - 1] + change});
      if (i > 1 && j > 1 && x == b[j - 2] && a[i - 2] == y) {
        row[j] = std::min(row[j], before[j - 2] + 2);
      }
    }
  }
  return row.back();
}

// Whether `name` is the beginning of `candidate` or a word of it: "radius" in "inner_radius".
bool is_part(const std::string& name, const std::string& candidate) {
  constexpr std::size_t kShortest = 3;
  if (name.size() < kShortest || name.size() >= candidate.size()) return false;
  const std::string part = lower(name), whole = lower(candidate);
  return whole.starts_with(part) || ("_" + whole + "_").find("_" + part + "_") != std::string::npos;
}

// What `name` may have been short for.
std::vector<std::string> names_with_part(const std::string& name,
                                         const std::vector<std::string>& known) {
  std::vector<std::string> wholes;
  std::copy_if(known.begin(), known.end(), std::back_inserter(wholes),
               [&](const std::string& candidate) { return is_part(name, candidate); });
  return wholes;
}

// `"NEAR"`, or `"A" or "B"` where `name` may be short for either; "" when nothing is near.
std::string suggestion(const std::string& name, const std::vector<std::string>& known) {
  const std::string near = nearest_name(name, known);
  if (near.empty()) return "";
  std::string text = "\"" + near + "\"";
  const auto wholes = names_with_part(name, known);
  if (!wholes.empty() && wholes.size() <= 3 && near == wholes.front()) {
    for (std::size_t i = 1; i < wholes.size(); ++i) text += " or \"" + wholes[i] + "\"";
  }
  return text;
}

}  // namespace

InputError::InputError(const std::string& file, const std::string& place,
                       const std::string& message)
    : std::runtime_error(joined(file, place, message)) {}

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
  for (const std::string& candidate : known) {
    if (lower(name) == lower(candidate)) return candidate;
  }
  if (const auto wholes = names_with_part(name, known); !wholes.empty()) return wholes.front();
  std::string nearest;
  int fewest = std::numeric_limits<int>::max();
  for (const std::string& candidate : known) {
    const int edits = half_edits(name, candidate);
    const int allowed = 2 * (static_cast<int>(std::max(name.size(), candidate.size()) + 2) / 4);
    if (edits <= allowed && edits < fewest) {
      fewest = edits;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string unknown_name_message(const std::string& what, const std::string& name,
                                 const std::vector<std::string>& known) {
  constexpr std::size_t kMostListed = 20;
  std::string text = "unknown " + what + " \"" + name + "\"";
  if (const std::string near = suggestion(name, known); !near.empty()) {
    text += "; did you mean " + near + "?";
  } else {
    text += ".";
  }
  text += " Known: ";
  for (std::size_t i = 0; i < std::min(known.size(), kMostListed); ++i) {
    text += (i == 0 ? "" : ", ") + known[i];
  }
  if (known.size() > kMostListed)
    text += ", and " + std::to_string(known.size() - kMostListed) + " more";
  return text + ".";
}

}  // namespace karat
