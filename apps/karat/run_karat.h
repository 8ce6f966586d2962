// The program karat as a function, so that tests can call it.
#pragma once

#include <stdexcept>
#include <string>

namespace karat {

// What was asked for cannot be meant, or would destroy a file: exit code 2. Thrown by commands for
// what is known only after their options are read.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Exit codes.
inline constexpr int kDone = 0, kFailed = 1, kWrongUsage = 2, kInvalidInput = 3, kInterrupted = 130;

// Runs one command line and returns its exit code. Errors are printed on stderr, never thrown.
int run_karat(int argc, const char* const* argv);

// For the terminal: control bytes other than line breaks become \x1b and the like, so that no
// message of an input file can move the cursor.
std::string printable(const std::string& text);

// Seconds since the program was started.
double seconds_since_start();

}  // namespace karat
