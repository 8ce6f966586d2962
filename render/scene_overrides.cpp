#include "render/scene_overrides.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <sstream>

#include "spectral/support/error.h"

namespace karat {
namespace {

std::string option(const std::string& path) { return "-D " + path; }

std::vector<std::string> tokens_of(const std::string& path) {
  std::vector<std::string> tokens;
  if (path.empty() || path.front() != '/') {
    std::istringstream parts(path + ".");
    for (std::string part; std::getline(parts, part, '.');) tokens.push_back(part);
    return tokens;
  }
  try {
    for (Json::json_pointer pointer(path); !pointer.empty(); pointer.pop_back()) {
      tokens.insert(tokens.begin(), pointer.back());
    }
  } catch (const Json::exception&) {
    throw InputError("", option(path), "not a JSON pointer: \"~\" is written \"~0\", \"/\" \"~1\"");
  }
  return tokens;
}

// All schemas that may describe a value: the alternatives of anyOf, oneOf and allOf, references
// followed.
void add_alternatives(const Json& root, const Json& schema, std::vector<const Json*>& found) {
  if (!schema.is_object()) return;
  if (schema.contains("$ref")) {
    const auto reference = schema["$ref"].get<std::string>();
    add_alternatives(root, root.at(Json::json_pointer(reference.substr(1))), found);
    return;
  }
  found.push_back(&schema);
  for (const char* key : {"anyOf", "oneOf", "allOf"}) {
    if (!schema.contains(key)) continue;
    for (const auto& alternative : schema[key]) add_alternatives(root, alternative, found);
  }
}

bool has_names(const std::vector<const Json*>& schemas) {
  for (const Json* schema : schemas) {
    if (schema->contains("additionalProperties") && (*schema)["additionalProperties"].is_object()) {
      return true;
    }
  }
  return false;
}

// The schemas of the member or element `token`; `known` receives the property names that exist.
std::vector<const Json*> step(const Json& root, const std::vector<const Json*>& schemas,
                              const std::string& token, std::set<std::string>& known) {
  std::vector<const Json*> next;
  for (const Json* schema : schemas) {
    if (schema->contains("properties")) {
      for (const auto& [name, property] : (*schema)["properties"].items()) {
        known.insert(name);
        if (name == token) add_alternatives(root, property, next);
      }
    }
    for (const char* key : {"additionalProperties", "items"}) {
      if (schema->contains(key)) add_alternatives(root, (*schema)[key], next);
    }
  }
  return next;
}

// Those of `schemas` that may hold for a value of that "type"; all where it has none that is known.
std::vector<const Json*> of_type(const std::vector<const Json*>& schemas, const Json& value) {
  if (!value.is_object() || !value.contains("type")) return schemas;
  std::vector<const Json*> found;
  for (const Json* schema : schemas) {
    const Json* properties = schema->contains("properties") ? &(*schema)["properties"] : nullptr;
    if (properties && properties->contains("type") && (*properties)["type"].contains("const") &&
        (*properties)["type"]["const"] == value["type"]) {
      found.push_back(schema);
    }
  }
  return found.empty() ? schemas : found;
}

bool is_required(const std::vector<const Json*>& schemas, const std::string& key) {
  bool known = false;
  for (const Json* schema : schemas) {
    if (!schema->contains("properties") || !(*schema)["properties"].contains(key)) continue;
    known = true;
    const Json required = schema->value("required", Json::array());
    if (std::find(required.begin(), required.end(), key) == required.end()) return false;
  }
  return known;
}

bool is_list(const std::vector<const Json*>& schemas) {
  return std::any_of(schemas.begin(), schemas.end(),
                     [](const Json* schema) { return schema->contains("items"); });
}

// One -D on its way through the document.
class Override {
 public:
  Override(const Json& schema, std::string path, bool types_change)
      : schema_(schema), path_(std::move(path)), types_change_(types_change) {}

  ChangedPlace apply(Json& document, const std::string& text) const {
    std::vector<const Json*> schemas;
    add_alternatives(schema_, schema_, schemas);
    const auto tokens = tokens_of(path_);
    const Json value = value_of(text);
    Json* target = &document;
    std::string place;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      const bool last = i + 1 == tokens.size();
      if (!types_change_) schemas = of_type(schemas, *target);
      const auto next = step_to(schemas, tokens[i]);
      if (target->is_null() && is_list(schemas)) *target = Json::array();
      if (last && value.is_null()) {
        remove(*target, schemas, tokens[i]);
        return {};
      }
      target = target->is_array() ? &element_of(*target, tokens[i], last)
                                  : &member_of(*target, tokens[i], last, has_names(schemas));
      schemas = next;
      place.append("/").append(pointer_token(tokens[i]));
    }
    *target = value;
    return {place, option(path_)};
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError("", option(path_), message);
  }

  // What is not JSON is text: -D white=D65 needs no quotes. What begins like JSON is meant so.
  Json value_of(const std::string& text) const {
    const bool meant = !text.empty() && (text[0] == '{' || text[0] == '[' || text[0] == '"');
    return meant || Json::accept(text) ? parse_json(text, option(path_)) : Json(text);
  }

  std::vector<const Json*> step_to(const std::vector<const Json*>& schemas,
                                   const std::string& token) const {
    std::set<std::string> known;
    auto next = step(schema_, schemas, token, known);
    if (!next.empty()) return next;
    if (known.empty()) fail("found \"" + token + "\" after a value that has no parts");
    fail(unknown_name_message("key", token, {known.begin(), known.end()}));
  }

  void remove(Json& object, const std::vector<const Json*>& schemas, const std::string& key) const {
    if (object.is_array()) fail("null removes a key, not an element of a list");
    if (is_required(schemas, key)) fail("\"" + key + "\" must be there and cannot be removed");
    if (object.is_object()) object.erase(key);
  }

  Json& element_of(Json& array, const std::string& token, bool last) const {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
    const bool number = error == std::errc() && end == token.data() + token.size();
    if (number && index < array.size()) return array[index];
    const std::string size = std::to_string(array.size());
    if (!number || index > array.size()) {
      fail("found \"" + token + "\", allowed: an index below " + size + " of the list, or " + size +
           " to append");
    }
    if (!last) fail("the list has no element " + size + " yet; append it whole, as {...}");
    array.push_back(nullptr);
    return array.back();
  }

  // The member that an override goes through: sections the document leaves out are created, named
  // things are not.
  Json& member_of(Json& object, const std::string& token, bool last, bool is_name) const {
    if (!object.is_object()) object = Json::object();
    if (is_name && !last && !object.contains(token)) {
      std::vector<std::string> names;
      for (const auto& [name, value] : object.items()) names.push_back(name);
      fail(unknown_name_message("name", token, names));
    }
    return object[token];
  }

  const Json& schema_;
  std::string path_;
  bool types_change_;  // keys of other types may come to be right
};

}  // namespace

std::vector<ChangedPlace> apply_overrides(
    Json& document, const Json& schema,
    const std::vector<std::pair<std::string, std::string>>& values) {
  const bool types_change = std::any_of(values.begin(), values.end(), [](const auto& value) {
    return value.first.ends_with("type");
  });
  std::vector<ChangedPlace> changes;
  for (const auto& [path, text] : values) {
    const ChangedPlace change = Override(schema, path, types_change).apply(document, text);
    if (!change.place.empty()) changes.push_back(change);
  }
  return changes;
}

}  // namespace karat
