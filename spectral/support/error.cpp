#include "spectral/support/error.h"

#include <algorithm>
#include <cctype>
#include <limits>

namespace karat {
namespace {

std::string joined(const std::string& file, const std::string& place, const std::string& message) {
  std::string text;
  for (const std::string& part : {file, place}) {
    if (!part.empty()) text += part + ": ";
  }
  return text + message;
}

// Levenshtein distance in half edits: a change of letter case costs 1, every other edit 2.
int half_edits(const std::string& a, const std::string& b) {
  std::vector<int> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = 2 * static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int diagonal = row[0];
    row[0] = 2 * static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const auto x = static_cast<unsigned char>(a[i - 1]), y = static_cast<unsigned char>(b[j - 1]);
      const int change = x == y ? 0 : std::tolower(x) == std::tolower(y) ? 1 : 2;
      const int best = std::min({row[j] + 2, row[j - 1] + 2, diagonal + change});
      diagonal = row[j];
      row[j] = best;
    }
  }
  return row.back();
}

}  // namespace

InputError::InputError(const std::string& file, const std::string& place,
                       const std::string& message)
    : std::runtime_error(joined(file, place, message)) {}

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
  std::string nearest;
  int fewest = std::numeric_limits<int>::max();
  for (const std::string& candidate : known) {
    const int edits = half_edits(name, candidate);
    const int allowed = 2 * static_cast<int>(std::max(name.size(), candidate.size()) + 2) / 3;
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
  if (const std::string near = nearest_name(name, known); !near.empty()) {
    text += "; did you mean \"" + near + "\"?";
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
