#include "materials/index/import/column_layout.h"

#include <fmt/format.h>

#include <algorithm>

#include "materials/index/import/header.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr const char* kHint =
    "; say what the columns are: --columns wavelength,n,k (also energy, wavenumber, eps1, eps2, "
    "and - for one to skip)";

std::string line_place(std::size_t line) { return fmt::format("line {}", line); }

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + quoted_cell(name);
  return text;
}

// Where a quantity stands among the names; the first place of several.
std::optional<std::size_t> place_in(const std::vector<ColumnMeaning>& meanings, Quantity quantity) {
  const auto found = std::find_if(meanings.begin(), meanings.end(), [&](const ColumnMeaning& one) {
    return one.quantity == quantity;
  });
  if (found == meanings.end()) return std::nullopt;
  return static_cast<std::size_t>(found - meanings.begin());
}

// The quantities that make a table: n with or without k, otherwise both parts of the permittivity,
// otherwise k (a further block then has n).
std::vector<Quantity> wanted(const std::vector<ColumnMeaning>& meanings) {
  const auto has = [&](Quantity quantity) { return place_in(meanings, quantity).has_value(); };
  if (has(Quantity::kN) && has(Quantity::kK)) return {Quantity::kN, Quantity::kK};
  if (has(Quantity::kEps1) && has(Quantity::kEps2)) return {Quantity::kEps1, Quantity::kEps2};
  if (has(Quantity::kN)) return {Quantity::kN};
  if (has(Quantity::kK)) return {Quantity::kK};
  return {};
}

std::optional<ColumnLayout> layout_of(const std::vector<ColumnMeaning>& meanings,
                                      const std::vector<std::string>& names) {
  const auto axis = place_in(meanings, Quantity::kAxis);
  const auto quantities = wanted(meanings);
  if (!axis || quantities.empty()) return std::nullopt;
  ColumnLayout layout{{*axis}, {Quantity::kAxis}, meanings[*axis].axis, meanings[*axis].unit, "",
                      {}};
  for (const Quantity quantity : quantities) {
    layout.columns.push_back(*place_in(meanings, quantity));
    layout.quantities.push_back(quantity);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& used = layout.columns;
    if (std::find(used.begin(), used.end(), i) == used.end()) {
      layout.unused.push_back(fmt::format("column {} {}", i + 1, quoted_cell(names[i])));
    }
  }
  return layout;
}

std::vector<ColumnMeaning> meanings_of(const std::vector<std::string>& names) {
  std::vector<ColumnMeaning> meanings;
  for (const std::string& name : names) meanings.push_back(column_meaning(name));
  return meanings;
}

// The unit in a line of its own below or above the names: "nm, , ".
void find_unit(ColumnLayout& layout, const BlockHead& head, std::size_t count, char separator) {
  for (const TextLine& line : head.header) {
    if (layout.unit) return;
    const auto names = header_names(line.text, separator, 1);
    if (names.size() > count || layout.columns[0] >= names.size()) continue;
    std::string_view cell = names[layout.columns[0]];
    if (!cell.empty() && (cell.front() == '(' || cell.front() == '[')) {
      cell = cell.substr(1, cell.size() - 2 + (cell.size() < 2));
    }
    layout.unit = axis_unit(cell);
    layout.unit_source = line_place(line.number);
  }
  if (!layout.unit) layout.unit_source.clear();
}

// The unit in the file's own name of the axis, "Wavelength (nm)", where the caller says what the
// columns are.
void find_named_unit(ColumnLayout& layout, const BlockHead& head, char separator) {
  for (const auto* lines : {&head.header, &head.comments}) {
    for (const TextLine& line : *lines) {
      const auto names = header_names(line.text, separator, 2);
      if (layout.unit || layout.columns[0] >= names.size()) continue;
      const ColumnMeaning axis = column_meaning(names[layout.columns[0]]);
      if (axis.quantity != Quantity::kAxis || !axis.unit) continue;
      layout.axis = axis.axis;
      layout.unit = axis.unit;
      layout.unit_source = line_place(line.number);
    }
  }
}

