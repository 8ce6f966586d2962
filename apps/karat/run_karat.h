// The program karat as a function, so that tests can call it.
#pragma once

namespace karat {

// Exit codes.
inline constexpr int kDone = 0, kFailed = 1, kWrongUsage = 2, kInvalidInput = 3, kInterrupted = 130;

// Runs one command line and returns its exit code. Errors are printed on stderr, never thrown.
int run_karat(int argc, const char* const* argv);

// Seconds since the program was started.
double seconds_since_start();

}  // namespace karat
