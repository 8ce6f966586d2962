// Lines and cells of text files of numbers.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "materials/index/import/axis.h"
#include "materials/index/import/format.h"

namespace karat {

struct TextLine {
  std::size_t number = 0;  // from 1
  std::string_view text;   // without blanks around it
};

// The lines that are not blank; ends of line are LF, CR LF or CR. A byte order mark is left out.
// Throws InputError for UTF-16, binary files, and more lines than a table may have.
std::vector<TextLine> text_lines(const IndexSource& source);

std::string_view trimmed(std::string_view text);

// True where a line begins like a number: a digit, sign, point or quote.
bool begins_like_a_number(std::string_view text);

// The comment of a line that is one, without its marker (#, %, !, //, ;); nothing otherwise.
// Semicolons are no markers where they separate cells.
std::optional<std::string> comment_in(std::string_view line, char separator);

// The line of numbers without the comment (#, %, //) behind it.
std::string_view without_tail(std::string_view line);

inline constexpr char kBlanks = ' ';  // the separator that stands for any number of blanks

// The cells of a line, without blanks and double quotes around them. Throws InputError for more
// than 64 cells.
std::vector<std::string_view> cells_of(std::string_view line, char separator,
                                       const IndexSource& source, std::size_t line_number);

// What separates the cells of a line of numbers: ';', tab, ',' or kBlanks.
char separator_of(std::string_view line, const IndexSource& source, std::size_t line_number);

// Reads numbers with points or with commas, but not both in one file: "1.234" may be either then.
class NumberReader {
 public:
  // Throws InputError naming line and column.
  WrittenNumber read(std::string_view cell, const IndexSource& source, std::size_t line,
                     std::size_t column);
  bool decimal_comma() const { return comma_line_ > 0; }

 private:
  std::size_t comma_line_ = 0, point_line_ = 0;
};

// "line 12, column 3"
std::string place_of(std::size_t line, std::size_t column);
// In quotes, cut after 40 bytes, control characters replaced.
std::string quoted_cell(std::string_view text);

}  // namespace karat
