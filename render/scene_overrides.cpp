#include "render/scene_overrides.h"

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

std::size_t index_of(const std::string& path, const std::string& token, const Json& array) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
  if (error != std::errc() || end != token.data() + token.size() || index >= array.size()) {
    throw InputError("", option(path),
                     "found \"" + token + "\", allowed: an index below " +
                         std::to_string(array.size()) + " of the list");
  }
  return index;
}

// The member that an override goes through: sections the document leaves out are created, named
// things are not.
Json& member_of(Json& object, const std::string& path, const std::string& token, bool last,
                bool is_name) {
  if (!object.is_object()) object = Json::object();
  if (is_name && !last && !object.contains(token)) {
    std::vector<std::string> names;
    for (const auto& [name, value] : object.items()) names.push_back(name);
    throw InputError("", option(path), unknown_name_message("name", token, names));
  }
  return object[token];
}

void apply(Json& document, const Json& schema, const std::string& path, const std::string& text) {
  std::vector<const Json*> schemas;
  add_alternatives(schema, schema, schemas);
  const auto tokens = tokens_of(path);
  Json* target = &document;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    std::set<std::string> known;
    const bool is_name = has_names(schemas);
    schemas = step(schema, schemas, tokens[i], known);
    if (schemas.empty()) {
      throw InputError("", option(path),
                       unknown_name_message("key", tokens[i], {known.begin(), known.end()}));
    }
    target = target->is_array()
                 ? &(*target)[index_of(path, tokens[i], *target)]
                 : &member_of(*target, path, tokens[i], i + 1 == tokens.size(), is_name);
  }
  // What is not JSON is text: -D white=D65 needs no quotes.
  *target = Json::accept(text) ? parse_json(text, option(path)) : Json(text);
}

}  // namespace

void apply_overrides(Json& document, const Json& schema,
                     const std::vector<std::pair<std::string, std::string>>& values) {
  for (const auto& [path, text] : values) apply(document, schema, path, text);
}

}  // namespace karat
