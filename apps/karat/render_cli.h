// The options of `karat render`.
#pragma once

#include <functional>
#include <memory>

#include "apps/karat/render_options.h"

namespace CLI {
class App;
}

namespace karat {

// Adds the subcommand; `parsed` is called when it was given and its options fit together.
void add_render_options(CLI::App& app, const std::shared_ptr<RenderCommandOptions>& options,
                        const std::function<void()>& parsed);

}  // namespace karat
