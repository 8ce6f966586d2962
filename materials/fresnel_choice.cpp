#include "materials/fresnel_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "materials/relative_index.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

void require_known(const FresnelChoice& choice, const std::vector<FresnelParameter>& infos) {
  std::vector<std::string> known;
  for (const FresnelParameter& info : infos) known.push_back(info.name);
  for (const auto& [name, value] : choice.parameters) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw InputError("", "fresnel/parameters",
                     known.empty()
                         ? fmt::format("\"{}\" has no free parameters", choice.model)
                         : unknown_name_message("parameter of " + choice.model, name, known));
  }
}

LatticeSpectrum stated(const FresnelChoice& choice, const FresnelParameter& info,
                       const WavelengthLattice& lattice) {
  const auto fail = [&](const std::string& message) {
    throw InputError("", "fresnel/parameters/" + info.name, message);
  };
  const auto it = choice.parameters.find(info.name);
  if (it == choice.parameters.end()) {
    fail(fmt::format("is missing: \"{}\" needs all its parameters, or none", choice.model));
  }
  const LatticeSpectrum values = point_samples(*it->second, lattice);
  const Extremes found = extremes(values);
  // Stated in double precision, met in float: an end of the range may be missed by a rounding.
  const double slack = 1e-6 * (info.max - info.min);
  for (const double value : {double{found.least}, double{found.largest}}) {
    const double end = std::clamp(value, info.min, info.max);
    const std::string error = parameter_error(info, std::abs(value - end) <= slack ? end : value);
    if (!error.empty()) fail(error);
  }
  if (info.per_material && found.least != found.largest) {
    fail(fmt::format("varies over wavelength; \"{}\" takes one number", choice.model));
  }
  return values;
}

}  // namespace

ParameterInfo fresnel_parameter() {
  ParameterInfo fresnel;
  fresnel.name = "fresnel";
  fresnel.type = ParameterType::kFresnel;
  fresnel.description = "Fresnel model, exact or an approximation";
  fresnel.default_json = "\"exact\"";
  fresnel.choices = Registry<FresnelModel>::instance().names();
  return fresnel;
}

PreparedFresnel prepare_fresnel(const Parameters& parameters, const LatticeIndex& index,
                                const MaterialContext& context) {
  const FresnelChoice& choice = parameters.fresnel("fresnel");
  const FresnelModel& said = fresnel_model(choice.model);
  const FresnelModel& model =
      context.fresnel_override.empty() ? said : fresnel_model(context.fresnel_override);
  if (choice.parameters.empty()) return {&model, model.prepare(index)};
  const std::vector<FresnelParameter> infos = said.parameters();
  require_known(choice, infos);
  std::vector<LatticeSpectrum> values;
  for (const FresnelParameter& info : infos) {
    values.push_back(stated(choice, info, context.lattice));
  }
  if (&model == &said) return {&model, model.prepare_with(index, values)};
  context.warnings->push_back("the parameters of \"" + choice.model +
                              "\" are not used: --fresnel names \"" + context.fresnel_override +
                              "\"");
  return {&model, model.prepare(index)};
}

}  // namespace karat
