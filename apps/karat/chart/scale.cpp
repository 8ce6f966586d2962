#include "apps/karat/chart/scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace karat {
namespace {

constexpr const char* kMinus = "\u2212";

std::string with_minus(std::string text) {
  if (!text.empty() && text.front() == '-') text.replace(0, 1, kMinus);
  return text;
}

// Whether an axis is named in decimals throughout, or with powers of ten throughout.
bool in_decimals(double low, double high) { return low >= -3.0 - 1e-9 && high < 5.0; }

// 10 to an integer power, as text.
std::string power_text(int exponent, bool decimals) {
  if (decimals) return fmt::format("{:g}", std::pow(10.0, exponent));
  static const char* const kRaised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : fmt::format("{}", std::abs(exponent))) text += kRaised[digit - '0'];
  return text;
}

// The smallest round step, 1, 2, 2.5 or 5 times a power of ten, that is at least `step`.
double round_step(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 2.5, 5.0}) {
    if (step <= factor * power * (1.0 + 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

std::vector<Tick> linear_ticks(const Scale& scale, double spacing) {
  const double pixels = std::abs(scale.to_pixel - scale.from_pixel);
  const double step = round_step((scale.max - scale.min) * std::min(1.0, spacing / pixels));
  std::vector<Tick> ticks;
  const double first = std::ceil(scale.min / step - 1e-9);
  for (int i = 0; i < 1000; ++i) {
    const double value = (first + i) * step;
    if (value > scale.max + 1e-9 * step) break;
    ticks.push_back({value, tick_text(value, step)});
  }
  return ticks;
}

// Decades, of which some are skipped where they stand close; 2 and 5 named where there is room.
std::vector<Tick> log_ticks(const Scale& scale, double spacing) {
  const double low = std::log10(scale.min), high = std::log10(scale.max);
  const double decade = std::abs(scale.to_pixel - scale.from_pixel) / (high - low);
  if (high - low < 0.7) return linear_ticks(scale, spacing);
  const int skip = std::max(1, static_cast<int>(std::ceil(spacing / decade)));
  const bool decimals = in_decimals(low, high);
  const bool between = decade > 3.4 * spacing;
  std::vector<Tick> ticks;
  for (int e = static_cast<int>(std::floor(low)); e <= static_cast<int>(std::floor(high)); ++e) {
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = digit * std::pow(10.0, e);
      if (value < scale.min * (1 - 1e-9) || value > scale.max * (1 + 1e-9)) continue;
      std::string text;
      if (digit == 1 && e % skip == 0) text = power_text(e, decimals);
      if (between && (digit == 2 || digit == 5)) {
        text = decimals ? fmt::format("{:g}", value)
                        : fmt::format("{}·{}", digit, power_text(e, false));
      }
      if (digit == 1 || decade > 40.0 || !text.empty()) ticks.push_back({value, text});
    }
  }
  return ticks;
}

}  // namespace

double Scale::pixel(double value) const {
  if (!std::isfinite(value) || (log && value <= 0.0)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double share =
      log ? std::log(value / min) / std::log(max / min) : (value - min) / (max - min);
  return from_pixel + share * (to_pixel - from_pixel);
}

std::vector<Tick> axis_ticks(const Scale& scale, double spacing) {
  return scale.log ? log_ticks(scale, spacing) : linear_ticks(scale, spacing);
}

std::string tick_text(double value, double step) {
  if (std::abs(value) < 1e-9 * step) return "0";
  const double largest = std::max(std::abs(value), step);
  if (largest >= 1e7 || step < 1e-5) return with_minus(fmt::format("{:.4g}", value));
  // As many decimals as the step has: 0.25 has two.
  int decimals = 0;
  for (double shown = step; decimals < 6 && std::abs(shown - std::round(shown)) > 1e-6 * shown;
       shown *= 10.0) {
    ++decimals;
  }
  return with_minus(fmt::format("{:.{}f}", value, decimals));
}

}  // namespace karat
