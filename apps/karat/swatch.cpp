#include "apps/karat/swatch.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace karat {
namespace {

bool shows_true_colour() {
  const char* colours = std::getenv("COLORTERM");
  const std::string name = colours ? colours : "";
  return isatty(STDOUT_FILENO) != 0 && (name == "truecolor" || name == "24bit") &&
         std::getenv("NO_COLOR") == nullptr;
}

}  // namespace

std::array<int, 3> display_bytes(const Rgb& linear) {
  std::array<int, 3> bytes{};
  for (std::size_t i = 0; i < 3; ++i) {
    bytes[i] = static_cast<int>(std::lround(255.0 * srgb_encode(std::clamp(linear[i], 0.0, 1.0))));
  }
  return bytes;
}

std::string display_hex(const Rgb& linear) {
  const auto [r, g, b] = display_bytes(linear);
  return fmt::format("#{:02x}{:02x}{:02x}", r, g, b);
}

std::string swatch(const Rgb& linear) {
  if (!shows_true_colour()) return "";
  const auto [r, g, b] = display_bytes(linear);
  return fmt::format("  \x1b[48;2;{};{};{}m        \x1b[0m", r, g, b);
}

}  // namespace karat
