#include "apps/karat/fresnel/study_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "materials/fresnel.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

// More than this many steps are a mistake.
constexpr double kMostSteps = 512;

}  // namespace

std::vector<double> parse_steps(const std::string& option, const std::string& text, double min,
                                double max) {
  const auto fail = [&](const std::string& why) {
    throw InputError(
        fmt::format("{}: found \"{}\": {}; allowed: FIRST:LAST:STEP, both ends "
                    "from {:g} to {:g}, such as {}",
                    option, text, why, min, max, max <= 90.0 ? "0:89:1" : "380:780:5"));
  };
  double numbers[3];
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int i = 0; i < 3; ++i) {
    const auto [rest, error] = std::from_chars(at, end, numbers[i]);
    const bool ends = i == 2 ? rest == end : rest != end && *rest == ':';
    if (error != std::errc() || !ends) fail("not three numbers with colons between them");
    at = rest + 1;
  }
  const auto [first, last, step] = numbers;
  if (first > last) fail("the first is above the last");
  if (!(first >= min && last <= max)) {
    fail(fmt::format("{:g} is outside", first >= min ? last : first));
  }
  if (!(step > 0.0) || (last - first) / step >= kMostSteps) {
    fail(fmt::format("the step must be above 0 and give at most {} values", kMostSteps));
  }
  const double count = std::round((last - first) / step);
  if (std::abs(first + count * step - last) > 1e-6 * step) {
    fail("steps from the first do not meet the last");
  }
  std::vector<double> values;
  for (int i = 0; i <= static_cast<int>(count); ++i) values.push_back(first + i * step);
  return values;
}

std::pair<int, int> parse_size(const std::string& text) {
  int width = 0, height = 0;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, width);
  const bool separated = first.ec == std::errc() && first.ptr != end && *first.ptr == 'x';
  const auto second = separated ? std::from_chars(first.ptr + 1, end, height) : first;
  const auto allowed = [](int pixels) { return pixels >= 16 && pixels <= 4096; };
  if (!separated || second.ec != std::errc() || second.ptr != end || !allowed(width) ||
      !allowed(height)) {
    throw InputError("--render-size: found \"" + text +
                     "\", needs WIDTHxHEIGHT, both from 16 to 4096, such as 432x243");
  }
  return {width, height};
}

std::vector<std::string> usual_study_tables() {
  return {"main/Au/Johnson", "main/Ag/Johnson",  "main/Cu/Johnson", "main/Al/Rakic",
          "main/Fe/Johnson", "main/Pt/Rakic-BB", "main/Ti/Johnson", "main/Ni/Johnson",
          "main/Cr/Johnson", "main/W/Rakic-BB",  "main/Pd/Johnson", "main/Co/Johnson"};
}

std::vector<std::string> usual_study_models() {
  std::vector<std::string> names = Registry<FresnelModel>::instance().names();
  std::stable_partition(names.begin(), names.end(),
                        [](const auto& name) { return name == "exact"; });
  return names;
}

}  // namespace karat
