// karat fresnel: the Fresnel models. What it does with them stands in the folder fresnel.
#include <CLI/CLI.hpp>

#include "apps/karat/command.h"

namespace karat {
namespace {

class FresnelCommand final : public Command {
 public:
  void add_to(CLI::App& app, std::function<int()>&) const override {
    CLI::App* fresnel =
        app.add_subcommand("fresnel", "Fresnel models: evaluate, fit and compare them");
    fresnel->require_subcommand(1);
    fresnel->footer("Example: karat fresnel study -o study");
  }
};

KARAT_REGISTER(Command, "fresnel", FresnelCommand);

}  // namespace
}  // namespace karat
