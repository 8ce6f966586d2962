// What commands print with --json.
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace karat {

// Indented by two spaces; bytes that are not UTF-8 (some published references have them) are
// replaced.
template <typename Json>
void print_json(const Json& value) {
  fmt::print("{}\n", value.dump(2, ' ', false, Json::error_handler_t::replace));
}

}  // namespace karat
