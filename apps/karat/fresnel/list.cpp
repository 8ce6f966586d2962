// karat fresnel list: the Fresnel models and where they come from.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "apps/karat/command.h"
#include "apps/karat/json_output.h"
#include "materials/fresnel.h"

namespace karat {
namespace {

using Models = Registry<FresnelModel>;

nlohmann::ordered_json parameters_json(const FresnelModel& model) {
  nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
  for (const FresnelParameter& info : model.parameters()) {
    parameters.push_back({{"name", info.name},
                          {"description", info.description},
                          {"range", {info.min, info.max}},
                          {"per_material", info.per_material},
                          {"whole_number", info.whole_number}});
  }
  return parameters;
}

int list(bool as_json) {
  nlohmann::ordered_json models = nlohmann::ordered_json::array();
  for (const std::string& name : Models::instance().names()) {
    const FresnelModel& model = *Models::instance().find(name);
    if (as_json) {
      models.push_back({{"name", name},
                        {"description", model.description()},
                        {"source", model.source()},
                        {"per_wavelength", model.per_wavelength()},
                        {"parameters", parameters_json(model)}});
    } else {
      fmt::print("{}\n    {}\n    {}\n", name, model.description(), model.source());
      for (const FresnelParameter& info : model.parameters()) {
        fmt::print("    parameter {}: {}, {:g} to {:g}{}\n", info.name, info.description, info.min,
                   info.max, info.per_material ? ", one for all wavelengths" : "");
      }
    }
  }
  if (as_json) print_json(models);
  return 0;
}

class FresnelList final : public Command {
 public:
  void add_to(CLI::App& fresnel, std::function<int()>& action) const override {
    CLI::App* listing = fresnel.add_subcommand("list", "List the Fresnel models");
    const auto as_json = std::make_shared<bool>(false);
    listing->add_flag("--json", *as_json, "Machine-readable output");
    listing->footer("Example: karat fresnel list --json");
    listing->callback([&action, as_json] { action = [as_json] { return list(*as_json); }; });
  }
};

KARAT_REGISTER(Command, "fresnel list", FresnelList);

}  // namespace
}  // namespace karat
