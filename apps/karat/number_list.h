// Lists of numbers on the command line: "400,550:600:10".
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace karat {

// Adds an option that takes numbers and ranges FROM:TO:STEP, separated by commas: "400,550:600:10"
// is 400, 550, 560, ..., 600. Both ends of a range count, the upper one where the steps reach it.
// The numbers are appended to `numbers` in the order given; each must be from `min` to `max`, and a
// list has at most a million, otherwise the usage is wrong (exit code 2).
CLI::Option* add_number_list(CLI::App& command, const std::string& name,
                             std::vector<double>& numbers, const std::string& description,
                             double min, double max);

}  // namespace karat
