#include "tests/material_cases.h"

#include <nlohmann/json.hpp>

#include "spectral/support/error.h"

namespace karat::test {
namespace {

// Like glass: n falls with the wavelength.
IndexTablePtr glass() {
  return index_from_spectra(table_spectrum({380.0, 780.0}, {1.6, 1.5}, "n of the test glass"),
                            constant_spectrum(0.0), {});
}

// Like gold: an edge in the visible.
IndexTablePtr metal() {
  return index_from_spectra(
      table_spectrum({380.0, 480.0, 560.0, 780.0}, {1.6, 1.4, 0.35, 0.15}, "n of the test metal"),
      table_spectrum({380.0, 480.0, 560.0, 780.0}, {1.9, 1.9, 2.6, 4.6}, "k of the test metal"),
      {});
}

ParameterValue default_value(const ParameterInfo& info) {
  const auto json = nlohmann::json::parse(info.default_json);
  if (info.type == ParameterType::kReflectance || info.type == ParameterType::kEmission) {
    return constant_spectrum(json.get<double>());
  }
  if (info.type == ParameterType::kIndex) return constant_index({json.get<double>(), 0.0});
  if (info.type == ParameterType::kFresnel) return FresnelChoice{json.get<std::string>()};
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number()) return json.get<double>();
  return json.get<std::string>();
}

// One setting of a parameter, and how a failure names it.
struct Setting {
  std::string name;
  std::string parameter;
  ParameterValue value;
};

std::vector<Setting> choices_of(const std::vector<ParameterInfo>& infos) {
  std::vector<Setting> settings;
  for (const ParameterInfo& info : infos) {
    for (const std::string& choice : info.choices) {
      const bool fresnel = info.type == ParameterType::kFresnel;
      settings.push_back({info.name + "=" + choice, info.name,
                          fresnel ? ParameterValue(FresnelChoice{choice}) : choice});
    }
  }
  return settings;
}

// Flags are flipped.
std::vector<Setting> flags_of(const std::vector<ParameterInfo>& infos) {
  std::vector<Setting> settings;
  for (const ParameterInfo& info : infos) {
    if (info.type != ParameterType::kBoolean) continue;
    const bool flipped = info.default_json != "true";
    settings.push_back({info.name + "=" + (flipped ? "true" : "false"), info.name, flipped});
  }
  return settings;
}

std::vector<Setting> numbers_of(const std::vector<ParameterInfo>& infos) {
  std::vector<Setting> settings;
  for (const ParameterInfo& info : infos) {
    if (info.type != ParameterType::kNumber || !(info.max - info.min < 1e6)) continue;
    for (const double at : {0.05, 0.3, 1.0}) {
      const double value = info.min + at * (info.max - info.min);
      settings.push_back({info.name + "=" + std::to_string(value), info.name, value});
    }
  }
  return settings;
}

class Cases {
 public:
  Cases() {
    for (const std::string& type : Registry<MaterialType>::instance().names()) add_type(type);
  }
  std::vector<MaterialCase> all;

 private:
  void add_type(const std::string& type) {
    const auto infos = Registry<MaterialType>::instance().find(type)->parameters();
    add(type, {});
    for (const Setting& choice : choices_of(infos)) {
      add(type, {choice});
      // Fresnel models only scale what the distribution does: one roughness for each is enough.
      if (choice.parameter == "fresnel") {
        add(type, {choice, {"alpha=0.3", "alpha", 0.3}});
        continue;
      }
      for (const Setting& number : numbers_of(infos)) add(type, {choice, number});
      for (const Setting& flag : flags_of(infos)) {
        for (const Setting& number : numbers_of(infos)) add(type, {choice, flag, number});
      }
    }
    bool anisotropic = false;
    for (const ParameterInfo& info : infos) anisotropic |= info.name == "alpha_x";
    if (!anisotropic) return;
    for (const std::string distribution : {"ggx", "beckmann"}) {
      add(type, {{"distribution=" + distribution, "distribution", distribution},
                 {"alpha_x=0.1", "alpha_x", 0.1},
                 {"alpha_y=0.4", "alpha_y", 0.4}});
    }
  }

  // Settings that the type refuses together are no case.
  void add(const std::string& type, const std::vector<Setting>& settings) {
    std::string name = type;
    Parameters values;
    for (const Setting& s : settings) {
      name += " " + s.name;
      values.set(s.parameter, s.value);
    }
    try {
      all.push_back({name, make_material(type, values)});
    } catch (const InputError&) {
    }
  }
};

}  // namespace

std::shared_ptr<const Material> make_material(const std::string& type, const Parameters& values,
                                              std::vector<std::string>* warnings,
                                              const std::string& fresnel_override) {
  const MaterialType& kind = *Registry<MaterialType>::instance().find(type);
  Parameters parameters = values;
  for (const ParameterInfo& info : kind.parameters()) {
    if (parameters.has(info.name)) continue;
    if (!info.default_json.empty()) {
      parameters.set(info.name, default_value(info));
    } else if (info.required && info.type == ParameterType::kIndex) {
      parameters.set(info.name, info.name == "nk" ? metal() : glass());
    }
  }
  std::vector<std::string> ignored;
  return kind.create(parameters,
                     {WavelengthLattice(), fresnel_override, warnings ? warnings : &ignored});
}

const std::vector<MaterialCase>& material_cases() {
  static const Cases cases;
  return cases.all;
}

}  // namespace karat::test
