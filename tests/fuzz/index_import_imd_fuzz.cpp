// karat nk add --format imd, on any bytes.
#include "tests/fuzz/index_import.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  return karat::fuzz_import("imd", bytes, size);
}
