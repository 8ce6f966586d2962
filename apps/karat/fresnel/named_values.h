// Options of the form NAME=VALUE.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace karat {

// The check for such an option: a name, "=", and a finite number.
CLI::Validator named_value_check();

// Of checked options. Throws InputError for a name that is given twice.
std::map<std::string, double> named_values(const std::vector<std::string>& options);

}  // namespace karat
