// karat nk: index tables. What it does with them stands in the folder nk.
#include <CLI/CLI.hpp>

#include "apps/karat/command.h"

namespace karat {
namespace {

class NkCommand final : public Command {
 public:
  void add_to(CLI::App& app, std::function<int()>&) const override {
    CLI::App* nk = app.add_subcommand("nk", "Index tables: find them, look at them, add your own");
    nk->require_subcommand(1);
    nk->footer("Example: karat nk show main/Au/Johnson");
  }
};

KARAT_REGISTER(Command, "nk", NkCommand);

}  // namespace
}  // namespace karat
