#include "render/parameter_reader.h"

#include <cmath>

namespace karat {
namespace {

// Numbers become floats, which are squared: larger ones would overflow.
constexpr double kLargest = 1e18;

Allowed allowed_by(const ParameterInfo& info) {
  return {std::max(info.min, -kLargest), std::min(info.max, kLargest), info.exclusive_min};
}

Vec3 read_vector3(const JsonValue& value, const ParameterInfo& info) {
  const auto v = value.numbers(3, allowed_by(info));
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

Vec2 read_vector2(const JsonValue& value, const ParameterInfo& info) {
  const auto v = value.numbers(2, allowed_by(info));
  return {static_cast<float>(v[0]), static_cast<float>(v[1])};
}

// A name, or a name and the model's free parameters. Which ones a model has is not known here.
FresnelChoice read_fresnel(const JsonValue& value, const ParameterInfo& info,
                           const ReadContext& context) {
  if (!value.json().is_object()) return {value.choice("Fresnel model", info.choices), {}};
  value.allow_keys({"model", "parameters"});
  FresnelChoice choice{value.member("model").choice("Fresnel model", info.choices), {}};
  if (!value.has("parameters")) return choice;
  const JsonValue parameters = value.member("parameters");
  parameters.require_object();
  for (const std::string& name : parameters.keys()) {
    choice.parameters[name] = read_plain_spectrum(parameters.member(name), context);
  }
  return choice;
}

ParameterValue read_value(const JsonValue& value, const ParameterInfo& info,
                          const ReadContext& context) {
  switch (info.type) {
    case ParameterType::kNumber:
      return value.number(allowed_by(info));
    case ParameterType::kInteger:
      return static_cast<double>(value.integer(allowed_by(info)));
    case ParameterType::kBoolean:
      return value.boolean();
    case ParameterType::kString:
      return value.string();
    case ParameterType::kChoice:
      return value.choice(info.name, info.choices);
    case ParameterType::kPath:
      return read_path(value, context);
    case ParameterType::kVector3:
      return read_vector3(value, info);
    case ParameterType::kVector2:
      return read_vector2(value, info);
    case ParameterType::kReflectance:
      return read_reflectance(value, context);
    case ParameterType::kEmission:
      return read_emission(value, context);
    case ParameterType::kIndex:
      return read_index(value, context);
    case ParameterType::kFresnel:
      return read_fresnel(value, info, context);
  }
  throw std::logic_error("parameter of unknown type: " + info.name);
}

Json number_schema(const ParameterInfo& info, const char* type) {
  Json schema = {{"type", type}};
  if (std::isfinite(info.min))
    schema[info.exclusive_min ? "exclusiveMinimum" : "minimum"] = info.min;
  if (std::isfinite(info.max)) schema["maximum"] = info.max;
  return schema;
}

Json vector_schema(const ParameterInfo& info, int components) {
  return {{"type", "array"},
          {"items", number_schema(info, "number")},
          {"minItems", components},
          {"maxItems", components}};
}

Json fresnel_schema(const ParameterInfo& info) {
  const Json model = {{"enum", info.choices}};
  const Json parameters = {{"type", "object"},
                           {"additionalProperties", {{"$ref", "#/definitions/plain_spectrum"}}}};
  return {{"anyOf",
           {model,
            {{"type", "object"},
             {"properties", {{"model", model}, {"parameters", parameters}}},
             {"required", {"model"}},
             {"additionalProperties", false}}}}};
}

Json type_schema(const ParameterInfo& info) {
  switch (info.type) {
    case ParameterType::kNumber:
      return number_schema(info, "number");
    case ParameterType::kInteger:
      return number_schema(info, "integer");
    case ParameterType::kBoolean:
      return {{"type", "boolean"}};
    case ParameterType::kString:
    case ParameterType::kPath:
      return {{"type", "string"}};
    case ParameterType::kChoice:
      return {{"enum", info.choices}};
    case ParameterType::kVector3:
      return vector_schema(info, 3);
    case ParameterType::kVector2:
      return vector_schema(info, 2);
    case ParameterType::kReflectance:
      return {{"$ref", "#/definitions/reflectance"}};
    case ParameterType::kEmission:
      return {{"$ref", "#/definitions/emission"}};
    case ParameterType::kIndex:
      return {{"$ref", "#/definitions/index"}};
    case ParameterType::kFresnel:
      return fresnel_schema(info);
  }
  throw std::logic_error("parameter of unknown type: " + info.name);
}

}  // namespace

Parameters read_parameters(const JsonValue& object, const std::vector<ParameterInfo>& infos,
                           const std::vector<std::string>& other_keys, const ReadContext& context) {
  std::vector<std::string> known = other_keys;
  for (const auto& info : infos) known.push_back(info.name);
  object.allow_keys(known);

  Parameters parameters;
  for (const auto& info : infos) {
    if (object.has(info.name)) {
      parameters.set(info.name, read_value(object.member(info.name), info, context));
    } else if (info.required) {
      object.fail("\"" + info.name + "\" is missing: " + info.description);
    } else if (!info.default_json.empty()) {
      const Json given = Json::parse(info.default_json);
      const JsonValue value(given, object.file(),
                            object.place() + "/" + pointer_token(info.name) + " (default)");
      parameters.set(info.name, read_value(value, info, context));
    }
  }
  return parameters;
}

Json parameter_schema(const ParameterInfo& info) {
  Json schema = type_schema(info);
  // Draft 7 ignores what stands beside a "$ref".
  if (schema.contains("$ref")) schema = {{"allOf", Json::array({schema})}};
  schema["description"] = info.description;
  if (!info.default_json.empty()) schema["default"] = Json::parse(info.default_json);
  return schema;
}

}  // namespace karat
