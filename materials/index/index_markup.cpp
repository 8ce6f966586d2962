#include "materials/index/index_markup.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace karat {
namespace {

constexpr std::array<std::string_view, 16> kTags = {"a",   "b",    "br", "div", "em",   "i",
                                                    "li",  "nobr", "ol", "p",   "span", "strong",
                                                    "sub", "sup",  "u",  "ul"};
constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kEntities = {
    {{"&times;", "\u00d7"},
     {"&nbsp;", " "},
     {"&lt;", "<"},
     {"&gt;", ">"},
     {"&quot;", "\""},
     {"&ndash;", "\u2013"},
     {"&mdash;", "\u2014"},
     {"&deg;", "\u00b0"},
     {"&micro;", "\u00b5"},
     {"&amp;", "&"}}};
constexpr std::string_view kDoiHost = "doi.org/";

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

// The part of a URL after doi.org/, up to `end`; empty for other addresses.
std::string_view doi_in(std::string_view url, std::string_view end) {
  const auto host = url.find(kDoiHost);
  if (host == std::string_view::npos) return {};
  const std::string_view doi = url.substr(host + kDoiHost.size());
  return doi.substr(0, doi.find_first_of(end));
}

class Stripper {
 public:
  explicit Stripper(std::string_view text) : rest_(text) {}

  std::string run() {
    while (!rest_.empty()) {
      if (!tag() && !entity() && !link() && !emphasis()) character();
    }
    while (!out_.empty() && out_.back() == ' ') out_.pop_back();
    return std::move(out_);
  }

 private:
  void put(std::string_view text) {
    for (const char c : text) {
      const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
      if (control || c == ' ') {
        if (!out_.empty() && out_.back() != ' ') out_ += ' ';
      } else {
        out_ += c;
      }
    }
  }
  void put_doi(std::string_view doi) {
    if (doi.empty()) return;
    put(", doi:");
    put(doi);
  }
  void character() {
    if (rest_[0] == '\\' && rest_.size() > 1 &&
        std::string_view("\\`*_[]()#+-.!<>").find(rest_[1]) != std::string_view::npos) {
      rest_.remove_prefix(1);
    }
    put(rest_.substr(0, 1));
    rest_.remove_prefix(1);
  }

  // The next character of a kind is looked for once, or text of nothing but openings would cost the
  // square of its length.
  struct Next {
    char character;
    const char* at = nullptr;
  };
  // Where it is at or after `from`, which only grows; npos where there is none.
  std::size_t find(Next& next, std::size_t from = 0) const {
    const char* const end = rest_.data() + rest_.size();
    const char* const begin = rest_.data() + from;
    if (!next.at || next.at < begin) next.at = std::find(begin, end, next.character);
    if (next.at == end) return std::string_view::npos;
    return static_cast<std::size_t>(next.at - rest_.data());
  }

  bool tag() {
    if (rest_[0] != '<') return false;
    const auto end = find(tag_end_);
    if (end == std::string_view::npos) return false;
    const std::string_view inside = rest_.substr(1, end - 1);
    const bool closing = inside.starts_with('/');
    std::string name;
    for (const char c : inside.substr(closing ? 1 : 0)) {
      if (!is_letter(c)) break;
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    if (std::find(kTags.begin(), kTags.end(), name) == kTags.end()) return false;
    if (name == "a" && closing) put_doi(std::exchange(doi_, {}));
    if (name == "a" && !closing) doi_ = doi_in(inside, "\"' ");
    if (name == "br" || name == "p" || name == "li") put(" ");
    rest_.remove_prefix(end + 1);
    return true;
  }
  bool entity() {
    for (const auto& [name, text] : kEntities) {
      if (!rest_.starts_with(name)) continue;
      put(text);
      rest_.remove_prefix(name.size());
      return true;
    }
    return false;
  }
  // [text](address); anything else in brackets stays.
  bool link() {
    if (rest_[0] != '[') return false;
    const auto middle = find(bracket_);
    if (middle == std::string_view::npos || !rest_.substr(middle + 1).starts_with('('))
      return false;
    const auto end = find(parenthesis_, middle);
    if (end == std::string_view::npos) return false;
    put(Stripper(rest_.substr(1, middle - 1)).run());
    put_doi(doi_in(rest_.substr(middle + 2, end - middle - 2), " "));
    rest_.remove_prefix(end + 1);
    return true;
  }
  // ** and * around words; a star between blanks or digits is a product or a footnote.
  bool emphasis() {
    if (rest_.starts_with("**")) {
      rest_.remove_prefix(2);
      return true;
    }
    if (rest_[0] != '*') return false;
    const bool opens = rest_.size() > 1 && is_letter(rest_[1]) && rest_.find('*', 1) != rest_.npos;
    const bool closes = open_ && !out_.empty() && out_.back() != ' ';
    if (!opens && !closes) return false;
    open_ = !closes;
    rest_.remove_prefix(1);
    return true;
  }

  std::string_view rest_;
  std::string out_;
  std::string_view doi_;
  bool open_ = false;
  Next tag_end_{'>'}, bracket_{']'}, parenthesis_{')'};
};

}  // namespace

std::string plain_text(std::string_view text) { return Stripper(text).run(); }

}  // namespace karat
