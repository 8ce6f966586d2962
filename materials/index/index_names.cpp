#include "materials/index/index_names.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <iterator>
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

// With `hyphens` "gold" is no word of "gold-silver alloy".
bool has_words(std::string_view title, std::string_view words, bool hyphens = false) {
  const auto is_letter = [hyphens](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || (hyphens && c == '-');
  };
  for (std::size_t at = title.find(words); at != std::string_view::npos;
       at = title.find(words, at + 1)) {
    const std::size_t end = at + words.size();
    if ((at == 0 || !is_letter(title[at - 1])) && (end == title.size() || !is_letter(title[end])))
      return true;
  }
  return false;
}

struct PageOfBook {
  std::string_view book, page;
};

// "main/Au/nk/Johnson.yml" and "main/Au/Johnson" alike: book "main/Au", page "Johnson".
PageOfBook page_of_book(std::string_view name) {
  if (name.ends_with(".yml")) name.remove_suffix(4);
  const std::size_t slash = name.rfind('/');
  if (slash == std::string_view::npos) return {"", name};
  PageOfBook parts{name.substr(0, slash), name.substr(slash + 1)};
  if (parts.book.ends_with("/nk")) parts.book.remove_suffix(3);
  return parts;
}

// "main/Au" and "Au" name the book main/Au, "main" does not.
bool names_book(std::string_view typed, std::string_view book) {
  if (typed.empty() || !book.ends_with(typed)) return false;
  return book.size() == typed.size() || book[book.size() - typed.size() - 1] == '/';
}

// The tables of the book `typed`: by its letters, then in either case, then by its title ("gold"),
// then by its last part alone, for a slip in the shelf.
std::vector<TitledName> tables_of_book(std::string_view typed,
                                       const std::vector<TitledName>& known) {
  const std::string small = lower(std::string(typed));
  const auto filtered = [&](const std::function<bool(const TitledName&)>& accept) {
    std::vector<TitledName> tables;
    std::copy_if(known.begin(), known.end(), std::back_inserter(tables), accept);
    return tables;
  };
  auto found =
      filtered([&](const TitledName& t) { return names_book(typed, page_of_book(t.name).book); });
  if (!found.empty()) return found;
  found = filtered([&](const TitledName& t) {
    return names_book(small, lower(std::string(page_of_book(t.name).book)));
  });
  if (!found.empty()) return found;
  const std::size_t slash = typed.rfind('/');
  if (slash != std::string_view::npos) return tables_of_book(typed.substr(slash + 1), known);
  return filtered([&](const TitledName& t) {
    return !small.empty() && has_words(lower(t.title), small, true);
  });
}

// Where no part fits: the nearest page of the book that was typed, or else all its pages; of a page
// without its book, all tables that are called so.
std::vector<std::string> names_near(const std::string& typed,
                                    const std::vector<TitledName>& known) {
  constexpr std::size_t kShortestMended = 4;  // "Ru" is no slip for "Au"
  const PageOfBook wanted = page_of_book(typed);
  if (wanted.book.empty() && wanted.page.size() < kShortestMended) return {};
  const std::vector<TitledName> pool =
      wanted.book.empty() ? known : tables_of_book(wanted.book, known);
  std::vector<std::string> pages, names;
  for (const TitledName& table : pool) pages.emplace_back(page_of_book(table.name).page);
  const std::string near = nearest_name(std::string(wanted.page), pages);
  for (std::size_t i = 0; i < pool.size(); ++i) {
    if (near.empty() ? !wanted.book.empty() : pages[i] == near) names.push_back(pool[i].name);
  }
  return names;
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

std::string name_hint(const std::string& typed, const std::vector<TitledName>& known) {
  constexpr std::size_t kMostNamed = 8;
  std::vector<std::string> names = matching_names(typed, known).names;
  if (names.empty()) names = names_near(typed, known);
  if (names.empty()) return "";
  if (names.size() == 1) return "did you mean \"" + names.front() + "\"?";
  const std::size_t named = std::min(names.size(), kMostNamed);
  std::string text = "did you mean one of " + names.front();
  for (std::size_t i = 1; i < named; ++i) text += ", " + names[i];
  if (names.size() > named) text += " and " + std::to_string(names.size() - named) + " more";
  return text + "?";
}

}  // namespace karat
