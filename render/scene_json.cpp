#include "render/scene_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "render/json_error.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

// Follows the parser's events, so that a repeated key and deep nesting are found, with their place,
// before memory is taken for what is inside.
class NestingCheck {
 public:
  explicit NestingCheck(std::string name) : name_(std::move(name)) {}

  bool operator()(Json::parse_event_t event, const Json& parsed) {
    switch (event) {
      case Json::parse_event_t::object_start:
      case Json::parse_event_t::array_start:
        if (open_.size() >= static_cast<std::size_t>(kMaxNesting)) {
          throw InputError(name_, place(),
                           fmt::format("nested deeper than {} levels", kMaxNesting));
        }
        open_.emplace_back();
        open_.back().is_array = event == Json::parse_event_t::array_start;
        break;
      case Json::parse_event_t::key: {
        const auto key = parsed.get<std::string>();
        if (!open_.back().keys.insert(key).second) {
          throw InputError(name_, place(), "the key \"" + key + "\" is given twice");
        }
        open_.back().key = key;
        break;
      }
      case Json::parse_event_t::object_end:
      case Json::parse_event_t::array_end:
        open_.pop_back();
        [[fallthrough]];
      case Json::parse_event_t::value:
        if (!open_.empty()) ++open_.back().index;
    }
    return true;
  }

  // The bracket that waits for its end, or 0.
  char open() const { return open_.empty() ? '\0' : open_.back().is_array ? '[' : '{'; }

 private:
  struct Level {
    bool is_array = false;
    std::size_t index = 0;
    std::string key;
    std::set<std::string> keys;
  };

  std::string place() const {
    std::string pointer;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
      const Level& level = open_[i];
      pointer += "/" + (level.is_array ? std::to_string(level.index) : pointer_token(level.key));
    }
    return pointer;
  }

  std::string name_;
  std::vector<Level> open_;
};

// Other than syntax errors, only numbers beyond the range of double: "[json.exception.out_of_range
// .406] number overflow parsing '1e999'".
std::string range_message(const std::string& what) {
  const auto end = what.find("] ");
  return end == std::string::npos ? what : what.substr(end + 2);
}

void require_text(const std::string& text, const std::string& name) {
  const std::string format = foreign_format(text);
  if (format.empty()) return;
  throw InputError(name, "",
                   format == "UTF-16 text" ? "the file is UTF-16; save it as UTF-8"
                                           : format + ", not a JSON file");
}

// What is there already is not what was meant.
std::string unknown_key_message(const Json& object, const std::string& key,
                                const std::vector<std::string>& known) {
  const std::string near = nearest_name(key, known);
  if (near.empty() || !object.contains(near)) return unknown_name_message("key", key, known);
  return fmt::format("unknown key \"{}\"; \"{}\" is there already. Known: {}.", key, near,
                     fmt::join(known, ", "));
}

std::string short_number(double value) { return fmt::format("{:.10g}", value); }

}  // namespace

std::string read_text_file(const std::string& path, std::size_t max_bytes) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError(path, "", "no such file");
  if (std::filesystem::is_directory(status)) throw InputError(path, "", "is a folder, not a file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path, "", "cannot be opened for reading");
  std::string text;
  char block[65536];
  while (stream.read(block, sizeof block) || stream.gcount() > 0) {
    text.append(block, static_cast<std::size_t>(stream.gcount()));
    if (text.size() > max_bytes) {
      throw InputError(path, "", fmt::format("larger than the {} MiB allowed", max_bytes >> 20));
    }
  }
  if (stream.bad()) throw InputError(path, "", "cannot be read");
  return text;
}

Json parse_json(const std::string& text, const std::string& name) {
  if (text.size() > kMaxSceneBytes) {
    throw InputError(name, "", fmt::format("larger than the {} MiB allowed", kMaxSceneBytes >> 20));
  }
  require_text(text, name);
  NestingCheck check(name);
  try {
    return Json::parse(
        text, [&](int, Json::parse_event_t event, Json& parsed) { return check(event, parsed); });
  } catch (const Json::parse_error& error) {
    const auto [place, message] = json_error(text, {error.byte, error.what(), check.open()});
    throw InputError(name, place, message);
  } catch (const Json::exception& error) {
    throw InputError(name, "", range_message(error.what()));
  }
}

