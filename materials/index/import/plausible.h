// Whether a measured table can be what it says: units, signs, magnitudes, sampling.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "materials/index/import/format.h"
#include "materials/index/import/rows.h"

namespace karat {

// What speaks against a table, each a sentence that ends in what to do.
struct Doubts {
  std::vector<std::string> implausible;  // refused unless the caller insists
  std::vector<std::string> warnings;
};

struct ChosenUnit {
  AxisUnit unit;
  std::string source;  // "line 1", "--unit", "guessed from the numbers"
};

// The unit asked for, the one that the file states, or the only one in which the numbers cover 400
// to 700 nm (or, where none does, reach the visible); the last with a warning. Throws InputError
// where there is no such only one.
ChosenUnit chosen_unit(const RawTable& table, std::optional<AxisUnit> asked,
                       const std::string& file, std::vector<std::string>& warnings);

// Whether the unit can be meant: a table of nm that runs from 0.3 to 2 is one of micrometres.
void doubt_unit(const RawTable& table, AxisUnit unit, Doubts& doubts);

// Whether the values can be: signs, magnitudes, n and k in each other's place, rows in the visible.
void doubt_values(const ImportSeries& series, Doubts& doubts);

}  // namespace karat
