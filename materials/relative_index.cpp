#include "materials/relative_index.h"

#include <algorithm>

#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr double kNoticeableK = 1e-3;

}  // namespace

ParameterInfo exterior_parameter() {
  ParameterInfo exterior;
  exterior.name = "exterior";
  exterior.type = ParameterType::kIndex;
  exterior.description =
      "index of the medium outside, of which n counts; vacuum (n = 1) by default";
  return exterior;
}

// The division is done in double precision, before anything is rounded to float.
LatticeIndex relative_index(const std::string& name, const Parameters& parameters,
                            const MaterialContext& context) {
  const IndexTablePtr inside = parameters.index(name);
  const IndexTablePtr outside =
      parameters.has("exterior") ? parameters.index("exterior") : constant_index({1.0, 0.0});
  LatticeIndex relative;
  double largest_k = 0.0;
  for (int phase = 0; phase < kPhases; ++phase) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const double nm = context.lattice.wavelength_nm(lane, phase);
      const ComplexIndex in = inside->at(nm), out = outside->at(nm);
      if (!(out.n > 0.0)) {
        throw InputError("exterior: its n is " + std::to_string(out.n) + " at " +
                         std::to_string(nm) + " nm; it must be above 0");
      }
      largest_k = std::max(largest_k, out.k);
      relative.n[phase][lane] = static_cast<float>(in.n / out.n);
      relative.k[phase][lane] = static_cast<float>(in.k / out.n);
    }
  }
  if (largest_k > kNoticeableK) {
    context.warnings->push_back("the exterior " + outside->provenance().name +
                                " absorbs (k up to " + std::to_string(largest_k) +
                                "): only its n is used");
  }
  return relative;
}

}  // namespace karat
