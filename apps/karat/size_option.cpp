#include "apps/karat/size_option.h"

#include <fmt/format.h>

#include <charconv>

namespace karat {

std::vector<int> split_integers(const std::string& text, char separator, std::size_t count,
                                const std::string& option, const std::string& form) {
  std::vector<int> numbers;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  while (numbers.size() < count) {
    int number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc()) break;
    numbers.push_back(number);
    at = next;
    if (at == end || *at != separator || numbers.size() == count) break;
    ++at;
  }
  if (numbers.size() != count || at != end) {
    throw CLI::ValidationError(option, "found \"" + text + "\", allowed: " + form);
  }
  return numbers;
}

void add_size_option(CLI::App& command, const std::function<void(PictureSize)>& set, int min,
                     int max, const std::string& description) {
  const auto parse = [=](const std::string& text) {
    const auto size = split_integers(text, 'x', 2, "--size", "WIDTHxHEIGHT as 640x480");
    for (const int side : size) {
      if (side >= min && side <= max) continue;
      throw CLI::ValidationError("--size",
                                 fmt::format("found \"{}\", allowed: {} to {}", text, min, max));
    }
    set({size[0], size[1]});
  };
  command.add_option_function<std::string>("--size", parse, description)->type_name("WxH");
}

}  // namespace karat
