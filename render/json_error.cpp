#include "render/json_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace karat {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool is_word(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte >= '0' && byte <= '9') || (byte >= 'A' && byte <= 'Z') ||
         (byte >= 'a' && byte <= 'z') || byte >= 0x80 || c == '_' || c == '.' || c == '+' ||
         c == '-';
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Lines and columns count from 1; a column is a character, not a byte.
struct Position {
  std::size_t line = 1, column = 1;
};

Position position_of(const std::string& text, std::size_t at) {
  Position position;
  for (std::size_t i = 0; i < at; ++i) {
    const bool continues = (static_cast<unsigned char>(text[i]) & 0xc0) == 0x80;
    if (text[i] == '\n') {
      ++position.line, position.column = 1;
    } else if (!continues) {
      ++position.column;
    }
  }
  return position;
}

// The token whose last byte read is `last`: [begin, end), with what of a word was not read yet.
// `broken`: the token itself is wrong, so that the last byte may be the one that ended it early.
std::pair<std::size_t, std::size_t> token_around(const std::string& text, std::size_t last,
                                                 bool broken) {
  std::size_t begin = last, end = last + 1;
  const auto escaped = [&](std::size_t i) {
    std::size_t slashes = 0;
    while (slashes < i && text[i - 1 - slashes] == '\\') ++slashes;
    return slashes % 2 == 1;
  };
  if (text[last] == '"') {
    while (begin > 0 && (text[--begin] != '"' || escaped(begin))) {
    }
    return {begin, end};
  }
  if (broken && !is_word(text[last]) && last > 0 && is_word(text[last - 1])) --begin, end = last;
  if (!is_word(text[begin])) return {begin, end};
  while (begin > 0 && is_word(text[begin - 1])) --begin;
  while (end < text.size() && is_word(text[end])) ++end;
  return {begin, end};
}

std::string shortened(const std::string& text, std::size_t begin, std::size_t end) {
  constexpr std::size_t kLongest = 30;
  std::size_t stop = std::min(end, begin + kLongest);
  while (stop > begin && stop < end && (static_cast<unsigned char>(text[stop]) & 0xc0) == 0x80) {
    --stop;
  }
  std::string shown;
  for (std::size_t i = begin; i < stop; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    shown += byte < 0x20 || byte == 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(1, text[i]);
  }
  return stop < end ? shown + "..." : shown;
}

bool ends_value(char c) { return c == '"' || c == '}' || c == ']' || is_word(c); }

// Reads the surroundings of the place where the parser stopped.
class Reader {
 public:
  Reader(const std::string& text, const JsonStop& stop) : text_(text), stop_(stop) {
    std::tie(begin_, end_) = token_around(text, stop.byte - 1, says("invalid"));
    before_ = begin_;
    while (before_ > 0 && is_space(text[before_ - 1])) --before_;
  }

  JsonErrorText error() const {
    for (const auto rule : {&Reader::in_string, &Reader::comment, &Reader::surplus_comma,
                            &Reader::missing_colon, &Reader::missing_comma, &Reader::word}) {
      if (JsonErrorText found = (this->*rule)(); !found.message.empty()) return found;
    }
    return here("unexpected " + token());
  }

 private:
  char first() const { return text_[begin_]; }
  char previous() const { return before_ > 0 ? text_[before_ - 1] : '\0'; }
  bool says(const char* words) const { return stop_.what.find(words) != std::string::npos; }
  std::string token() const { return shortened(text_, begin_, end_); }

  JsonErrorText at(std::size_t byte, std::string message) const {
    const Position position = position_of(text_, byte);
    return {fmt::format("line {}, column {}", position.line, position.column), std::move(message)};
  }
  JsonErrorText here(std::string message) const { return at(begin_, std::move(message)); }

  // The parser stopped inside a text in quotes.
  JsonErrorText in_string() const {
    if (!says("invalid string")) return {};
    const std::size_t last = stop_.byte - 1;
    const auto byte = static_cast<unsigned char>(text_[last]);
    if (says("ill-formed UTF-8")) {
      return at(last, fmt::format("byte 0x{:02x} is not UTF-8; save the file as UTF-8", byte));
    }
    if (byte == '\n' || byte == '\r') return at(last, "the text in quotes has no end on this line");
    if (byte < 0x20 || byte == 0x7f) {
      return at(last, fmt::format("a text cannot hold the control character 0x{:02x}", byte));
    }
    return at(last, "a backslash in a text is written \\\\ (and paths with / as well)");
  }

