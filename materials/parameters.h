// Described parameters: every registered type (material, shape, light, camera) lists its
// parameters, and receives their checked values. The scene loader reads them, the schema and the
// help are written from the same list; no type parses anything itself.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "materials/index/index_table.h"
#include "materials/vector.h"
#include "spectral/spectrum.h"

namespace karat {

enum class ParameterType {
  kNumber,   // double
  kInteger,  // double, whole
  kBoolean,
  kString,       // free text
  kChoice,       // one of `choices`
  kPath,         // a file, relative to the scene file; stored absolute
  kVector3,      // [x, y, z]
  kVector2,      // [x, y]
  kReflectance,  // spectrum within [0, 1]
  kEmission,     // spectrum >= 0 in W m^-2 sr^-1 nm^-1 (or the unit the type states)
  kIndex,        // complex index table
  kFresnel,      // one of `choices`, or {"model": one of them, "parameters": {NAME: spectrum}}
};

struct ParameterInfo {
  std::string name;
  ParameterType type = ParameterType::kNumber;
  std::string description;  // one sentence, with the unit
  bool required = false;
  // Default as JSON text ("0.1", "\"ggx\"", "[0, 0, 1]"); empty: absent unless given.
  std::string default_json = {};
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool exclusive_min = false;  // the bound itself is not allowed
  std::vector<std::string> choices = {};
};

// A Fresnel model, and values of its free parameters: all that it lists, or none, and then it
// chooses them for the material.
struct FresnelChoice {
  std::string model;
  std::map<std::string, SpectrumPtr> parameters = {};
};

using ParameterValue =
    std::variant<double, bool, std::string, Vec3, Vec2, SpectrumPtr, IndexTablePtr, FresnelChoice>;

// Checked values by name. The getters throw std::logic_error when a type asks for a parameter that
// it did not list, or with the wrong type: a mistake in the program, not in the input.
class Parameters {
 public:
  void set(const std::string& name, ParameterValue value) { values_[name] = std::move(value); }
  bool has(const std::string& name) const { return values_.count(name) > 0; }

  double number(const std::string& name) const { return get<double>(name); }
  int integer(const std::string& name) const { return static_cast<int>(get<double>(name)); }
  bool boolean(const std::string& name) const { return get<bool>(name); }
  const std::string& string(const std::string& name) const { return get<std::string>(name); }
  Vec3 vector3(const std::string& name) const { return get<Vec3>(name); }
  Vec2 vector2(const std::string& name) const { return get<Vec2>(name); }
  SpectrumPtr spectrum(const std::string& name) const { return get<SpectrumPtr>(name); }
  IndexTablePtr index(const std::string& name) const { return get<IndexTablePtr>(name); }
  const FresnelChoice& fresnel(const std::string& name) const { return get<FresnelChoice>(name); }

 private:
  template <typename T>
  const T& get(const std::string& name) const {
    const auto it = values_.find(name);
    if (it == values_.end()) throw std::logic_error("parameter not set: " + name);
    return std::get<T>(it->second);
  }

  std::map<std::string, ParameterValue> values_;
};

}  // namespace karat
