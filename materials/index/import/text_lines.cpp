#include "materials/index/import/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "materials/index/index_markup.h"
#include "materials/index/index_rows.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr std::size_t kMostLines = kMostImportRows + 10'000;
constexpr std::size_t kMostCells = 64;

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view unquoted(std::string_view cell) {
  cell = trimmed(cell);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
    cell = trimmed(cell.substr(1, cell.size() - 2));
  }
  return cell;
}

// The number that a cell holds, with a decimal comma too.
std::optional<double> number_in(std::string_view cell) {
  std::string text(cell);
  if (std::count(text.begin(), text.end(), ',') == 1) {
    std::replace(text.begin(), text.end(), ',', '.');
  }
  return index_number(text);
}

void require_text(const IndexSource& source) {
  const std::string_view text = source.text;
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    throw InputError(source.file, "", "UTF-16 text; save it as UTF-8 or plain text");
  }
  if (text.find('\0') != std::string_view::npos) {
    throw InputError(source.file, "",
                     "a binary file; a table is text: columns of numbers, SOPRA .nk, or YAML");
  }
}

}  // namespace

std::string place_of(std::size_t line, std::size_t column) {
  return fmt::format("line {}, column {}", line, column);
}

std::string quoted_cell(std::string_view text) {
  constexpr std::size_t kMostShown = 40;
  std::string shown(text.substr(0, kMostShown));
  std::replace_if(
      shown.begin(), shown.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return fmt::format("\"{}{}\"", shown, text.size() > kMostShown ? "..." : "");
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool begins_like_a_number(std::string_view text) {
  if (text.starts_with('"')) text = trimmed(text.substr(1));
  if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
  if (text.starts_with('.') || text.starts_with(',')) text.remove_prefix(1);
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) != 0;
}

std::vector<TextLine> text_lines(const IndexSource& source) {
  require_text(source);
  std::vector<TextLine> lines;
  std::string_view rest = source.text;
  if (rest.starts_with("\xef\xbb\xbf")) rest.remove_prefix(3);
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(rest.substr(end).starts_with("\r\n") ? end + 2
                                                            : std::min(end + 1, rest.size()));
    if (line.empty()) continue;
    if (lines.size() == kMostLines) {
      throw InputError(source.file, fmt::format("line {}", number),
                       fmt::format("more than {} lines; a table has at most {} rows", kMostLines,
                                   kMostImportRows));
    }
    lines.push_back({number, line});
  }
  return lines;
}

std::optional<std::string> comment_in(std::string_view line, char separator) {
  constexpr std::string_view kMarkers = "#%!;/";
  if (line.empty() || kMarkers.find(line.front()) == std::string_view::npos) return std::nullopt;
  if (line.front() == ';' && separator == ';') return std::nullopt;
  if (line.front() == '/' && !line.starts_with("//")) return std::nullopt;
  while (!line.empty() && kMarkers.find(line.front()) != std::string_view::npos) {
    line.remove_prefix(1);
  }
  return std::string(trimmed(line));
}

std::string_view without_tail(std::string_view line) {
  const std::size_t end = std::min({line.find('#'), line.find('%'), line.find("//")});
  return trimmed(line.substr(0, end));
}

std::vector<std::string_view> cells_of(std::string_view line, char separator,
                                       const IndexSource& source, std::size_t line_number) {
  std::vector<std::string_view> cells;
  bool quoted = false;
  std::size_t start = 0;
  const auto take = [&](std::size_t end) {
    if (cells.size() == kMostCells) {
      throw InputError(source.file, fmt::format("line {}", line_number),
                       fmt::format("more than {} columns", kMostCells));
    }
    cells.push_back(unquoted(line.substr(start, end - start)));
    start = end + 1;
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (quoted) continue;
    const bool ends = separator == kBlanks ? is_blank(line[i]) : line[i] == separator;
    if (ends && separator == kBlanks && start == i) {
      start = i + 1;  // one of several blanks
    } else if (ends) {
      take(i);
    }
  }
  if (start < line.size() || separator != kBlanks) take(line.size());
  while (!cells.empty() && cells.back().empty()) cells.pop_back();  // "400,1.2,1.9,"
  return cells;
}

char separator_of(std::string_view line, const IndexSource& source, std::size_t line_number) {
  char best = kBlanks;
  std::size_t most = 0;
  for (const char separator : {';', '\t', ',', kBlanks}) {
    const auto cells = cells_of(line, separator, source, line_number);
    // All the first cells that are numbers; the axis and one value at least.
    const auto stop = std::find_if(cells.begin(), cells.end(), [](std::string_view cell) {
      return !number_in(cell).has_value();
    });
    const auto numbers = static_cast<std::size_t>(stop - cells.begin());
    if (numbers >= 2) return separator;
    if (cells.size() > most && cells.size() > 1) {
      best = separator;
      most = cells.size();
    }
  }
  return best;
}

WrittenNumber NumberReader::read(std::string_view cell, const IndexSource& source, std::size_t line,
                                 std::size_t column) {
  const auto fail = [&](const std::string& message) {
    throw InputError(source.file, place_of(line, column), message);
  };
  const auto commas = std::count(cell.begin(), cell.end(), ',');
  const bool point = cell.find('.') != std::string_view::npos;
  if (commas > 0 && point) {
    fail(quoted_cell(cell) +
         " has a comma and a point; write numbers without separators of "
         "thousands");
  }
  std::string text(cell);
  if (commas == 1) std::replace(text.begin(), text.end(), ',', '.');
  const auto value = index_number(text);
  if (!value) {
    fail(cell.empty() ? "an empty cell; a row needs a number here"
                      : quoted_cell(cell) + " is not a finite number such as 0.5876 or 1.2e-5");
  }
  if (commas == 1 && comma_line_ == 0) comma_line_ = line;
  if (point && point_line_ == 0) point_line_ = line;
  if (comma_line_ > 0 && point_line_ > 0) {
    fail(fmt::format("{} has a decimal {}, but line {} has decimal {}: use one of them throughout",
                     quoted_cell(cell), point ? "point" : "comma",
                     point ? comma_line_ : point_line_, point ? "commas" : "points"));
  }
  if (text.starts_with('+')) text.erase(0, 1);
  return {*value, std::move(text)};
}

}  // namespace karat
