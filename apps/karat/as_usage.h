// Options whose meaning is checked after they are read.
#pragma once

#include <CLI/CLI.hpp>

#include "spectral/support/error.h"

namespace karat {

// Calls `check`, from a command's callback: an InputError of it is wrong usage (exit code 2).
template <typename F>
void as_usage(F&& check) {
  try {
    check();
  } catch (const InputError& error) {
    throw CLI::ValidationError(error.what());
  }
}

}  // namespace karat
