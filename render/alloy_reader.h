// {"alloy": ...}: an index mixed from others by an effective-medium rule.
#pragma once

#include "render/spectrum_reader.h"

namespace karat {

// {"alloy": {NAME: part, ...}, "by": "mass"|"volume"|"atom", "model": RULE, "host": NAME}, where a
// part is its fraction, or {"fraction", "density", "molar_mass"}; a list of such objects with "nk",
// any index, does the same for parts without a name. {"alloy": "yellow-gold-18k"} is the value that
// data/alloys/yellow-gold-18k.json holds.
IndexTablePtr read_alloy(const JsonValue& value, const ReadContext& context);

}  // namespace karat
