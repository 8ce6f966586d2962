#include "materials/index/index_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "materials/index/import/database_text.h"
#include "materials/index/import/plausible.h"
#include "materials/index/import/rows.h"
#include "materials/index/index_table_file.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{16} << 20;
constexpr std::size_t kMostComments = 100;

const IndexFormat& format_of(const IndexSource& source, const std::string& asked) {
  const auto& formats = Registry<IndexFormat>::instance();
  if (!asked.empty()) {
    if (const IndexFormat* format = formats.find(asked)) return *format;
    throw InputError(unknown_name_message("format", asked, formats.names()));
  }
  const IndexFormat* best = nullptr;
  int most = 0;
  for (const std::string& name : formats.names()) {
    const IndexFormat* format = formats.find(name);
    if (const int likeness = format->likeness(source); likeness > most) {
      best = format;
      most = likeness;
    }
  }
  return *best;  // the format "columns" takes any text
}

void settle(Doubts doubts, const IndexImportOptions& options, const std::string& file,
            std::vector<std::string>& warnings) {
  warnings.insert(warnings.end(), doubts.warnings.begin(), doubts.warnings.end());
  if (options.accept_implausible) {
    warnings.insert(warnings.end(), doubts.implausible.begin(), doubts.implausible.end());
  } else if (!doubts.implausible.empty()) {
    std::string all;
    for (const std::string& doubt : doubts.implausible) all += (all.empty() ? "" : "\n  ") + doubt;
    throw InputError(file, "", all + "\n  (--accept-implausible adds the table all the same)");
  }
}

// A hand-written table of nm, which the format takes for micrometres.
void doubt_micrometres(WavelengthRange range, Doubts& doubts) {
  constexpr double kFarInfraredNm = 1e5;
  const double low = range.min_nm / 1e3, high = range.max_nm / 1e3;
  if (range.min_nm > kFarInfraredNm && low <= kVisible.max_nm && high >= kVisible.min_nm) {
    doubts.implausible.push_back(
        fmt::format("the wavelengths run from {:.6g} to {:.6g}, and the format's unit is the "
                    "micrometre; if these are nm, divide them by 1000",
                    low, high));
  }
}

// A table of the database is taken over as it stands: formulas too, which have no rows.
IndexImport import_database(const IndexSource& source, const IndexImportOptions& options) {
  if (options.unit || !options.columns.empty() || options.negate_k) {
    throw InputError(source.file, "",
                     "a table in the database's YAML is in micrometres with columns of its own; "
                     "leave out --unit, --columns and --negate-k");
  }
  IndexImport result;
  std::string text(source.text);
  const auto table = load_index_table_text(text, source.file);
  if (!options.reference.empty() && table->provenance().reference.empty()) {
    text.insert(0, database_block("REFERENCES", {options.reference}));
  } else if (!options.reference.empty()) {
    result.warnings.push_back(
        "the file has REFERENCES of its own, which are kept; --reference is "
        "not used");
  }
  Doubts doubts;
  doubt_micrometres(table->range(), doubts);
  settle(std::move(doubts), options, source.file, result.warnings);
  result.description = "YAML, taken over as it stands";
  result.yaml = std::move(text);
  return result;
}

std::vector<std::string> comments_on(const RawTable& table, const IndexImport& result,
                                     const IndexImportOptions& options) {
  const bool permittivity =
      std::any_of(table.blocks.begin(), table.blocks.end(),
                  [](const RawBlock& block) { return block.quantities[1] == Quantity::kEps1; });
  const std::string day = options.date.empty() ? "" : " on " + options.date;
  std::vector<std::string> comments{
      fmt::format("Added from {}{}: {}; unit {}.{}{}", options.file_name, day, result.description,
                  result.unit, permittivity ? " n and k computed from the permittivity." : "",
                  options.negate_k ? " The sign of k was changed." : "")};
  const std::size_t kept = std::min(table.comments.size(), kMostComments);
  comments.insert(comments.end(), table.comments.begin(),
                  table.comments.begin() + static_cast<std::ptrdiff_t>(kept));
  if (kept < table.comments.size()) {
    comments.push_back(fmt::format("({} more lines)", table.comments.size() - kept));
  }
  return comments;
}

std::optional<ValueRange> range_of(const ImportSeries& series, WrittenNumber ImportRow::*which) {
  const auto [least, most] = std::minmax_element(series.rows.begin(), series.rows.end(),
                                                 [which](const ImportRow& a, const ImportRow& b) {
                                                   return (a.*which).value < (b.*which).value;
                                                 });
  return ValueRange{((*least).*which).value, ((*most).*which).value};
}

void measure(const ImportSeries& series, IndexImport& result) {
  if (series.has_n) result.n = range_of(series, &ImportRow::n);
  if (series.has_k) result.k = range_of(series, &ImportRow::k);
  if (!series.has_n) return;
  result.rows = series.rows.size();
  for (const ImportRow& row : series.rows) {
    const double nm = row.um.value * 1e3;
    result.visible_rows += kVisible.covers({nm, nm});
  }
}

IndexImport import_rows(RawTable table, const IndexSource& source,
                        const IndexImportOptions& options) {
  IndexImport result;
  result.warnings = std::move(table.warnings);
  const auto [unit, unit_source] = chosen_unit(table, options.unit, source.file, result.warnings);
  result.unit = axis_unit_name(unit) + " (" + unit_source + ")";
  result.description = table.description;
  Doubts doubts;
  doubt_unit(table, unit, doubts);
  std::vector<ImportSeries> series;
  for (RawBlock& block : table.blocks) {
    series.push_back(import_series({block.quantities, std::move(block.rows)}, unit,
                                   options.negate_k, source.file, result.warnings));
  }
  series = joined_series(std::move(series), source.file);
  for (const ImportSeries& one : series) {
    // Where the unit is in doubt, so is what follows from it.
    if (doubts.implausible.empty()) doubt_values(one, doubts);
    measure(one, result);
  }
  settle(std::move(doubts), options, source.file, result.warnings);
  result.yaml = database_text(options.reference, comments_on(table, result, options), series);
  return result;
}

}  // namespace

IndexImport import_index_text(std::string_view text, const std::string& file,
                              const IndexImportOptions& options) {
  if (text.size() > kLargestFile) {
    throw InputError(file, "",
                     fmt::format("{} bytes; a table has at most {}", text.size(), kLargestFile));
  }
  const IndexSource source{file, text};
  const IndexFormat& format = format_of(source, options.format);
  IndexImport result = format.is_database()
                           ? import_database(source, options)
                           : import_rows(format.read(source, options.columns), source, options);
  result.format = format.title();
  return result;
}

IndexImport import_index_file(const std::string& path, const IndexImportOptions& options) {
  return import_index_text(read_index_file(path), path, options);
}

}  // namespace karat
