#include "materials/index/index_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <utility>

#include "materials/index/index_formula.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr std::size_t kMostRows = 1'000'000;
constexpr double kShortestUm = 1e-9, kLongestUm = 1e12;

class RowsCurve final : public Spectrum {
 public:
  RowsCurve(std::vector<double> nm, std::vector<double> values)
      : nm_(std::move(nm)), values_(std::move(values)) {}

  double operator()(double nm) const override {
    if (!(nm > nm_.front())) return values_[last_at(nm_.front())];
    if (nm >= nm_.back()) return values_.back();
    const std::size_t i = last_at(nm);
    const double t = (nm - nm_[i]) / (nm_[i + 1] - nm_[i]);
    return values_[i] + t * (values_[i + 1] - values_[i]);
  }
  WavelengthRange range() const override { return {nm_.front(), nm_.back()}; }
  std::string description() const override { return fmt::format("table of {} rows", nm_.size()); }
  std::vector<SpectrumSample> samples() const override {
    std::vector<SpectrumSample> rows;
    for (std::size_t i = 0; i < nm_.size(); ++i) rows.push_back({nm_[i], values_[i]});
    return rows;
  }

 private:
  // The last row that starts at or below nm; nm is not below the first.
  std::size_t last_at(double nm) const {
    return static_cast<std::size_t>(std::upper_bound(nm_.begin(), nm_.end(), nm) - nm_.begin()) - 1;
  }

  std::vector<double> nm_;
  std::vector<double> values_;
};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

// The next word of `text`, which is cut off; empty at the end.
std::string_view next_word(std::string_view& text) {
  std::size_t begin = 0;
  while (begin < text.size() && is_blank(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && !is_blank(text[end])) ++end;
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

std::string quoted(std::string_view word) {
  constexpr std::size_t kMostShown = 40;
  return fmt::format("\"{}{}\"", word.substr(0, kMostShown), word.size() > kMostShown ? "..." : "");
}

[[noreturn]] void not_a_number(std::string_view word, const std::string& origin,
                               const std::string& place) {
  throw InputError(origin, place,
                   quoted(word) + " is not a finite number such as 0.5876 or 1.2e-5");
}

// One problem that may occur in many rows: said once, with the first place and the count.
class RowProblem {
 public:
  void note(std::size_t row) {
    if (count_++ == 0) first_ = row;
  }
  void report(const BlockPlace& place, std::string_view what,
              std::vector<std::string>& warnings) const {
    if (count_ == 0) return;
    const std::string more = count_ > 1 ? fmt::format(" (and {} more)", count_ - 1) : "";
    warnings.push_back(fmt::format("{}: {}{}", place.row(first_), what, more));
  }

 private:
  std::size_t first_ = 0, count_ = 0;
};

struct Row {
  double nm;
  double value[2];
  std::size_t place;  // the row's line within the block, from 0
};

// Throws unless the row has the right count of numbers within physical bounds.
Row checked_row(std::string_view line, std::size_t line_index, std::size_t columns,
                const BlockPlace& place) {
  double numbers[3] = {};
  std::size_t count = 0;
  for (std::string_view rest = line, word = next_word(rest); !word.empty();
       word = next_word(rest)) {
    if (count == columns) {
      throw InputError(place.origin, place.row(line_index),
                       fmt::format("more than the {} numbers that a row has here", columns));
    }
    const auto number = index_number(word);
    if (!number) not_a_number(word, place.origin, place.row(line_index));
    numbers[count++] = *number;
  }
  if (count < columns) {
    throw InputError(place.origin, place.row(line_index),
                     fmt::format("{} numbers; a row has {} here", count, columns));
  }
  if (!(numbers[0] >= kShortestUm && numbers[0] <= kLongestUm)) {
    throw InputError(
        place.origin, place.row(line_index),
        fmt::format("a wavelength of {} um; it must be positive, in micrometres", numbers[0]));
  }
  for (const double value : {numbers[1], numbers[2]}) {
    if (std::abs(value) > kLargestIndex) {
      throw InputError(
          place.origin, place.row(line_index),
          fmt::format("an index of {}; at most {} is plausible", value, kLargestIndex));
    }
  }
  return {numbers[0] * 1000.0, {numbers[1], numbers[2]}, line_index};
}

std::vector<Row> read_rows(std::string_view text, std::size_t columns, const BlockPlace& place) {
  std::vector<Row> rows;
  for (std::size_t line_index = 0; !text.empty(); ++line_index) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (std::all_of(line.begin(), line.end(), is_blank)) continue;
    if (rows.size() == kMostRows) {
      throw InputError(place.origin, place.row(line_index),
                       fmt::format("more than {} rows", kMostRows));
    }
    rows.push_back(checked_row(line, line_index, columns, place));
  }
  if (rows.empty()) throw InputError(place.origin, place.block, "no rows of numbers");
  return rows;
}

// Sorts, keeping the file's order where a wavelength is repeated, and warns of both.
void sort_rows(std::vector<Row>& rows, const BlockPlace& place,
               std::vector<std::string>& warnings) {
  RowProblem unsorted, duplicate;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].nm < rows[i - 1].nm) unsorted.note(rows[i].place);
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.nm < b.nm; });
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].nm == rows[i - 1].nm) duplicate.note(rows[i].place);
  }
  unsorted.report(place, "rows are not in order of wavelength; sorted", warnings);
  duplicate.report(place, "wavelength listed twice", warnings);
}

