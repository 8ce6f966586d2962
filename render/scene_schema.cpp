#include "render/scene_schema.h"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "materials/index/index_interpolation.h"
#include "materials/material.h"
#include "render/camera.h"
#include "render/index_schema.h"
#include "render/integrator.h"
#include "render/light.h"
#include "render/parameter_reader.h"
#include "render/scene_loader.h"
#include "render/scene_settings.h"
#include "render/shape.h"
#include "render/transform_reader.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"

namespace karat {
namespace {

Json reference(const std::string& definition) { return {{"$ref", "#/definitions/" + definition}}; }

Json number(double min, double max) {
  return {{"type", "number"}, {"minimum", min}, {"maximum", max}};
}

Json integer(double min, double max) {
  return {{"type", "integer"},
          {"minimum", static_cast<std::int64_t>(min)},
          {"maximum", static_cast<std::int64_t>(max)}};
}

Json list(const Json& items) { return {{"type", "array"}, {"items", items}}; }

Json named(const Json& items) { return {{"type", "object"}, {"additionalProperties", items}}; }

Json described(const std::string& description, Json schema) {
  if (schema.contains("$ref")) schema = {{"allOf", Json::array({schema})}};
  schema["description"] = description;
  return schema;
}

Json object(const Json& properties, const std::vector<std::string>& required = {}) {
  Json schema = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!required.empty()) schema["required"] = required;
  return schema;
}

// One alternative for each registered type, told apart by "type".
template <typename Type>
Json types(const Json& other_properties = Json::object()) {
  Json alternatives = Json::array();
  for (const auto& name : Registry<Type>::instance().names()) {
    const Type* type = Registry<Type>::instance().find(name);
    Json properties = other_properties;
    properties["type"] = {{"const", name}};
    std::vector<std::string> required{"type"};
    for (const auto& info : type->parameters()) {
      properties[info.name] = parameter_schema(info);
      if (info.required) required.push_back(info.name);
    }
    Json alternative = object(properties, required);
    alternative["description"] = type->description();
    alternatives.push_back(alternative);
  }
  return {{"oneOf", alternatives}};
}

Json rgb_schema() {
  return {{"type", "array"},
          {"items", {{"type", "number"}, {"minimum", 0}}},
          {"minItems", 3},
          {"maxItems", 3}};
}

Json table_schema() {
  return described(
      "Rows [wavelength in nm, value], wavelengths increasing.",
      {{"type", "array"},
       {"minItems", 1},
       {"items",
        {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 2}}}});
}

Json file_schema() {
  return described("A text file with two columns, wavelength in nm and value.",
                   {{"type", "string"}});
}

Json any_of(const std::vector<Json>& alternatives) { return {{"anyOf", alternatives}}; }

Json reflectance_schema() {
  const Json scale = {{"type", "number"}, {"minimum", 0}};
  return described("A reflectance within 0 to 1 at every wavelength.",
                   any_of({number(0, 1), object({{"rgb", rgb_schema()}, {"scale", scale}}, {"rgb"}),
                           object({{"table", table_schema()}, {"scale", scale}}, {"table"}),
                           object({{"file", file_schema()}, {"scale", scale}}, {"file"})}));
}

Json emission_schema() {
  const Json factor = {{"type", "number"}, {"minimum", 0}};
  const Json illuminants = {{"enum", illuminant_names()}};
  const auto kind = [&](const std::string& name, const Json& value, bool of_lamp = false) {
    Json properties = {{name, value}, {"scale", factor}, {"luminance", factor}};
    if (of_lamp) properties["illuminant"] = illuminants;
    return object(properties, {name});
  };
  return described("Spectral radiance in W m^-2 sr^-1 nm^-1.",
                   any_of({{{"type", "number"}, {"minimum", 0}},
                           kind("rgb", rgb_schema(), true),
                           kind("illuminant", illuminants),
                           kind("blackbody", number(100, 1e6)),
                           kind("table", table_schema()),
                           kind("file", file_schema())}));
}

Json plain_spectrum_schema() {
  return described("A number, or one for every wavelength.",
                   any_of({{{"type", "number"}},
                           object({{"table", table_schema()}}, {"table"}),
                           object({{"file", file_schema()}}, {"file"})}));
}

Json index_schema() {
  const Json part = any_of({{{"type", "number"}, {"minimum", 0}},
                            object({{"table", table_schema()}}, {"table"}),
                            object({{"file", file_schema()}}, {"file"})});
  std::vector<Json> forms{{{"type", "string"}},
                          {{"type", "number"}, {"exclusiveMinimum", 0}},
                          object({{"eta", part}, {"k", part}}, {"eta"})};
  for (Json& form : composed_index_schemas()) forms.push_back(std::move(form));
  return described(
      "A complex index of refraction: the name of a table as main/Au/Johnson or its file, a number "
      "n, eta and k, or an index made from others.",
      any_of(forms));
}

