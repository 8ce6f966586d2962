// karat schema: the JSON schema of scene files, or the same as a page to read.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "apps/karat/command.h"
#include "apps/karat/scene_reference.h"
#include "render/scene_loader.h"

namespace karat {
namespace {

class SchemaCommand final : public Command {
 public:
  void add_to(CLI::App& app, std::function<int()>& action) const override {
    CLI::App* command =
        app.add_subcommand("schema", "Print the JSON schema of scene files, or all keys as a page");
    auto markdown = std::make_shared<bool>(false);
    command->add_flag("--markdown", *markdown,
                      "A page to read instead (Markdown): every key with unit, range and default");
    command->footer("Example: karat schema > scene.schema.json");
    command->callback([&action, markdown] {
      action = [markdown] {
        const std::string text = *markdown ? scene_reference() : scene_schema();
        std::fputs(text.c_str(), stdout);
        return 0;
      };
    });
  }
};

KARAT_REGISTER(Command, "schema", SchemaCommand);

}  // namespace
}  // namespace karat
