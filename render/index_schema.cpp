#include "render/index_schema.h"

#include <limits>

#include "materials/film_stack.h"
#include "materials/mixing_rule.h"
#include "render/alloy_reader.h"
#include "spectral/spectrum_file.h"

namespace karat {
namespace {

Json any_index() { return {{"$ref", "#/definitions/index"}}; }

Json number(const std::string& description) {
  return {{"type", "number"}, {"description", description}};
}
Json number_from_0(const std::string& description) {
  Json schema = number(description);
  schema["minimum"] = 0;
  return schema;
}
Json number_above_0(const std::string& description) {
  Json schema = number(description);
  schema["exclusiveMinimum"] = 0;
  return schema;
}

Json object(const std::string& description, const Json& properties,
            const std::vector<std::string>& required) {
  return {{"type", "object"},
          {"description", description},
          {"properties", properties},
          {"additionalProperties", false},
          {"required", required}};
}

Json list(const Json& items) { return {{"type", "array"}, {"minItems", 1}, {"items", items}}; }

// {NAME: number or object, ...} or a list of objects with "nk".
Json members(const std::string& what, const std::string& key, const Json& number_schema,
             Json properties) {
  properties[key] = number_schema;
  const Json beside = {{"anyOf", {number_schema, object(what, properties, {key})}}};
  properties["nk"] = any_index();
  return {{"anyOf",
           {{{"type", "object"}, {"minProperties", 1}, {"additionalProperties", beside}},
            list(object(what, properties, {key, "nk"}))}}};
}

Json alloy_schema() {
  Json fraction = number_from_0("Part of the whole; all parts sum to 1.");
  fraction["maximum"] = 1;
  Json density = number("g/cm3; known for elements by the name of their table.");
  density["minimum"] = kLeastDensity;
  density["maximum"] = kMostDensity;
  const Json parts = members(
      "A part of an alloy.", "fraction", fraction,
      {{"density", density},
       {"molar_mass", number_above_0("g/mol; known for elements by the name of their table.")}});
  Json model = {{"enum", Registry<MixingRule>::instance().names()}, {"default", "bruggeman"}};
  model["description"] = "Effective-medium rule.";
  Json by = {{"enum", {"mass", "volume", "atom"}}, {"description", "What the fractions count."}};
  return object("An index mixed from others by an effective-medium rule.",
                {{"alloy", parts}, {"by", by}, {"model", model}, {"host", {{"type", "string"}}}},
                {"alloy", "by"});
}

Json preset_schema() {
  // Any text, for the user's own presets; Karat's for editors to complete.
  const Json name = {{"anyOf", {{{"enum", data_names("alloys")}}, {{"type", "string"}}}}};
  return object("An alloy of data/alloys or of the user's folder karat/alloys.", {{"alloy", name}},
                {"alloy"});
}

Json between_schema() {
  const Json value = number("Composition, temperature or whatever differs between the tables.");
  return object("Permittivity linear between the two tables whose values are next to \"at\".",
                {{"between", members("A table and its value.", "value", value, Json::object())},
                 {"at", number("Within the values of the tables.")}},
                {"between", "at"});
}

Json drude_schema() {
  const Json drude = object("Free electrons.",
                            {{"plasma_eV", number_above_0("Plasma energy, eV.")},
                             {"gamma_eV", number_from_0("Damping, eV.")},
                             {"eps_inf", number_above_0("Permittivity at high energy, 1.")}},
                            {"plasma_eV", "gamma_eV"});
  return object("eps_inf - plasma^2 / (w (w + i gamma)).", {{"drude", drude}}, {"drude"});
}

Json lorentz_schema() {
  const Json oscillator = object("A bound oscillator.",
                                 {{"f", number_from_0("Strength, of the squared plasma energy.")},
                                  {"gamma_eV", number_above_0("Damping, eV.")},
                                  {"omega_eV", number_above_0("Resonance, eV.")}},
                                 {"f", "gamma_eV", "omega_eV"});
  const Json lorentz = object("In the notation of Rakic et al. 1998.",
                              {{"plasma_eV", number_above_0("Plasma energy, eV.")},
                               {"eps_inf", number_above_0("Permittivity at high energy, 1.")},
                               {"f0", number_from_0("Strength of the free electrons, 0.")},
                               {"gamma0_eV", number_from_0("Their damping, eV.")},
                               {"oscillators", list(oscillator)}},
                              {"plasma_eV", "oscillators"});
  return object("Lorentz and Drude oscillators.", {{"lorentz", lorentz}}, {"lorentz"});
}

Json layers_schema() {
  Json thickness = number_from_0("nm; all layers together at most 20000.");
  thickness["maximum"] = kThickestFilmsNm;
  const Json layer = object("A layer.", {{"nk", any_index()}, {"thickness_nm", thickness}},
                            {"nk", "thickness_nm"});
  return object("Thin films on a substrate, the layer that light meets first standing first.",
                {{"substrate", any_index()}, {"layers", list(layer)}}, {"substrate", "layers"});
}

}  // namespace

std::vector<Json> composed_index_schemas() {
  return {alloy_schema(), preset_schema(),  between_schema(),
          drude_schema(), lorentz_schema(), layers_schema()};
}

}  // namespace karat