  JsonErrorText comment() const {
    const bool slashes = begin_ + 1 < text_.size() && first() == '/' &&
                         (text_[begin_ + 1] == '/' || text_[begin_ + 1] == '*');
    if (slashes || first() == '#') return here("comments are not JSON");
    return {};
  }

  JsonErrorText surplus_comma() const {
    const bool closes = first() == '}' || first() == ']';
    if (closes && previous() == ',') {
      return at(before_ - 1, fmt::format("a comma before \"{}\"", first()));
    }
    if (closes && previous() == ':') return here(fmt::format("no value before \"{}\"", first()));
    if (closes && stop_.open != 0) {
      const char closing = stop_.open == '{' ? '}' : ']';
      return here(fmt::format("\"{}\" where \"{}\" must stand", first(), closing));
    }
    if (first() != ',') return {};
    if (stop_.open == 0) return here("a comma after the last bracket");
    return here(previous() == ',' ? "two commas" : "a comma without a value before it");
  }

  JsonErrorText missing_colon() const {
    if (first() == '=') return here("\":\" stands between a key and its value, not \"=\"");
    if (!says("object separator")) return {};
    return at(before_, "\":\" and a value are missing after the key");
  }

  JsonErrorText missing_comma() const {
    if (!ends_value(previous()) || (!ends_value(first()) && first() != '{' && first() != '[')) {
      return {};
    }
    if (stop_.open == 0) return here(token() + " after the last bracket");
    const Position end = position_of(text_, before_);
    if (end.line < position_of(text_, begin_).line) {
      return {"", fmt::format("line {} ends without a comma", end.line)};
    }
    return here("no comma before " + token());
  }

  JsonErrorText word() const {
    if (first() == '\'') return here("texts stand in double quotes, not in single ones");
    if (!is_word(first())) return {};
    if (says("invalid number") || is_digit(first()) || first() == '.' || first() == '+') {
      return here(token() + " is not a number in JSON (those are 0.5, -2, 1e-3)");
    }
    if (says("object key")) return here("a key stands in double quotes: \"" + token() + "\"");
    return here(token() +
                " is not a value in JSON: texts stand in double quotes; others are numbers, true, "
                "false and null");
  }

  const std::string& text_;
  const JsonStop& stop_;
  std::size_t begin_ = 0, end_ = 0, before_ = 0;  // the token, and the end of what is before it
};

}  // namespace

JsonErrorText json_error(const std::string& text, const JsonStop& stop) {
  if (std::all_of(text.begin(), text.end(), is_space)) return {"", "the file is empty"};
  if (stop.byte >= 1 && stop.byte <= text.size()) return Reader(text, stop).error();
  const std::string line = fmt::format("line {}", position_of(text, text.size()).line);
  if (stop.what.find("invalid string") != std::string::npos) {
    return {line, "the file ends inside a text in quotes"};
  }
  if (stop.open == 0) return {line, "the file ends in the middle of a value"};
  return {line, fmt::format("the file ends where \"{}\" is missing", stop.open == '{' ? '}' : ']')};
}

std::string foreign_format(const std::string& text) {
  using namespace std::string_literals;
  static const std::vector<std::pair<std::string, std::string>> beginnings{
      {"\x89PNG"s, "a PNG image"},       {"\x76\x2f\x31\x01"s, "an OpenEXR image"},
      {"\xff\xd8\xff"s, "a JPEG image"}, {"#?RADIANCE"s, "a Radiance HDR image"},
      {"glTF"s, "a glTF mesh"},          {"ply\n"s, "a PLY mesh"},
      {"ply\r"s, "a PLY mesh"},          {"PK\x03\x04"s, "a ZIP archive"},
      {"\x1f\x8b"s, "a gzip archive"},   {"%PDF"s, "a PDF document"},
      {"KARATCK"s, "a checkpoint"},      {"<?xml"s, "an XML file"},
      {"<scene"s, "an XML file"},        {"\x7f"s + "ELF", "a program"}};
  for (const auto& [beginning, format] : beginnings) {
    if (text.starts_with(beginning)) return format;
  }
  const bool marked = text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
  const bool every_other_is_0 =
      text.size() >= 4 && ((text[0] == 0 && text[2] == 0) || (text[1] == 0 && text[3] == 0));
  return marked || every_other_is_0 ? "UTF-16 text" : "";
}

}  // namespace karat
