#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "materials/index/import/plausible.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

// What is called the optical range here; of the database's tables fewer than one in a hundred lie
// outside it altogether.
constexpr WavelengthRange kOptical{80.0, 100e3};
constexpr WavelengthRange kColours{400.0, 700.0};

struct Span {
  double low = 0.0, high = 0.0;
};

Span axis_span(const RawTable& table) {
  Span span{std::numeric_limits<double>::infinity(), 0.0};
  for (const RawBlock& block : table.blocks) {
    for (const RawRow& row : block.rows) {
      span.low = std::min(span.low, row.numbers[0].value);
      span.high = std::max(span.high, row.numbers[0].value);
    }
  }
  return span;
}

WavelengthRange range_in(Span span, AxisUnit unit) {
  const double a = micrometres(span.low, unit) * 1e3, b = micrometres(span.high, unit) * 1e3;
  return {std::min(a, b), std::max(a, b)};
}

bool overlap(WavelengthRange a, WavelengthRange b) {
  return a.min_nm <= b.max_nm && b.min_nm <= a.max_nm;
}

bool possible(AxisUnit unit, AxisKind kind) {
  switch (kind) {
    case AxisKind::kWavelength:
      return unit != AxisUnit::kEv && unit != AxisUnit::kPerCm;
    case AxisKind::kEnergy:
      return unit == AxisUnit::kEv;
    case AxisKind::kWavenumber:
      return unit == AxisUnit::kPerCm;
    case AxisKind::kUnknown:
      break;
  }
  return true;
}

template <typename Condition>
std::vector<AxisUnit> units_where(Condition holds) {
  std::vector<AxisUnit> units;
  std::copy_if(kAxisUnits.begin(), kAxisUnits.end(), std::back_inserter(units), holds);
  return units;
}

// "um (300 to 2000 nm) or eV (620 to 4133 nm)"
std::string alternatives(const std::vector<AxisUnit>& units, Span span) {
  std::string text;
  for (const AxisUnit unit : units) {
    const WavelengthRange range = range_in(span, unit);
    text += fmt::format("{}{} ({:.4g} to {:.4g} nm)", text.empty() ? "" : " or ",
                        axis_unit_name(unit), range.min_nm, range.max_nm);
  }
  return text;
}

std::string options_for(const std::vector<AxisUnit>& units) {
  std::string text;
  for (const AxisUnit unit : units) {
    text += (text.empty() ? "--unit " : " or --unit ") + axis_unit_name(unit);
  }
  return text;
}

}  // namespace

ChosenUnit chosen_unit(const RawTable& table, std::optional<AxisUnit> asked,
                       const std::string& file, std::vector<std::string>& warnings) {
  if (asked) {
    if (table.unit && table.unit != asked) {
      warnings.push_back(fmt::format("--unit {} is used; the file says {} ({})",
                                     axis_unit_name(*asked), axis_unit_name(*table.unit),
                                     table.unit_source));
    }
    return {*asked, "--unit"};
  }
  if (table.unit) return {*table.unit, table.unit_source};
  const Span span = axis_span(table);
  const auto in_kind = [&](AxisUnit unit) { return possible(unit, table.axis); };
  auto units = units_where(
      [&](AxisUnit unit) { return in_kind(unit) && range_in(span, unit).covers(kColours); });
  if (units.empty()) {
    units = units_where(
        [&](AxisUnit unit) { return in_kind(unit) && overlap(range_in(span, unit), kVisible); });
  }
  if (units.size() == 1) {
    warnings.push_back(fmt::format(
        "the unit is not stated: {} is taken, the only one in which {:.6g} to {:.6g} is visible "
        "light; --unit states it",
        axis_unit_name(units[0]), span.low, span.high));
    return {units[0], "guessed from the numbers"};
  }
  const auto all = units_where(in_kind);
  throw InputError(file, "",
                   fmt::format("the unit is not stated, and {:.6g} to {:.6g} may be {}: say {}",
                               span.low, span.high, alternatives(units.empty() ? all : units, span),
                               options_for(units.empty() ? all : units)));
}

void doubt_unit(const RawTable& table, AxisUnit unit, Doubts& doubts) {
  const Span span = axis_span(table);
  const WavelengthRange range = range_in(span, unit);
  if (overlap(range, kVisible)) return;
  const auto better = units_where([&](AxisUnit other) {
    return other != unit && possible(other, table.axis) && overlap(range_in(span, other), kVisible);
  });
  const std::string run = fmt::format(
      "{:.6g} to {:.6g} {}{}", span.low, span.high, axis_unit_name(unit),
      unit == AxisUnit::kNm
          ? ""
          : fmt::format(" (wavelengths of {:.4g} to {:.4g} nm)", range.min_nm, range.max_nm));
  if (!overlap(range, kOptical) && !better.empty()) {
    doubts.implausible.push_back(
        fmt::format("the axis runs from {}, which no optical table does; as {} it would reach the "
                    "visible: say {}",
                    run, alternatives(better, span), options_for(better)));
    return;
  }
  std::string hint;
  if (!better.empty() && table.axis == AxisKind::kUnknown) {
    hint = fmt::format("; were it {}, say {}", alternatives(better, span), options_for(better));
  }
  doubts.warnings.push_back(
      fmt::format("the axis runs from {}: none of it is visible{}", run, hint));
}

}  // namespace karat
