// Options of `karat fresnel study` that name grids and lists.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace karat {

// "380:780:5": first, last and step; both ends are included. Throws InputError naming `option` when
// it is no such text, when the step does not lead from the first to the last, or when a number lies
// outside [min, max].
std::vector<double> parse_steps(const std::string& option, const std::string& text, double min,
                                double max);

// "432x243". Throws InputError.
std::pair<int, int> parse_size(const std::string& text);

// Twelve metals whose tables cover 380 to 780 nm.
std::vector<std::string> usual_study_tables();

// All registered models, "exact" first.
std::vector<std::string> usual_study_models();

}  // namespace karat