void reject_repeats(const std::vector<ColumnMeaning>& meanings, const IndexSource& source,
                    std::size_t line) {
  for (const Quantity quantity : {Quantity::kN, Quantity::kK, Quantity::kEps1, Quantity::kEps2}) {
    const auto first = place_in(meanings, quantity);
    for (std::size_t i = first ? *first + 1 : meanings.size(); i < meanings.size(); ++i) {
      if (meanings[i].quantity == quantity) {
        throw InputError(source.file, line_place(line),
                         fmt::format("columns {} and {} are both called {}{}", *first + 1, i + 1,
                                     quantity_name(quantity), kHint));
      }
    }
  }
}

// The layout that a line of names describes, where it does. A line that is separated like the rows
// and has as many cells can only be names: not to know them is an error.
std::optional<ColumnLayout> layout_of_line(const TextLine& line, std::size_t count, char separator,
                                           bool comment, const IndexSource& source) {
  std::vector<char> separators{separator};
  if (comment) separators = {separator, ',', kBlanks};
  for (const char one : separators) {
    const auto names = header_names(line.text, one, 2);
    if (names.empty() || names.size() > count) continue;
    const auto meanings = meanings_of(names);
    auto layout = layout_of(meanings, names);
    if (layout) {
      reject_repeats(meanings, source, line.number);
      if (layout->unit) layout->unit_source = line_place(line.number);
      return layout;
    }
    const bool is_units = std::all_of(names.begin(), names.end(), [](const std::string& name) {
      return name.empty() || name == "-" || axis_unit(name).has_value();
    });
    if (!comment && separator != kBlanks && names.size() == count && !is_units) {
      throw InputError(
          source.file, line_place(line.number),
          "the names " + listed(names) + " do not tell where wavelength and n are" + kHint);
    }
  }
  return std::nullopt;
}

}  // namespace

std::string ColumnLayout::description() const {
  std::string text;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool energy = i == 0 && axis == AxisKind::kEnergy;
    const bool number = i == 0 && axis == AxisKind::kWavenumber;
    text += fmt::format("{}{} {}", text.empty() ? "column " : ", ", columns[i] + 1,
                        energy   ? "energy"
                        : number ? "wavenumber"
                                 : quantity_name(quantities[i]));
  }
  for (const std::string& column : unused) text += "; " + column + " not used";
  return text;
}

ColumnLayout layout_of_names(const ColumnNames& names, const BlockHead& head, std::size_t count,
                             char separator, const IndexSource& source, std::size_t line) {
  if (names.size() > count) {
    throw InputError(source.file, line_place(line),
                     fmt::format("{} columns; --columns names {}", count, names.size()));
  }
  std::vector<ColumnMeaning> meanings;
  for (const auto& name : names) meanings.push_back({name, AxisKind::kUnknown, std::nullopt});
  const std::vector<std::string> no_names;
  auto layout = layout_of(meanings, no_names);
  if (!layout) {
    throw InputError("--columns", "",
                     "names no table; needed are wavelength with n, n and k, or eps1 and eps2");
  }
  reject_repeats(meanings, source, line);
  find_named_unit(*layout, head, separator);
  if (!layout->unit) find_unit(*layout, head, count, separator);
  return *layout;
}

ColumnLayout layout_of_head(const BlockHead& head, std::size_t count, char separator,
                            const IndexSource& source, std::size_t line) {
  for (auto at = head.header.rbegin(); at != head.header.rend(); ++at) {
    if (auto layout = layout_of_line(*at, count, separator, false, source)) {
      find_unit(*layout, head, count, separator);
      return *layout;
    }
  }
  for (auto at = head.comments.rbegin(); at != head.comments.rend(); ++at) {
    if (auto layout = layout_of_line(*at, count, separator, true, source)) return *layout;
  }
  if (count != 2 && count != 3) {
    throw InputError(source.file, line_place(line),
                     fmt::format("{} column{} without names that tell which is which{}", count,
                                 count == 1 ? "" : "s", kHint));
  }
  ColumnLayout layout{{0, 1}, {Quantity::kAxis, Quantity::kN}, AxisKind::kUnknown, {}, "", {}};
  if (count == 3) {
    layout.columns.push_back(2);
    layout.quantities.push_back(Quantity::kK);
  }
  find_unit(layout, head, count, separator);
  return layout;
}

}  // namespace karat
