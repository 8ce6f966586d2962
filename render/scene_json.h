// JSON whose values know where they stand in their file, so that every error can say so.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace karat {

using Json = nlohmann::json;

inline constexpr std::size_t kMaxSceneBytes = std::size_t{64} << 20;
inline constexpr int kMaxNesting = 64;

// The whole text of a file of at most `max_bytes`. Throws InputError: no such file, a folder, too
// large, unreadable.
std::string read_text_file(const std::string& path, std::size_t max_bytes);

// Throws InputError with line, column and the likely mistake for malformed text, and with the JSON
// pointer for a key given twice or nesting deeper than kMaxNesting. `name` stands in messages.
Json parse_json(const std::string& text, const std::string& name);

// The interval that a number must lie in, and its text: "0 to 1", "above 0", "at least 1".
struct Allowed {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool exclusive_min = false;

  bool contains(double value) const {
    return value <= max && (exclusive_min ? value > min : value >= min);
  }
  std::string text() const;
};

// A part of the document that does not come from the file: its JSON pointer, and what an error
// names in the file's place ("-D film.width").
struct ChangedPlace {
  std::string place, origin;
};

// One value with its file and JSON pointer. The getters throw InputError "FILE: PLACE: found X,
// allowed: Y". A JsonValue refers to the document and to `changes`; it must not outlive them.
class JsonValue {
 public:
  JsonValue(const Json& json, std::string file, std::string place = "",
            const std::vector<ChangedPlace>* changes = nullptr)
      : json_(&json), file_(std::move(file)), place_(std::move(place)), changes_(changes) {}

  const Json& json() const { return *json_; }
  const std::string& file() const { return file_; }
  const std::string& place() const { return place_; }  // "" for the document itself
  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail_found(const std::string& allowed) const;  // "found X, allowed: ALLOWED"

  double number(const Allowed& allowed = {}) const;
  int integer(const Allowed& allowed = {}) const;
  bool boolean() const;
  const std::string& string() const;
  // A string that is one of `choices`; the error names the nearest. `what` as in "observer".
  const std::string& choice(const std::string& what, const std::vector<std::string>& choices) const;
  // An array of exactly `count` numbers.
  std::vector<double> numbers(std::size_t count, const Allowed& allowed = {}) const;

  const JsonValue& require_object() const;
  const JsonValue& require_array() const;
  std::size_t size() const { return json_->size(); }
  bool has(const std::string& key) const { return json_->is_object() && json_->contains(key); }
  JsonValue member(const std::string& key) const;  // fails when it is missing
  JsonValue element(std::size_t index) const;
  std::vector<std::string> keys() const;
  // Fails at any key that is not in `known`, with the nearest, which may be there already.
  void allow_keys(const std::vector<std::string>& known) const;

 private:
  JsonValue part(const Json& json, const std::string& token) const;

  const Json* json_;
  std::string file_, place_;
  const std::vector<ChangedPlace>* changes_;
};

// A value as an error shows it: its JSON, shortened.
std::string shown(const Json& json);

// One reference token of a JSON pointer (RFC 6901: "~" and "/" escaped).
std::string pointer_token(const std::string& key);

}  // namespace karat
