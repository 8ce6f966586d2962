// The program's commands, run inside the test.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <string>
#include <vector>

#include "apps/karat/run_karat.h"

namespace karat::test {

// What goes to a file descriptor while it lives.
class Captured {
 public:
  explicit Captured(int descriptor)
      : descriptor_(descriptor), saved_(dup(descriptor)), file_(std::tmpfile()) {
    std::fflush(nullptr);
    dup2(fileno(file_), descriptor_);
  }
  ~Captured() {
    std::fflush(nullptr);
    dup2(saved_, descriptor_);
    close(saved_);
    std::fclose(file_);
  }
  Captured(const Captured&) = delete;
  Captured& operator=(const Captured&) = delete;

  std::string text() const {
    std::fflush(nullptr);
    std::string result(static_cast<std::size_t>(lseek(fileno(file_), 0, SEEK_END)), ' ');
    if (pread(fileno(file_), result.data(), result.size(), 0) < 0) return "";
    return result;
  }

 private:
  int descriptor_, saved_;
  std::FILE* file_;
};

struct Outcome {
  int code;
  std::string out, err;
};

// One command line without the leading "karat": its exit code and what it printed.
inline Outcome karat_run(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "karat");
  std::vector<const char*> argv;
  for (const auto& argument : arguments) argv.push_back(argument.c_str());
  const Captured out(STDOUT_FILENO), err(STDERR_FILENO);
  const int code = run_karat(static_cast<int>(argv.size()), argv.data());
  return {code, out.text(), err.text()};
}

}  // namespace karat::test
