#include "apps/karat/fresnel/named_values.h"

#include <cmath>
#include <optional>

namespace karat {
namespace {

std::optional<double> value_of(const std::string& text) {
  const auto equals = text.find('=');
  double value = 0.0;
  if (equals == std::string::npos || equals == 0) return std::nullopt;
  if (!CLI::detail::lexical_cast(text.substr(equals + 1), value)) return std::nullopt;
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

CLI::Validator named_value_check() {
  return {[](const std::string& text) {
            return value_of(text) ? std::string() : "found \"" + text + "\", allowed: NAME=NUMBER";
          },
          "NAME=NUMBER"};
}

std::map<std::string, double> named_values(const std::vector<std::string>& options) {
  std::map<std::string, double> values;
  for (const std::string& text : options) {
    values[text.substr(0, text.find('='))] = value_of(text).value();
  }
  return values;
}

}  // namespace karat