std::string Allowed::text() const {
  const bool below = std::isfinite(max), above = std::isfinite(min);
  const std::string low = (exclusive_min ? "above " : "") + short_number(min);
  if (above && below) return low + (exclusive_min ? ", at most " : " to ") + short_number(max);
  if (above) return exclusive_min ? low : "at least " + low;
  return below ? "at most " + short_number(max) : "any finite number";
}

// The last change that made the value, or a part around it, is to blame; one inside it may be.
void JsonValue::fail(const std::string& message) const {
  std::string inside;
  for (std::size_t i = changes_ ? changes_->size() : 0; i-- > 0;) {
    const auto& [place, origin] = (*changes_)[i];
    if (place_ == place) throw InputError(origin, "", message);
    if (place_.starts_with(place + "/")) throw InputError(origin, place_, message);
    if (!place_.empty() && place.starts_with(place_ + "/")) inside = " (after " + origin + ")";
  }
  throw InputError(file_, place_, message + inside);
}

void JsonValue::fail_found(const std::string& allowed) const {
  fail("found " + shown(*json_) + ", allowed: " + allowed);
}

double JsonValue::number(const Allowed& allowed) const {
  if (!json_->is_number()) {
    fail_found(allowed.text() == "any finite number" ? "a number" : "a number, " + allowed.text());
  }
  const double value = json_->get<double>();
  if (!std::isfinite(value) || !allowed.contains(value)) fail_found(allowed.text());
  return value;
}

int JsonValue::integer(const Allowed& allowed) const {
  const Allowed within{std::max(allowed.min, -2147483648.0), std::min(allowed.max, 2147483647.0),
                       allowed.exclusive_min};
  if (!json_->is_number_integer()) fail_found("a whole number, " + within.text());
  return static_cast<int>(number(within));
}

bool JsonValue::boolean() const {
  if (!json_->is_boolean()) fail_found("true or false");
  return json_->get<bool>();
}

const std::string& JsonValue::string() const {
  if (!json_->is_string()) fail_found("text in quotes");
  return json_->get_ref<const std::string&>();
}

const std::string& JsonValue::choice(const std::string& what,
                                     const std::vector<std::string>& choices) const {
  if (!json_->is_string()) {
    std::string list;
    for (const auto& name : choices) list += (list.empty() ? "\"" : ", \"") + name + "\"";
    fail_found(list);
  }
  if (std::find(choices.begin(), choices.end(), string()) == choices.end()) {
    fail(unknown_name_message(what, string(), choices));
  }
  return string();
}

std::vector<double> JsonValue::numbers(std::size_t count, const Allowed& allowed) const {
  if (!json_->is_array() || json_->size() != count) {
    fail_found(fmt::format("a list of {} numbers", count));
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(element(i).number(allowed));
  return values;
}

const JsonValue& JsonValue::require_object() const {
  if (!json_->is_object()) fail_found("an object {...}");
  return *this;
}

const JsonValue& JsonValue::require_array() const {
  if (!json_->is_array()) fail_found("a list [...]");
  return *this;
}

JsonValue JsonValue::member(const std::string& key) const {
  require_object();
  const auto it = json_->find(key);
  if (it == json_->end()) fail("\"" + key + "\" is missing");
  return part(*it, pointer_token(key));
}

JsonValue JsonValue::element(std::size_t index) const {
  return part((*json_)[index], std::to_string(index));
}

JsonValue JsonValue::part(const Json& json, const std::string& token) const {
  return {json, file_, place_ + "/" + token, changes_};
}

std::vector<std::string> JsonValue::keys() const {
  std::vector<std::string> keys;
  for (auto it = json_->begin(); it != json_->end(); ++it) keys.push_back(it.key());
  return keys;
}

void JsonValue::allow_keys(const std::vector<std::string>& known) const {
  for (const auto& key : require_object().keys()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      member(key).fail(unknown_key_message(*json_, key, known));
    }
  }
}

std::string shown(const Json& json) {
  constexpr std::size_t kLongest = 60;
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() <= kLongest) return text;
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

std::string pointer_token(const std::string& key) {
  std::string token;
  for (const char c : key) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return token;
}

}  // namespace karat
