#include "materials/index/import/rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "materials/index/import/permittivity.h"
#include "materials/index/index_formula.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

std::string text_of(const std::vector<Quantity>& quantities) {
  std::string text;
  for (std::size_t i = 1; i < quantities.size(); ++i) {
    text += (i > 1 ? " and " : "") + quantity_name(quantities[i]);
  }
  return text;
}

void negate(WrittenNumber& number) {
  if (number.value == 0.0) return;
  number.value = -number.value;
  if (number.text.starts_with('-')) {
    number.text.erase(0, 1);
  } else {
    number.text.insert(0, 1, '-');
  }
}

// The limits of the database's format, said where the line is known.
void require_limits(const ImportRow& row, const std::string& file) {
  constexpr double kShortestUm = 1e-9, kLongestUm = 1e12;
  const std::string line = fmt::format("line {}", row.line);
  if (!(row.um.value >= kShortestUm && row.um.value <= kLongestUm)) {
    throw InputError(file, line,
                     fmt::format("a wavelength of {} um; allowed are {} to {}", row.um.value,
                                 kShortestUm, kLongestUm));
  }
  for (const double value : {row.n.value, row.k.value}) {
    if (!(std::abs(value) <= kLargestIndex)) {
      throw InputError(
          file, line, fmt::format("an index of {}; at most {} is plausible", value, kLargestIndex));
    }
  }
}

ImportRow converted(RawRow&& raw, const RawBlock& block, AxisUnit unit, bool negate_k,
                    const std::string& file) {
  if (!(raw.numbers[0].value > 0.0)) {
    throw InputError(
        file, fmt::format("line {}", raw.line),
        fmt::format("{} {}; it must be positive", raw.numbers[0].text, axis_unit_name(unit)));
  }
  ImportRow row{raw.line, micrometres(raw.numbers[0], unit), {}, {}};
  const Quantity first = block.quantities[1];
  if (first == Quantity::kEps1) {
    const ComplexIndex index = index_of_permittivity(raw.numbers[1].value, raw.numbers[2].value);
    row.n = written(index.n);
    row.k = written(index.k);
  } else {
    (first == Quantity::kN ? row.n : row.k) = std::move(raw.numbers[1]);
    if (block.quantities.size() == 3) row.k = std::move(raw.numbers[2]);
  }
  if (negate_k) negate(row.k);
  require_limits(row, file);
  return row;
}

// What the order of the rows was; a file that runs backwards is no cause for a warning.
void warn_of_order(const std::vector<ImportRow>& rows, std::vector<std::string>& warnings) {
  std::size_t up = 0, down = 0, first_up = 0, first_down = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double step = rows[i].um.value - rows[i - 1].um.value;
    if (step > 0.0 && up++ == 0) first_up = rows[i].line;
    if (step < 0.0 && down++ == 0) first_down = rows[i].line;
  }
  if (up == 0 || down == 0) return;
  const bool rising = up >= down;
  warnings.push_back(fmt::format(
      "rows are not in order of wavelength (line {}{}); sorted", rising ? first_down : first_up,
      std::min(up, down) > 1 ? fmt::format(" and {} more", std::min(up, down) - 1) : ""));
}

bool same_values(const ImportRow& a, const ImportRow& b) {
  return a.um.value == b.um.value && a.n.value == b.n.value && a.k.value == b.k.value;
}

// Equal rows are one; rows that differ at one wavelength are a step, which the format can say.
void settle_repeats(std::vector<ImportRow>& rows, std::vector<std::string>& warnings) {
  std::size_t equal = 0, steps = 0, first_equal = 0, first_step = 0;
  std::vector<ImportRow> kept;
  for (ImportRow& row : rows) {
    const bool repeats = !kept.empty() && kept.back().um.value == row.um.value;
    if (repeats && same_values(kept.back(), row)) {
      if (equal++ == 0) first_equal = row.line;
      continue;
    }
    if (repeats && steps++ == 0) first_step = row.line;
    kept.push_back(std::move(row));
  }
  rows = std::move(kept);
  const auto more = [](std::size_t count) {
    return count > 1 ? fmt::format(" and {} more", count - 1) : std::string();
  };
  if (equal > 0) {
    warnings.push_back(
        fmt::format("line {}{}: repeats another row; left out", first_equal, more(equal)));
  }
  if (steps > 0) {
    warnings.push_back(
        fmt::format("line {}{}: the wavelength of another row with other values; both are kept, "
                    "which makes a step",
                    first_step, more(steps)));
  }
}

bool same_wavelengths(const ImportSeries& a, const ImportSeries& b) {
  return std::equal(
      a.rows.begin(), a.rows.end(), b.rows.begin(), b.rows.end(),
      [](const ImportRow& x, const ImportRow& y) { return x.um.value == y.um.value; });
}

}  // namespace

ImportSeries import_series(RawBlock block, AxisUnit unit, bool negate_k, const std::string& file,
                           std::vector<std::string>& warnings) {
  ImportSeries series;
  for (const Quantity quantity : block.quantities) {
    series.has_n |= quantity == Quantity::kN || quantity == Quantity::kEps1;
    series.has_k |= quantity == Quantity::kK || quantity == Quantity::kEps2;
  }
  for (RawRow& raw : block.rows) {
    series.rows.push_back(converted(std::move(raw), block, unit, negate_k, file));
  }
  warn_of_order(series.rows, warnings);
  std::stable_sort(series.rows.begin(), series.rows.end(),
                   [](const ImportRow& a, const ImportRow& b) { return a.um.value < b.um.value; });
  settle_repeats(series.rows, warnings);
  if (series.rows.size() < 2) {
    throw InputError(
        file, "",
        fmt::format("one wavelength with {}; a table needs two at least (a scene takes "
                    "one value as \"n\" and \"k\")",
                    text_of(block.quantities)));
  }
  return series;
}

std::vector<ImportSeries> joined_series(std::vector<ImportSeries> series, const std::string& file) {
  const auto listed = [&](bool ImportSeries::*what) {
    return std::count_if(series.begin(), series.end(),
                         [what](const ImportSeries& one) { return one.*what; });
  };
  if (listed(&ImportSeries::has_n) != 1 || listed(&ImportSeries::has_k) > 1) {
    throw InputError(file, "",
                     listed(&ImportSeries::has_n) == 0
                         ? "k alone is listed: a material needs n at the same wavelengths"
                         : "several blocks list the same quantity; a table has one of n and one of "
                           "k: split the file");
  }
  if (series.size() != 2 || !same_wavelengths(series[0], series[1])) return series;
  if (!series[0].has_n) std::swap(series[0], series[1]);
  series[0].has_k = true;
  for (std::size_t i = 0; i < series[0].rows.size(); ++i) {
    series[0].rows[i].k = std::move(series[1].rows[i].k);
  }
  series.pop_back();
  return series;
}

}  // namespace karat
