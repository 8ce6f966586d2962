#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

namespace karat {

// For options: a number from `min` to `max`. CLI::Range would let NaN through.
inline CLI::Validator number_check(double min, double max) {
  const std::string allowed = fmt::format("{:g} to {:g}", min, max);
  return {[=](const std::string& text) -> std::string {
            double number = 0.0;
            if (CLI::detail::lexical_cast(text, number) && number >= min && number <= max) {
              return "";
            }
            return fmt::format("found \"{}\", allowed: a number from {}", text, allowed);
          },
          allowed};
}

}  // namespace karat
