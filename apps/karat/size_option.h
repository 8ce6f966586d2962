// Sizes of pictures on the command line: 640x480, the same in every command.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace karat {

struct PictureSize {
  int width = 0, height = 0;
};

// Whole numbers between separators, exactly `count`; anything else is wrong usage of `option` (exit
// code 2), told that `form` is allowed.
std::vector<int> split_integers(const std::string& text, char separator, std::size_t count,
                                const std::string& option, const std::string& form);

// Adds --size WIDTHxHEIGHT, each side from `min` to `max` pixels, which is given to `set`.
void add_size_option(CLI::App& command, const std::function<void(PictureSize)>& set, int min,
                     int max, const std::string& description);

}  // namespace karat
