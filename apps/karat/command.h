// A subcommand of karat. One source file each, ending in KARAT_REGISTER(Command, "nk", NkCommand);
#pragma once
#include <functional>
#include <string>

#include "spectral/support/registry.h"
namespace CLI {
class App;
}
namespace karat {
class Command {
 public:
  virtual ~Command() = default;
  // Adds the subcommand with its options to `app`. What it is to do is stored in `action`, which
  // main calls after parsing and whose result is the exit code.
  virtual void add_to(CLI::App& app, std::function<int()>& action) const = 0;
};
}  // namespace karat
