// Errors that a user can cause. They are thrown while loading and caught once, in apps/karat.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace karat {

// The input (scene, table, mesh, image) is invalid: exit code 3. The message names the file, the
// place inside it, what was found and what is allowed.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
  // "FILE: PLACE: MESSAGE"; empty parts are left out.
  InputError(const std::string& file, const std::string& place, const std::string& message);
};

// The run failed for a reason that is not in the input (disk full, unwritable output): exit code 1.
class RuntimeError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The name in `known` that `name` begins or is a word of ("fov" in "fov_deg"), else the one with
// the smallest edit distance, else "" when more than a quarter differs. Letter case counts half.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

// `unknown WHAT "NAME"; did you mean "NEAR"? Known: a, b, c.` (at most 20 names are listed).
std::string unknown_name_message(const std::string& what, const std::string& name,
                                 const std::vector<std::string>& known);

}  // namespace karat
