// What `karat render` writes must not destroy what it reads, nor itself.
#pragma once

#include <string>
#include <vector>

#include "apps/karat/render_options.h"

namespace karat {

// Before anything is loaded. Throws UsageError (run_karat.h) where two outputs are one file, also
// through links; where an output is the scene file or the OpenColorIO configuration; and where the
// checkpoint's file exists and would not be gone on with.
void require_safe_outputs(const RenderCommandOptions& options);

// Throws UsageError where an output is one of `inputs`, the files that the scene was read from.
void require_outputs_apart(const RenderCommandOptions& options,
                           const std::vector<std::string>& inputs);

}  // namespace karat
