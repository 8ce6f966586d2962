// A subcommand of karat. One source file each, ending in KARAT_REGISTER(Command, "render", Render);
#pragma once
#include <functional>
#include <string>

#include "spectral/support/registry.h"
namespace CLI {
class App;
}
namespace karat {
// Registered by its name. A name of two words is a command within a command: "nk list" is added to
// what "nk" added.
class Command {
 public:
  virtual ~Command() = default;
  // Adds the subcommand with its options to `parent`. What it is to do is stored in `action`, which
  // run_karat calls after parsing and whose result is the exit code.
  virtual void add_to(CLI::App& parent, std::function<int()>& action) const = 0;
};
}  // namespace karat
