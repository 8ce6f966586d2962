// Any bytes are a spectrum or an InputError: no crash, no hang, no value that is not finite or not
// allowed.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "render/spectrum_columns.h"
#include "spectral/support/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace karat;
  const Allowed reflectance{0.0, 1.0, false};
  SpectrumPtr spectrum;
  try {
    spectrum = spectrum_of_text(std::string(reinterpret_cast<const char*>(bytes), size), "fuzz.csv",
                                reflectance);
  } catch (const InputError&) {
    return 0;
  }
  for (double nm = 1.0; nm < 1e6; nm *= 1.07) {
    const double value = (*spectrum)(nm);
    if (!(value >= 0.0 && value <= 1.0)) std::abort();
  }
  return 0;
}
