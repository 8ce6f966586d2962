#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
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

// For options: a whole number from `min` to `max`.
inline CLI::Validator integer_check(std::int64_t min, std::int64_t max) {
  const std::string allowed = fmt::format("{} to {}", min, max);
  return {[=](const std::string& text) -> std::string {
            std::int64_t number = 0;
            const auto [end, error] =
                std::from_chars(text.data(), text.data() + text.size(), number);
            if (error == std::errc() && end == text.data() + text.size() && number >= min &&
                number <= max) {
              return "";
            }
            return fmt::format("found \"{}\", allowed: a whole number from {}", text, allowed);
          },
          allowed};
}

}  // namespace karat
