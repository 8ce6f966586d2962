// {"alloy": ...}: an index mixed from others by an effective-medium rule.
#pragma once

#include "render/spectrum_reader.h"

namespace karat {

// What solids and liquids weigh, g/cm3: aerogels go down to some 0.01, osmium, the densest of all
// substances, weighs 22.59. 8960, copper in kg/m3, is a slip of the unit.
inline constexpr double kLeastDensity = 0.01, kMostDensity = 30.0;

// {"alloy": {NAME: part, ...}, "by": "mass"|"volume"|"atom", "model": RULE, "host": NAME}, where a
// part is its fraction, or {"fraction", "density", "molar_mass"}; a list of such objects with "nk",
// any index, does the same for parts without a name. {"alloy": "yellow-gold-18k"} is the value that
// data/alloys/yellow-gold-18k.json holds (alloy_presets.h).
IndexTablePtr read_alloy(const JsonValue& value, const ReadContext& context);

}  // namespace karat
