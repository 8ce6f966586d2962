// Parameters as a scene that gives none would set them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "materials/parameters.h"

namespace karat {

inline Parameters default_parameters(const std::vector<ParameterInfo>& infos) {
  Parameters parameters;
  for (const ParameterInfo& info : infos) {
    if (info.default_json.empty()) continue;
    const nlohmann::json json = nlohmann::json::parse(info.default_json);
    switch (info.type) {
      case ParameterType::kNumber:
      case ParameterType::kInteger:
        parameters.set(info.name, json.get<double>());
        break;
      case ParameterType::kBoolean:
        parameters.set(info.name, json.get<bool>());
        break;
      case ParameterType::kString:
      case ParameterType::kChoice:
      case ParameterType::kPath:
        parameters.set(info.name, json.get<std::string>());
        break;
      case ParameterType::kVector3:
        parameters.set(info.name, Vec3{json[0], json[1], json[2]});
        break;
      case ParameterType::kVector2:
        parameters.set(info.name, Vec2{json[0], json[1]});
        break;
      case ParameterType::kReflectance:
      case ParameterType::kEmission:
        parameters.set(info.name, constant_spectrum(json.get<double>()));
        break;
      case ParameterType::kFresnel:
        parameters.set(info.name, FresnelChoice{json.get<std::string>()});
        break;
      case ParameterType::kIndex:
        break;
    }
  }
  return parameters;
}

}  // namespace karat
