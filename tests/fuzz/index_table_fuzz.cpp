// Any bytes are a table or an InputError: no crash, no hang, no value that is not finite.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "materials/index/index_table_file.h"
#include "spectral/support/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace karat;
  IndexTablePtr table;
  try {
    table = load_index_table_text(std::string(reinterpret_cast<const char*>(bytes), size), "fuzz");
  } catch (const InputError&) {
    return 0;
  }
  const WavelengthRange range = table->range();
  if (!(range.min_nm > 0.0 && range.min_nm <= range.max_nm)) std::abort();
  for (int i = -1; i <= 33; ++i) {
    const double nm = range.min_nm + range.width_nm() * i / 32.0;
    try {
      const ComplexIndex index = table->at(nm);
      if (!std::isfinite(index.n) || !std::isfinite(index.k)) std::abort();
    } catch (const InputError&) {
    }
  }
  try {
    const LatticeIndex index = on_lattice(*table, WavelengthLattice());
    for (int phase = 0; phase < kPhases; ++phase) {
      if (!is_finite(index.n[phase]) || !is_finite(index.k[phase])) std::abort();
    }
  } catch (const InputError&) {
  }
  return 0;
}
