#include "apps/karat/fresnel/named_values.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "spectral/support/error.h"

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
    const std::string name = text.substr(0, text.find('='));
    const auto [it, is_new] = values.emplace(name, value_of(text).value());
    if (!is_new) {
      throw InputError("", name,
                       fmt::format("is given twice: {:g}, then \"{}\"", it->second, text));
    }
  }
  return values;
}

}  // namespace karat
