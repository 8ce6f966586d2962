#include "materials/index/import/database_text.h"

#include <algorithm>

#include "materials/index/import/text_lines.h"

namespace karat {
namespace {

constexpr std::size_t kLongestLine = 2000;

// The bytes of the UTF-8 character that `text` begins with; 0 where it begins with none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = byte(0) < 0x80                       ? 1
                             : byte(0) >= 0xc2 && byte(0) < 0xe0  ? 2
                             : byte(0) >= 0xe0 && byte(0) < 0xf0  ? 3
                             : byte(0) >= 0xf0 && byte(0) <= 0xf4 ? 4
                                                                  : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  return length;
}

std::string clean(std::string_view text) {
  std::string result;
  const bool cut = text.size() > kLongestLine;
  text = text.substr(0, kLongestLine);
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const auto byte = static_cast<unsigned char>(text.front());
    if (length == 0 && byte >= 0xa0) {
      result += static_cast<char>(0xc0 | (byte >> 6));
      result += static_cast<char>(0x80 | (byte & 0x3f));
    } else if (length == 0 || byte < 0x20 || byte == 0x7f || text.starts_with("\xc2\x85")) {
      result += ' ';
    } else {
      result += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return std::string(trimmed(result)) + (cut ? " ..." : "");
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines{""};
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  return lines;
}

void append_row(std::string& text, const ImportRow& row, const ImportSeries& series) {
  text.append("        ").append(row.um.text);
  if (series.has_n) text.append(" ").append(row.n.text);
  if (series.has_k) text.append(" ").append(row.k.text);
  text += '\n';
}

}  // namespace

std::string database_block(const std::string& key, const std::vector<std::string>& lines) {
  std::string body;
  for (const std::string& line : lines) {
    const std::string text = clean(line);
    if (!text.empty()) body += "    " + text + "\n";
  }
  return body.empty() ? "" : key + ": |\n" + body;
}

std::string database_text(const std::string& reference, const std::vector<std::string>& comments,
                          const std::vector<ImportSeries>& series) {
  std::string text = database_block("REFERENCES", split_lines(reference));
  text += database_block("COMMENTS", comments);
  text += "DATA:\n";
  for (const ImportSeries& one : series) {
    text += std::string("  - type: tabulated ") + (one.has_n ? "n" : "") + (one.has_k ? "k" : "");
    text += "\n    data: |\n";
    for (const ImportRow& row : one.rows) append_row(text, row, one);
  }
  return text;
}

}  // namespace karat
