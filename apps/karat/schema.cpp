// karat schema: the JSON schema of scene files.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "apps/karat/command.h"
#include "render/scene_loader.h"

namespace karat {
namespace {

class SchemaCommand final : public Command {
 public:
  void add_to(CLI::App& app, std::function<int()>& action) const override {
    CLI::App* command = app.add_subcommand("schema", "Print the JSON schema of scene files");
    command->footer("Example: karat schema > scene.schema.json");
    command->callback([&action] {
      action = [] {
        std::fputs(scene_schema().c_str(), stdout);
        return 0;
      };
    });
  }
};

KARAT_REGISTER(Command, "schema", SchemaCommand);

}  // namespace
}  // namespace karat
