// What a cost was measured on.
#include <fstream>

#include "materials/fresnel_study/fresnel_cost.h"

#ifndef KARAT_COMPILER_FLAGS
#define KARAT_COMPILER_FLAGS "unknown flags"
#endif

namespace karat {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t value = line.find_first_not_of(": \t", line.find(':'));
    if (value != std::string::npos) return line.substr(value);
  }
  return "unknown processor";
}

std::string compiler_flags() { return KARAT_COMPILER_FLAGS; }

std::string vector_instructions() {
#if defined(__AVX512F__)
  return "AVX-512";
#elif defined(__AVX2__)
  return "AVX2";
#elif defined(__SSE2__)
  return "SSE2";
#elif defined(__ARM_NEON)
  return "NEON";
#else
  return "none that is known here";
#endif
}

}  // namespace karat
