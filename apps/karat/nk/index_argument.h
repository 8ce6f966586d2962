// An index where a command expects one: a table by name, or one that is made as in scenes.
#pragma once

#include <string>

#include "materials/index/index_table.h"

namespace karat {

// What these words of the command line mean:
//   main/Au/Johnson, Au/Johnson, my/metal.yml   a table (full_index_name)
//   alloy:rose-gold-18k                         a preset (render/alloy_presets.h)
//   {"alloy": {...}, "by": "mass"}              an index as scenes write it (render/index_reader.h)
//   my_gold.json                                a file of such an index, or of a preset
// Throws InputError; so do stacks of films, which have no n and k.
IndexTablePtr index_of_argument(const std::string& typed);

// Whether these words are one of the last three.
bool is_made_index(const std::string& typed);

// For help texts.
std::string index_argument_help();

// "; --nm is in nm: 0.55 um is 550" where micrometres were meant: `asked` is not in `covered`, but
// a thousand times as long would be. "" otherwise.
std::string unit_hint(const std::string& option, WavelengthRange asked, WavelengthRange covered);

}  // namespace karat
