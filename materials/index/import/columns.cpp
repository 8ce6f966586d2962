#include "materials/index/import/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "materials/index/import/column_layout.h"
#include "materials/index/import/header.h"
#include "materials/index/import/text_lines.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr std::size_t kMostHeadLines = 64;

class ColumnsReader {
 public:
  ColumnsReader(const IndexSource& source, const ColumnNames& columns)
      : source_(source), columns_(columns) {}

  RawTable read() {
    const std::vector<TextLine> lines = text_lines(source_);
    find_separator(lines);
    for (const TextLine& line : lines) {
      if (begins_like_a_number(line.text)) {
        row(line);
      } else if (auto comment = comment_in(line.text, separator_)) {
        remember(head_.comments, line);
        if (!comment->empty()) table_.comments.push_back(std::move(*comment));
      } else {
        head(line);
      }
    }
    describe();
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& message) const {
    throw InputError(source_.file, fmt::format("line {}", line), message);
  }

  void find_separator(const std::vector<TextLine>& lines) {
    const auto first = std::find_if(lines.begin(), lines.end(), [](const TextLine& line) {
      return begins_like_a_number(line.text);
    });
    if (first == lines.end()) {
      throw InputError(source_.file, "",
                       lines.empty() ? "empty" : "no rows of numbers: no line begins with one");
    }
    separator_ = separator_of(without_tail(first->text), source_, first->number);
  }

  static void remember(std::vector<TextLine>& lines, TextLine line) {
    while (!line.text.empty() && std::string_view("#%!;/").find(line.text[0]) != line.text.npos) {
      line.text = trimmed(line.text.substr(1));
    }
    if (lines.size() == kMostHeadLines) lines.erase(lines.begin());
    lines.push_back(line);
  }

  // A line of words: names, units or a title above the rows; within them only the names of another
  // block.
  void head(const TextLine& line) {
    const auto cells = cells_of(line.text, separator_, source_, line.number);
    const auto numbers = std::count_if(cells.begin(), cells.end(), begins_like_a_number);
    const bool titled = head_.header.empty() && !table_.blocks.empty();
    const bool names = std::any_of(cells.begin(), cells.end(), [](std::string_view cell) {
      return column_meaning(cell).quantity == Quantity::kAxis;
    });
    if (numbers >= 2 || (titled && !names)) {
      throw InputError(
          source_.file, place_of(line.number, 1),
          (cells.empty() || cells[0].empty() ? "an empty cell"
                                             : quoted_cell(cells[0]) + " is no number") +
              "; a row begins with its wavelength (a comment begins with #)");
    }
    if (head_.header.empty()) in_block_ = false;
    remember(head_.header, line);
  }

  void row(const TextLine& line) {
    const auto cells = cells_of(without_tail(line.text), separator_, source_, line.number);
    if (!in_block_) begin_block(cells.size(), line.number);
    if (cells.size() != count_) {
      fail(line.number, fmt::format("{} column{}, but line {} has {}", cells.size(),
                                    cells.size() == 1 ? "" : "s", first_line_, count_));
    }
    if (rows_++ == kMostImportRows) {
      fail(line.number, fmt::format("more than {} rows", kMostImportRows));
    }
    RawRow result{line.number, {}};
    for (std::size_t i = 0; i < layout_.columns.size(); ++i) {
      const std::size_t column = layout_.columns[i];
      result.numbers[i] = numbers_.read(cells[column], source_, line.number, column + 1);
    }
    table_.blocks.back().rows.push_back(std::move(result));
  }

  void begin_block(std::size_t count, std::size_t line) {
    in_block_ = true;
    count_ = count;
    first_line_ = line;
    layout_ = columns_.empty() ? layout_of_head(head_, count, separator_, source_, line)
                               : layout_of_names(columns_, head_, count, separator_, source_, line);
    for (std::size_t i = columns_.size(); !columns_.empty() && i < count; ++i) {
      layout_.unused.push_back(fmt::format("column {}", i + 1));
    }
    const bool first = table_.blocks.empty();
    if (first) {
      table_.axis = layout_.axis;
      table_.unit = layout_.unit;
      table_.unit_source = layout_.unit_source;
      for (const TextLine& title : head_.header) titles(title);
    } else if (layout_.axis != table_.axis || layout_.unit != table_.unit) {
      fail(line, "the second block's axis has another name or unit than the first one's");
    }
    layouts_ += (first ? "" : "; then ") + layout_.description();
    table_.blocks.push_back({layout_.quantities, {}});
    head_ = {};
  }

  // Lines above the rows may say what was measured.
  void titles(const TextLine& line) {
    const bool units = table_.unit_source == fmt::format("line {}", line.number);
    if (!units && header_names(line.text, separator_, count_).empty()) {
      table_.comments.emplace_back(line.text);
    }
  }

  void describe() {
    const std::string_view separated = separator_ == ';'    ? "semicolon-separated text"
                                       : separator_ == '\t' ? "tab-separated text"
                                       : separator_ == ','  ? "comma-separated text"
                                                            : "text separated by blanks";
    table_.description = fmt::format(
        "{}{}; {}", separated, numbers_.decimal_comma() ? " with decimal commas" : "", layouts_);
  }

  const IndexSource& source_;
  const ColumnNames& columns_;
  char separator_ = kBlanks;
  NumberReader numbers_;
  BlockHead head_;
  bool in_block_ = false;
  std::size_t count_ = 0, first_line_ = 0, rows_ = 0;
  ColumnLayout layout_;
  std::string layouts_;
  RawTable table_;
};

class Columns final : public IndexFormat {
 public:
  int likeness(const IndexSource&) const override { return 1; }
  std::string title() const override { return "columns of numbers"; }
  RawTable read(const IndexSource& source, const ColumnNames& columns) const override {
    return read_columns(source, columns);
  }
};

KARAT_REGISTER(IndexFormat, "columns", Columns);

}  // namespace

RawTable read_columns(const IndexSource& source, const ColumnNames& columns) {
  return ColumnsReader(source, columns).read();
}

}  // namespace karat
