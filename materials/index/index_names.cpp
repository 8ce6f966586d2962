#include "materials/index/index_names.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <string_view>

#include "spectral/support/error.h"

namespace karat {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::vector<std::string_view> parts_of(std::string_view name) {
  if (name.ends_with(".yml")) name.remove_suffix(4);
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t slash = name.find('/');
    parts.push_back(name.substr(0, slash));
    if (slash == std::string_view::npos) return parts;
    name.remove_prefix(slash + 1);
  }
}

// True where `typed` follows one another in `name`; with `begun` its last part need only be the
// start of one.
bool has_parts(std::string_view name, std::string_view typed, bool begun) {
  const auto whole = parts_of(name), wanted = parts_of(typed);
  const auto equal = [&](const std::string_view& part, const std::string_view& want) {
    return begun && &want == &wanted.back() ? part.starts_with(want) : part == want;
  };
  return std::search(whole.begin(), whole.end(), wanted.begin(), wanted.end(), equal) !=
         whole.end();
}

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

bool has_words(std::string_view title, std::string_view words) {
  for (std::size_t at = title.find(words); at != std::string_view::npos;
       at = title.find(words, at + 1)) {
    const std::size_t end = at + words.size();
    if ((at == 0 || !is_letter(title[at - 1])) && (end == title.size() || !is_letter(title[end])))
      return true;
  }
  return false;
}

}  // namespace

MatchingNames matching_names(const std::string& typed, const std::vector<TitledName>& known) {
  const std::string small = lower(typed);
  if (typed.empty() || typed.front() == '/' || typed.back() == '/') return {};
  const auto matching = [&](NameMatch match, const std::function<bool(const TitledName&)>& accept) {
    MatchingNames result{match, {}};
    for (const TitledName& table : known) {
      if (accept(table)) result.names.push_back(table.name);
    }
    return result;
  };
  const auto tried = {
      std::pair{NameMatch::kParts, std::function<bool(const TitledName&)>([&](const TitledName& t) {
                  return has_parts(t.name, typed, false);
                })},
      {NameMatch::kParts,
       [&](const TitledName& t) { return has_parts(lower(t.name), small, false); }},
      {NameMatch::kTitle, [&](const TitledName& t) { return has_words(lower(t.title), small); }},
      {NameMatch::kStart,
       [&](const TitledName& t) { return has_parts(lower(t.name), small, true); }}};
  for (const auto& [match, accept] : tried) {
    MatchingNames result = matching(match, accept);
    if (!result.names.empty()) return result;
  }
  return {};
}

std::string nearest_full_name(const std::string& typed, const std::vector<std::string>& known) {
  if (std::string near = nearest_name(typed, known); !near.empty()) return near;
  const auto slashes = std::count(typed.begin(), typed.end(), '/');
  std::map<std::string, std::string> name_of_tail;
  std::vector<std::string> tails;
  for (const std::string& name : known) {
    std::size_t start = name.size();
    for (auto i = slashes; i >= 0 && start != std::string::npos && start > 0; --i)
      start = name.rfind('/', start - 1);
    if (start == std::string::npos || start == 0) continue;
    tails.push_back(name.substr(start + 1));
    name_of_tail.emplace(tails.back(), name);
  }
  const std::string near = nearest_name(typed, tails);
  return near.empty() ? "" : name_of_tail.at(near);
}

}  // namespace karat
