#include "render/spectrum_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "materials/index/import/header.h"
#include "materials/index/import/text_lines.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr double kLongestNm = 1e9;

// Reads the lines in order with the tools of "karat nk add".
class ColumnReader {
 public:
  ColumnReader(const IndexSource& source, const Allowed& allowed)
      : source_(source), allowed_(allowed) {}

  std::vector<SpectrumSample> read() {
    const std::vector<TextLine> lines = text_lines(source_);
    const auto first = std::find_if(lines.begin(), lines.end(), [](const TextLine& line) {
      return begins_like_a_number(line.text);
    });
    if (first != lines.end()) {
      separator_ = separator_of(without_tail(first->text), source_, first->number);
    }
    for (const TextLine& line : lines) {
      if (begins_like_a_number(line.text)) {
        row(line);
      } else if (!comment_in(line.text, separator_)) {
        head(line);
      }
    }
    if (rows_.size() > 1 && rows_.front().nm > rows_.back().nm) {
      std::reverse(rows_.begin(), rows_.end());
    }
    return std::move(rows_);
  }

 private:
  [[noreturn]] void fail_found(const TextLine& line) const {
    throw InputError(source_.file, fmt::format("line {}", line.number),
                     fmt::format("found {}, allowed: wavelength in nm and value, as \"380 0.1\" or "
                                 "\"380,0.1\"; a comment begins with #",
                                 quoted_cell(line.text)));
  }

  // A line of words above the rows: its first cell may tell the unit.
  void head(const TextLine& line) {
    if (!rows_.empty()) fail_found(line);
    const auto names = header_names(line.text, separator_, 2);
    const auto unit = names.empty() ? std::nullopt : column_meaning(names.front()).unit;
    if (unit) unit_ = *unit;
  }

  void row(const TextLine& line) {
    const auto cells = cells_of(without_tail(line.text), separator_, source_, line.number);
    if (cells.size() != 2) fail_found(line);
    const double axis = numbers_.read(cells[0], source_, line.number, 1).value;
    const double value = numbers_.read(cells[1], source_, line.number, 2).value;
    const double nm =
        unit_ == AxisUnit::kNm || !(axis > 0.0) ? axis : micrometres(axis, unit_) * 1e3;
    if (!(nm > 0.0 && nm <= kLongestNm)) fail_found(line);
    if (!allowed_.contains(value)) {
      throw InputError(source_.file, fmt::format("line {}", line.number),
                       fmt::format("found {:g}, allowed: {}", value, allowed_.text()));
    }
    rows_.push_back({nm, value});
  }

  const IndexSource& source_;
  const Allowed& allowed_;
  char separator_ = kBlanks;
  AxisUnit unit_ = AxisUnit::kNm;
  NumberReader numbers_;
  std::vector<SpectrumSample> rows_;
};

}  // namespace

SpectrumPtr spectrum_of_text(const std::string& text, const std::string& file,
                             const Allowed& allowed) {
  const IndexSource source{file, text};
  const auto rows = ColumnReader(source, allowed).read();
  try {
    return spectrum_of_rows(rows, std::filesystem::path(file).filename().string());
  } catch (const InputError& error) {
    throw InputError(file, "", error.what());
  }
}

SpectrumPtr spectrum_of_rows(const std::vector<SpectrumSample>& rows, std::string description) {
  if (rows.empty()) throw InputError("a table of a spectrum needs at least one row [nm, value]");
  std::vector<double> nm, values;
  for (const SpectrumSample& row : rows) {
    if (!nm.empty() && !(row.nm > nm.back())) {
      throw InputError(
          fmt::format("wavelengths must increase; found {:g} nm after {:g} nm", row.nm, nm.back()));
    }
    nm.push_back(row.nm);
    values.push_back(row.value);
  }
  return table_spectrum(std::move(nm), std::move(values), std::move(description));
}

}  // namespace karat
