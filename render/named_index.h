// Index tables that a scene names.
#pragma once

#include "render/spectrum_reader.h"

namespace karat {

// The table of a full name ("main/Au/Johnson") or of a file. Fails at what is neither, with what
// was probably meant: an alloy's preset, a file that is not there, columns that are no table yet.
IndexTablePtr named_index(const JsonValue& value, const ReadContext& context);

}  // namespace karat
