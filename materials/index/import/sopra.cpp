// Files of the SOPRA database. Four numbers: the unit (1 eV, 2 um, 3 1/cm, 4 nm), where the axis
// begins and ends, and the number of its even intervals; then n and k at the ends of all intervals,
// one more than there are intervals. Blanks, semicolons or both separate the numbers (FreeSnell
// manual, "Refractive Index Spectra", A. Jaffer, people.csail.mit.edu/jaffer/FreeSnell/nk.html).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "materials/index/import/format.h"
#include "materials/index/import/text_lines.h"
#include "materials/index/index_rows.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr std::array<AxisUnit, 4> kSopraUnits{AxisUnit::kEv, AxisUnit::kUm, AxisUnit::kPerCm,
                                              AxisUnit::kNm};

bool separates(char c) { return c == ' ' || c == '\t' || c == ';' || c == '\r' || c == '\n'; }

std::string_view next_word(std::string_view& line) {
  while (!line.empty() && separates(line.front())) line.remove_prefix(1);
  std::size_t end = 0;
  while (end < line.size() && !separates(line[end])) ++end;
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(end);
  return word;
}

struct Word {
  std::string_view text;
  std::size_t line = 0, column = 0;
};

// The numbers of a file, one after the other.
class Words {
 public:
  explicit Words(std::vector<TextLine> lines) : lines_(std::move(lines)) {}

  std::optional<Word> next() {
    for (; at_ < lines_.size(); ++at_, column_ = 0) {
      const std::string_view word = next_word(lines_[at_].text);
      if (!word.empty()) return Word{word, lines_[at_].number, ++column_};
    }
    return std::nullopt;
  }

 private:
  std::vector<TextLine> lines_;
  std::size_t at_ = 0, column_ = 0;
};

struct Head {
  AxisUnit unit = AxisUnit::kEv;
  double begin = 0.0, end = 0.0;
  std::size_t intervals = 0;
};

// The header that a line is, if it is one: four numbers, the unit and the intervals whole ones.
std::optional<Head> head_of(std::string_view line) {
  std::array<double, 4> numbers{};
  std::size_t count = 0;
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
    const auto number = index_number(word);
    if (!number || count == numbers.size()) return std::nullopt;
    numbers[count++] = *number;
  }
  const auto [unit, begin, end, intervals] = numbers;
  const bool whole = unit == std::floor(unit) && intervals == std::floor(intervals);
  if (count != 4 || !whole || unit < 1 || unit > 4 || intervals < 1 || intervals > 1e9) {
    return std::nullopt;
  }
  return Head{kSopraUnits[static_cast<std::size_t>(unit) - 1], begin, end,
              static_cast<std::size_t>(intervals)};
}

std::size_t count_of_words(std::string_view line) {
  std::size_t count = 0;
  while (!next_word(line).empty()) ++count;
  return count;
}

WrittenNumber number(const Word& word, const IndexSource& source) {
  const auto value = index_number(word.text);
  if (!value) {
    throw InputError(source.file, place_of(word.line, word.column),
                     quoted_cell(word.text) + " is not a finite number such as 0.5876 or 1.2e-5");
  }
  std::string text(word.text);
  if (text.starts_with('+')) text.erase(0, 1);
  return {*value, std::move(text)};
}

class Sopra final : public IndexFormat {
 public:
  int likeness(const IndexSource& source) const override {
    const auto first = source.text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return 0;
    const std::string_view rest = source.text.substr(first);
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    const auto head = head_of(trimmed(rest.substr(0, end)));
    if (!head) return 0;
    const std::string_view below =
        rest.substr(std::min(rest.find_first_not_of("\r\n", end), rest.size()));
    // Rows of four columns may begin like a header; their count then fits by chance only.
    if (count_of_words(below.substr(0, below.find_first_of("\r\n"))) != 4) return 3;
    return count_of_words(below) == 2 * (head->intervals + 1) ? 3 : 0;
  }
  std::string title() const override { return "SOPRA .nk"; }

  RawTable read(const IndexSource& source, const ColumnNames& columns) const override {
    if (!columns.empty()) {
      throw InputError(source.file, "",
                       "a SOPRA file, whose columns are n and k; leave --columns out, or say "
                       "--format columns");
    }
    std::vector<TextLine> lines = text_lines(source);
    const Head head = checked_head(lines, source);
    lines.erase(lines.begin());
    Words words(std::move(lines));
    RawBlock block{{Quantity::kAxis, Quantity::kN, Quantity::kK}, {}};
    for (auto n = words.next(); n; n = words.next()) {
      const auto k = words.next();
      if (block.rows.size() > head.intervals || !k) wrong_count(head, source, *n, !k);
      const auto i = static_cast<double>(block.rows.size());
      const double share = i / static_cast<double>(head.intervals);
      // Twelve digits: 0.65, not 0.6500000000000001.
      const double axis = head.begin + (head.end - head.begin) * share;
      const std::string text = fmt::format("{:.12g}", axis);
      block.rows.push_back({n->line,
                            {WrittenNumber{index_number(text).value_or(axis), text},
                             number(*n, source), number(*k, source)}});
    }
    if (block.rows.size() != head.intervals + 1) {
      throw InputError(source.file, "",
                       fmt::format("{} pairs of n and k; the header's {} intervals have {}",
                                   block.rows.size(), head.intervals, head.intervals + 1));
    }
    RawTable table;
    table.unit = head.unit;
    table.unit_source = "the SOPRA header";
    table.description = fmt::format("SOPRA .nk; {} intervals from {} to {} {}", head.intervals,
                                    head.begin, head.end, axis_unit_name(head.unit));
    table.blocks.push_back(std::move(block));
    return table;
  }

 private:
  static Head checked_head(const std::vector<TextLine>& lines, const IndexSource& source) {
    const auto head = lines.empty() ? std::nullopt : head_of(lines.front().text);
    if (!head) {
      throw InputError(source.file, lines.empty() ? "" : fmt::format("line {}", lines[0].number),
                       "not a SOPRA header: unit (1 eV, 2 um, 3 1/cm, 4 nm), begin, end, number of "
                       "intervals");
    }
    const std::string place = fmt::format("line {}", lines.front().number);
    if (!(head->begin > 0.0 && head->end > 0.0 && head->begin != head->end)) {
      throw InputError(source.file, place,
                       fmt::format("an axis from {} to {}; both ends must be positive and differ",
                                   head->begin, head->end));
    }
    if (head->intervals >= kMostImportRows) {
      throw InputError(
          source.file, place,
          fmt::format("{} intervals; at most {} rows are read", head->intervals, kMostImportRows));
    }
    return *head;
  }

  [[noreturn]] static void wrong_count(const Head& head, const IndexSource& source,
                                       const Word& word, bool lonely) {
    throw InputError(source.file, place_of(word.line, word.column),
                     lonely ? "an n without a k behind it"
                            : fmt::format("more than the {} pairs of n and k that the header's {} "
                                          "intervals have",
                                          head.intervals + 1, head.intervals));
  }
};

KARAT_REGISTER(IndexFormat, "sopra", Sopra);

}  // namespace
}  // namespace karat
