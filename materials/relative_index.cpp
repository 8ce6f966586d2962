#include "materials/relative_index.h"

#include <algorithm>

#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr float kNoticeableK = 1e-3f;

}  // namespace

ParameterInfo exterior_parameter() {
  ParameterInfo exterior;
  exterior.name = "exterior";
  exterior.type = ParameterType::kIndex;
  exterior.description =
      "index of the medium outside, of which n counts; vacuum (n = 1) by default";
  return exterior;
}

void warn_if_absorbing(const std::string& what, const LatticeSpectrum& k, const std::string& done,
                       const MaterialContext& context) {
  const float largest = extremes(k).largest;
  if (!(largest > kNoticeableK)) return;
  context.warnings->push_back("the " + what + " absorbs (k up to " + std::to_string(largest) +
                              "): " + done);
}

Extremes extremes(const LatticeSpectrum& spectrum) {
  Extremes found{spectrum[0][0], spectrum[0][0]};
  for (int phase = 0; phase < kPhases; ++phase) {
    for (int i = 0; i < kLanes; ++i) {
      found.least = std::min(found.least, spectrum[phase][i]);
      found.largest = std::max(found.largest, spectrum[phase][i]);
    }
  }
  return found;
}

IndexTablePtr exterior_index(const Parameters& parameters, const MaterialContext& context) {
  const IndexTablePtr outside =
      parameters.has("exterior") ? parameters.index("exterior") : constant_index({1.0, 0.0});
  warn_if_absorbing("exterior", on_lattice(*outside, context.lattice).k, "only its n is used",
                    context);
  return outside;
}

// The division is done in double precision, before anything is rounded to float.
LatticeIndex relative_index(const std::string& name, const Parameters& parameters,
                            const MaterialContext& context) {
  const IndexTablePtr inside = parameters.index(name);
  const IndexTablePtr outside = exterior_index(parameters, context);
  LatticeIndex relative;
  relative.lattice = context.lattice;
  for (int phase = 0; phase < kPhases; ++phase) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const double nm = context.lattice.wavelength_nm(lane, phase);
      const ComplexIndex in = inside->at(nm), out = outside->at(nm);
      if (!(out.n > 0.0)) {
        throw InputError("exterior: its n is " + std::to_string(out.n) + " at " +
                         std::to_string(nm) + " nm; it must be above 0");
      }
      relative.n[phase][lane] = static_cast<float>(in.n / out.n);
      relative.k[phase][lane] = static_cast<float>(in.k / out.n);
    }
  }
  return relative;
}

}  // namespace karat