void warn_of_values(const std::vector<Row>& rows, std::string_view names, const BlockPlace& place,
                    std::vector<std::string>& warnings) {
  for (std::size_t column = 0; column < names.size(); ++column) {
    RowProblem negative;
    bool all_zero = true;
    for (const Row& row : rows) {
      if (row.value[column] < 0.0) negative.note(row.place);
      all_zero &= row.value[column] == 0.0;
    }
    negative.report(place, fmt::format("negative {}", names[column]), warnings);
    if (all_zero) {
      warnings.push_back(fmt::format("{}: {} is zero in every row", place.block, names[column]));
    }
  }
}

}  // namespace

std::optional<double> index_number(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  if (stop == end) return value;
  // Fortran drops the letter of a long exponent or writes a D.
  std::string_view exponent(stop, static_cast<std::size_t>(end - stop));
  if (text.find_first_of("eE") != std::string_view::npos) return std::nullopt;
  if (exponent.front() == 'd' || exponent.front() == 'D') {
    exponent.remove_prefix(1);
  } else if (exponent.front() != '+' && exponent.front() != '-') {
    return std::nullopt;
  }
  std::string usual(text.data(), stop);
  usual.append("e").append(exponent);
  const auto again = std::from_chars(usual.data(), usual.data() + usual.size(), value);
  if (again.ec != std::errc() || again.ptr != usual.data() + usual.size()) return std::nullopt;
  return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

std::vector<double> index_numbers(std::string_view line, const std::string& origin,
                                  const std::string& place) {
  std::vector<double> numbers;
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
    const auto number = index_number(word);
    if (!number) not_a_number(word, origin, place);
    numbers.push_back(*number);
  }
  return numbers;
}

std::string BlockPlace::row(std::size_t row_index) const {
  if (first_line > 0) {
    return fmt::format("{}, line {}", block, static_cast<std::size_t>(first_line) + row_index);
  }
  return fmt::format("{}, row {}", block, row_index + 1);
}

IndexRows index_rows(std::string_view text, std::string_view names, const BlockPlace& place,
                     std::vector<std::string>& warnings) {
  std::vector<Row> rows = read_rows(text, 1 + names.size(), place);
  sort_rows(rows, place, warnings);
  warn_of_values(rows, names, place, warnings);
  IndexRows result;
  for (const Row& row : rows) {
    result.wavelengths_nm.push_back(row.nm);
    result.first.push_back(row.value[0]);
    if (names.size() == 2) result.second.push_back(row.value[1]);
  }
  return result;
}

SpectrumPtr rows_curve(std::vector<double> wavelengths_nm, std::vector<double> values) {
  return std::make_shared<RowsCurve>(std::move(wavelengths_nm), std::move(values));
}

}  // namespace karat
