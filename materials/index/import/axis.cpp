#include "materials/index/import/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "materials/index/index_rows.h"

namespace karat {
namespace {

struct UnitNames {
  AxisUnit unit;
  std::string_view name;  // what --unit takes
  int places;             // micrometres are 10^places of it; 0 where a formula converts
};
constexpr std::array<UnitNames, 5> kUnits{{{AxisUnit::kNm, "nm", -3},
                                           {AxisUnit::kUm, "um", 0},
                                           {AxisUnit::kAngstrom, "angstrom", -4},
                                           {AxisUnit::kEv, "eV", 0},
                                           {AxisUnit::kPerCm, "cm-1", 0}}};

// Spellings in lower case, without blanks. Both letters mu, and those of Latin-1, are met in files.
constexpr std::array<std::pair<std::string_view, AxisUnit>, 34> kSpellings{{
    {"nm", AxisUnit::kNm},
    {"nanometer", AxisUnit::kNm},
    {"nanometre", AxisUnit::kNm},
    {"nanometers", AxisUnit::kNm},
    {"nanometres", AxisUnit::kNm},
    {"um", AxisUnit::kUm},
    {"\u00b5m", AxisUnit::kUm},
    {"\u03bcm", AxisUnit::kUm},
    {"\xb5m", AxisUnit::kUm},
    {"mum", AxisUnit::kUm},
    {"micron", AxisUnit::kUm},
    {"microns", AxisUnit::kUm},
    {"micrometer", AxisUnit::kUm},
    {"micrometre", AxisUnit::kUm},
    {"micrometers", AxisUnit::kUm},
    {"micrometres", AxisUnit::kUm},
    {"a", AxisUnit::kAngstrom},
    {"\u00e5", AxisUnit::kAngstrom},
    {"\u00c5", AxisUnit::kAngstrom},
    {"\u212b", AxisUnit::kAngstrom},
    {"\xc5", AxisUnit::kAngstrom},
    {"angstrom", AxisUnit::kAngstrom},
    {"angstroms", AxisUnit::kAngstrom},
    {"\u00e5ngstr\u00f6m", AxisUnit::kAngstrom},
    {"\u00c5ngstr\u00f6m", AxisUnit::kAngstrom},
    {"ev", AxisUnit::kEv},
    {"electronvolt", AxisUnit::kEv},
    {"electronvolts", AxisUnit::kEv},
    {"cm-1", AxisUnit::kPerCm},
    {"cm^-1", AxisUnit::kPerCm},
    {"cm^{-1}", AxisUnit::kPerCm},
    {"1/cm", AxisUnit::kPerCm},
    {"cm\u207b\u00b9", AxisUnit::kPerCm},
    {"cm\u22121", AxisUnit::kPerCm},
}};

const UnitNames& names_of(AxisUnit unit) {
  return *std::find_if(kUnits.begin(), kUnits.end(),
                       [unit](const UnitNames& names) { return names.unit == unit; });
}

}  // namespace

WrittenNumber written(double value) { return {value, fmt::format("{}", value)}; }

std::string axis_unit_name(AxisUnit unit) { return std::string(names_of(unit).name); }

std::optional<AxisUnit> axis_unit(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    if (c != ' ' && c != '\t')
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  for (const auto& [spelling, unit] : kSpellings) {
    if (spelling == plain) return unit;
  }
  return std::nullopt;
}

double micrometres(double number, AxisUnit unit) {
  switch (unit) {
    case AxisUnit::kNm:
      return number / 1e3;
    case AxisUnit::kUm:
      return number;
    case AxisUnit::kAngstrom:
      return number / 1e4;
    case AxisUnit::kEv:
      return kEvMicrometres / number;
    case AxisUnit::kPerCm:
      return 1e4 / number;
  }
  return number;
}

WrittenNumber micrometres(const WrittenNumber& number, AxisUnit unit) {
  if (unit == AxisUnit::kUm) return number;
  if (unit == AxisUnit::kEv || unit == AxisUnit::kPerCm) {
    return written(micrometres(number.value, unit));
  }
  const std::string text = shifted_decimal(number.text, names_of(unit).places);
  return {index_number(text).value_or(0.0), text};
}

std::string shifted_decimal(std::string_view text, int places) {
  // The exponent is left alone where there is one: the point is moved before it.
  std::size_t mantissa = text.find_first_of("eEdD");
  if (mantissa == std::string_view::npos) {
    mantissa = text.find_first_of("+-", 1);  // Fortran's "1.80-17"
  }
  const std::string_view rest = mantissa < text.size() ? text.substr(mantissa) : std::string_view();
  text = text.substr(0, text.size() - rest.size());
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t point = std::min(text.find('.'), text.size());
  std::string digits(text.substr(0, point));
  if (point < text.size()) digits += text.substr(point + 1);
  auto before = static_cast<std::ptrdiff_t>(point) + places;  // digits in front of the new point
  if (before < 1) {
    digits.insert(0, static_cast<std::size_t>(1 - before), '0');
    before = 1;
  }
  const auto size = static_cast<std::ptrdiff_t>(digits.size());
  if (before > size) digits.append(static_cast<std::size_t>(before - size), '0');
  std::string whole = digits.substr(0, static_cast<std::size_t>(before));
  const std::string fraction = digits.substr(static_cast<std::size_t>(before));
  whole.erase(0, std::min(whole.find_first_not_of('0'), whole.size() - 1));
  return (negative ? "-" : "") + whole + (fraction.empty() ? "" : "." + fraction) +
         std::string(rest);
}

}  // namespace karat