Json shape_schema(bool emits) {
  Json common = {{"material", {{"type", "string"}, {"description", "A name from \"materials\"."}}},
                 {"transform", reference("transform")}};
  if (emits) {
    common["emission"] = reference("emission");
    common["two_sided"] = {{"type", "boolean"},
                           {"description", "Emit from both sides, not only the outward one."}};
  }
  return types<ShapeType>(common);
}

Json definitions() {
  return {{"reflectance", reflectance_schema()},
          {"emission", emission_schema()},
          {"plain_spectrum", plain_spectrum_schema()},
          {"index", index_schema()},
          {"transform", transform_schema()},
          {"material", types<MaterialType>()},
          {"camera", types<CameraType>()},
          {"shape", shape_schema(true)},
          {"group_shape", shape_schema(false)},
          {"light", types<LightType>({{"transform", reference("transform")}})}};
}

// A setting of the scene as a whole, with what it is unless given.
Json setting(const std::string& description, Json schema, const Json& unless_given = nullptr) {
  schema["description"] = description;
  if (!unless_given.is_null()) schema["default"] = unless_given;
  return schema;
}

Json film_schema(const RenderSettings& defaults) {
  const Json crop = {
      {"type", "array"}, {"items", integer(0, kMaxFilmSide)}, {"minItems", 4}, {"maxItems", 4}};
  return described(
      "The image.",
      object({{"width",
               setting("Width of the image, in pixels.", integer(1, kMaxFilmSide), defaults.width)},
              {"height", setting("Height of the image, in pixels.", integer(1, kMaxFilmSide),
                                 defaults.height)},
              {"crop", setting("[x0, y0, x1, y1]: render pixels x0 to x1 - 1, y0 to y1 - 1 only, "
                               "counted from the upper left; the whole image unless given.",
                               crop)}}));
}

Json sampling_schema(const RenderSettings& defaults) {
  return described(
      "How many light paths are followed, and by which random numbers.",
      object(
          {{"spp", setting("Samples per pixel: noise falls with their square root.",
                           integer(1, kMaxSpp), defaults.spp)},
           {"seed", setting("Another seed gives other noise; the same seed the same image.",
                            integer(0, 4294967295.0), defaults.seed)},
           {"sampler", setting("Scrambled Sobol points, or independent random numbers, which are "
                               "noisier.",
                               {{"enum", {"sobol", "independent"}}}, defaults.sampler)}}));
}

Json integrator_schema(const RenderSettings& defaults) {
  return described(
      "How light is followed.",
      object({{"type",
               setting("The path tracer, or the slow literal estimator that checks it.",
                       {{"enum", Registry<Integrator>::instance().names()}}, defaults.integrator)},
              {"max_depth", setting("Most scattering events along a path; 0 shows lamps only.",
                                    integer(0, kMaxPathDepth), defaults.max_depth)}}));
}

Json properties() {
  const RenderSettings defaults;
  return {
      {"$schema", {{"type", "string"}}},
      {"wavelengths",
       described("Range of the simulation in nm, 380 to 780 unless given.",
                 object({{"min", number(10, 100000)}, {"max", number(10, 100000)}}))},
      {"observer", {{"enum", observer_names()}}},
      {"white", described("What is white in the image: an illuminant, a blackbody's temperature in "
                          "kelvin, or none.",
                          any_of({{{"type", "string"}}, number(500, 100000)}))},
      {"extrapolate", described("What happens where a table does not cover the wavelengths.",
                                {{"enum", {"error", "clamp"}}})},
      {"interpolation", described("How index tables are read between their samples: linear in "
                                  "wavelength on n and k (default), or a monotone cubic.",
                                  {{"enum", interpolation_names()}})},
      {"camera", reference("camera")},
      {"film", film_schema(defaults)},
      {"sampling", sampling_schema(defaults)},
      {"integrator", integrator_schema(defaults)},
      {"materials", named(reference("material"))},
      {"shapes", list(reference("shape"))},
      {"groups", named(list(reference("group_shape")))},
      {"instances",
       list(object({{"group", {{"type", "string"}}}, {"transform", reference("transform")}},
                   {"group"}))},
      {"lights", list(reference("light"))}};
}

}  // namespace

Json scene_schema_json() {
  Json root = object(properties(), {"camera"});
  root["$schema"] = "http://json-schema.org/draft-07/schema#";
  root["title"] = "Karat scene";
  root["description"] = "Lengths in scene units, angles in degrees, wavelengths in nm.";
  root["definitions"] = definitions();
  return root;
}

std::string scene_schema() { return scene_schema_json().dump(2) + "\n"; }

std::string schema_violation(const Json& document) {
  using valijson::adapters::NlohmannJsonAdapter;
  valijson::Schema schema;
  valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
  const Json known = scene_schema_json();
  parser.populateSchema(NlohmannJsonAdapter(known), schema);
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  valijson::ValidationResults results;
  if (validator.validate(schema, NlohmannJsonAdapter(document), &results)) return "";
  valijson::ValidationResults::Error error;
  if (!results.popError(error)) return "does not conform to the schema";
  std::string place;
  for (const auto& part : error.context) place += part;
  return place + ": " + error.description;
}

}  // namespace karat
