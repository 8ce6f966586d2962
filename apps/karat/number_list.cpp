#include "apps/karat/number_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace karat {
namespace {

constexpr double kMostNumbers = 1e6;

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

// 550.1 rather than 550.1000000000000227: steps are meant in decimal.
double rounded(double value) {
  double result = value;
  const std::string text = fmt::format("{:.14g}", value);
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

// Appends what one item stands for; false where it is neither a number nor a range.
bool append(std::string_view item, std::vector<double>& numbers) {
  if (const auto single = number(item)) {
    numbers.push_back(*single);
    return true;
  }
  const std::size_t first = item.find(':'), last = item.rfind(':');
  if (first == last) return false;
  const auto from = number(item.substr(0, first)), step = number(item.substr(last + 1));
  const auto to = number(item.substr(first + 1, last - first - 1));
  if (!from || !to || !step || *step <= 0.0 || *to < *from) return false;
  const double steps = std::floor((*to - *from) / *step + 1e-9);
  if (!(steps + static_cast<double>(numbers.size()) < kMostNumbers)) return false;
  for (double i = 0.0; i <= steps; ++i) numbers.push_back(rounded(*from + i * *step));
  return true;
}

}  // namespace

CLI::Option* add_number_list(CLI::App& command, const std::string& name,
                             std::vector<double>& numbers, const std::string& description,
                             double min, double max) {
  const auto parse = [&numbers, name, min, max](const std::vector<std::string>& items) {
    for (const std::string& item : items) {
      const std::size_t before = numbers.size();
      const bool understood = append(item, numbers);
      if (understood && std::all_of(numbers.begin() + static_cast<std::ptrdiff_t>(before),
                                    numbers.end(), [&](double x) { return x >= min && x <= max; }))
        continue;
      throw CLI::ValidationError(
          name, fmt::format("found \"{}\", allowed: numbers from {:g} to {:g}, and ranges "
                            "FROM:TO:STEP such as 400:700:10, separated by commas",
                            item, min, max));
    }
  };
  return command.add_option_function<std::vector<std::string>>(name, parse, description)
      ->delimiter(',')
      ->allow_extra_args(false)  // so that a name may follow
      ->type_name("NUMBERS");
}

}  // namespace karat
