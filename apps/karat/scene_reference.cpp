#include "apps/karat/scene_reference.h"

#include <fmt/format.h>

#include <cctype>
#include <stdexcept>
#include <vector>

#include "materials/fresnel.h"
#include "materials/material.h"
#include "materials/microfacet.h"
#include "render/camera.h"
#include "render/light.h"
#include "render/scene_schema.h"
#include "render/shape.h"

namespace karat {
namespace {

constexpr const char* kHead = R"(# Scene reference

Every key that a scene file takes, written by `karat schema --markdown` from the lists that the program itself reads
scenes by; a test compares. [scenes.md](scenes.md) lists the keys at the top of a scene, and the forms that spectra, indices
and transforms take.

In the tables *required* stands for a key that must be given, a dash for one that is absent unless given.

)";

std::string code(const std::string& text) { return "`" + text + "`"; }

std::string joined_code(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + code(name);
  return text;
}

// A cell must not end its column.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.insert(at, 1, '\\');
  }
  return text.empty() ? "-" : text;
}

std::string sentence(std::string text) {
  if (text.empty()) return text;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text.back() == '.' ? text : text + ".";
}

struct Row {
  std::string key, type, unit, range, default_value, meaning;
};

std::string table(const std::vector<Row>& rows) {
  std::string text =
      "| key | type | unit | range | default | meaning |\n"
      "| --- | --- | --- | --- | --- | --- |\n";
  for (const Row& r : rows) {
    text +=
        fmt::format("| {} | {} | {} | {} | {} | {} |\n", code(r.key), cell(r.type), cell(r.unit),
                    cell(r.range), cell(r.default_value), cell(sentence(r.meaning)));
  }
  return text + "\n";
}

// Descriptions say the unit as "Radius, in scene units; ...": it has a column of its own here.
void split_unit(Row& row) {
  for (const char* unit :
       {"scene units", "pixels", "degrees", "W m^-2 sr^-1 nm^-1", "W sr^-1 nm^-1"}) {
    const std::string clause = std::string(", in ") + unit;
    const std::size_t at = row.meaning.find(clause);
    if (at == std::string::npos) continue;
    row.meaning.erase(at, clause.size());
    row.unit = unit;
    return;
  }
}

std::string type_of(const ParameterInfo& info) {
  switch (info.type) {
    case ParameterType::kNumber:
      return "number";
    case ParameterType::kInteger:
      return "whole number";
    case ParameterType::kBoolean:
      return "boolean";
    case ParameterType::kString:
      return "text";
    case ParameterType::kChoice:
      return "name";
    case ParameterType::kPath:
      return "file";
    case ParameterType::kVector3:
      return "`[x, y, z]`";
    case ParameterType::kVector2:
      return "`[x, y]`";
    case ParameterType::kReflectance:
      return "[reflectance](scenes.md#spectra)";
    case ParameterType::kEmission:
      return "[emission](scenes.md#spectra)";
    case ParameterType::kIndex:
      return "[index](scenes.md#indices)";
    case ParameterType::kFresnel:
      return "[Fresnel model](scenes.md#indices)";
  }
  throw std::logic_error("parameter of unknown type: " + info.name);
}

std::string range_of(const ParameterInfo& info) {
  switch (info.type) {
    case ParameterType::kNumber:
    case ParameterType::kInteger:
      return Allowed{info.min, info.max, info.exclusive_min}.text();
    case ParameterType::kBoolean:
      return "`true`, `false`";
    case ParameterType::kChoice:
      return joined_code(info.choices);
    case ParameterType::kFresnel:
      return "[models](#fresnel-models)";
    case ParameterType::kReflectance:
      return "0 to 1";
    case ParameterType::kEmission:
      return "at least 0";
    default:
      return "";
  }
}

Row row_of(const ParameterInfo& info) {
  const std::string given = info.default_json.empty() ? "" : code(info.default_json);
  Row row{info.name,       type_of(info), "", range_of(info), info.required ? "*required*" : given,
          info.description};
  split_unit(row);
  return row;
}

template <typename Type>
std::string types(const std::string& title, const std::string& introduction) {
  std::string text = "## " + title + "\n\n" + introduction + "\n\n";
  for (const std::string& name : Registry<Type>::instance().names()) {
    const Type* type = Registry<Type>::instance().find(name);
    text += fmt::format("### `\"type\": \"{}\"`\n\n{}\n\n", name, sentence(type->description()));
    std::vector<Row> rows;
    for (const ParameterInfo& info : type->parameters()) rows.push_back(row_of(info));
    text += rows.empty() ? "No other keys.\n\n" : table(rows);
  }
  return text;
}

// What is chosen by its name alone.
template <typename Type>
std::string names(const std::string& title, const std::string& introduction) {
  std::string text =
      "## " + title + "\n\n" + introduction + "\n\n| name | meaning |\n| --- | --- |\n";
  for (const std::string& name : Registry<Type>::instance().names()) {
    const Type* type = Registry<Type>::instance().find(name);
    text += fmt::format("| {} | {} |\n", code(name), cell(sentence(type->description())));
  }
  return text + "\n";
}

// Keys that no registered type describes: the schema itself does.
std::string type_in_schema(const Json& schema) {
  if (schema.contains("enum")) return "name";
  const std::string type = schema.value("type", "");
  if (type == "integer") return "whole number";
  return type == "array" ? "list" : type;
}

std::string range_in_schema(const Json& schema) {
  if (schema.contains("enum")) return joined_code(schema["enum"]);
  if (!schema.contains("minimum")) return "";
  return Allowed{schema["minimum"].get<double>(), schema["maximum"].get<double>()}.text();
}

std::string section(const std::string& key) {
  const Json schema = scene_schema_json()["properties"][key];
  std::vector<Row> rows;
  for (const auto& [name, member] : schema["properties"].items()) {
    Row row{name,
            type_in_schema(member),
            "",
            range_in_schema(member),
            member.contains("default") ? code(member["default"].dump()) : "",
            member.value("description", "")};
    split_unit(row);
    rows.push_back(std::move(row));
  }
  return fmt::format("## `{}`\n\n{}\n\n", key, schema.value("description", "")) + table(rows);
}

}  // namespace

std::string scene_reference() {
  std::string text = kHead;
  text += section("film") + section("sampling") + section("integrator");
  text += types<CameraType>("Cameras", "One, under `camera`.");
  text += types<ShapeType>("Shapes",
                           "A list under `shapes`. Every shape also takes `material` (a name from "
                           "`materials`), `transform`\n"
                           "([operations](scenes.md#transforms)), `emission` "
                           "([emission](scenes.md#spectra): the shape is a lamp) and "
                           "`two_sided`\n(boolean, `false`: a lamp shines on its outward side "
                           "only). Shapes in `groups` take the first two.");
  text += types<MaterialType>("Materials", "Under `materials`, each with a name of its own.");
  text += types<LightType>("Lights",
                           "A list under `lights`. Every light also takes `transform`; shapes with "
                           "`emission` are lamps too.");
  text += names<FresnelModel>("Fresnel models",
                              "For a conductor's `fresnel`. Formulas and papers: "
                              "[fresnel_models.md](fresnel_models.md).");
  text += names<MicrofacetDistribution>("Distributions of microfacets",
                                        "For `distribution`; what alpha is, and which way it runs: "
                                        "[brushed_metal.md](brushed_metal.md).");
  text.pop_back();
  return text;
}

}  // namespace karat
