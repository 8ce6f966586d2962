#include "materials/index/index_oscillators.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "materials/permittivity.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

class OscillatorIndex final : public IndexTable {
 public:
  OscillatorIndex(OscillatorModel model, Provenance provenance)
      : model_(std::move(model)), provenance_(std::move(provenance)) {}

  ComplexIndex at(double wavelength_nm) const override {
    const Permittivity eps = permittivity_of(model_, kEvNm / wavelength_nm);
    if (std::isfinite(eps.real()) && std::isfinite(eps.imag())) return index_of(eps);
    throw InputError(fmt::format("\"{}\" has no finite index at {:.7g} nm: an undamped resonance",
                                 provenance_.name, wavelength_nm));
  }
  WavelengthRange range() const override { return {0.0, std::numeric_limits<double>::infinity()}; }
  bool has_k() const override { return true; }
  const Provenance& provenance() const override { return provenance_; }
  const std::vector<std::string>& warnings() const override { return warnings_; }

 private:
  OscillatorModel model_;
  Provenance provenance_;
  std::vector<std::string> warnings_;
};

}  // namespace

Permittivity permittivity_of(const OscillatorModel& model, double photon_ev) {
  const double plasma2 = model.plasma_ev * model.plasma_ev;
  const Permittivity w(photon_ev, 0.0);
  Permittivity eps = model.eps_inf - model.free_strength * plasma2 /
                                         (w * Permittivity(photon_ev, model.free_gamma_ev));
  for (const Oscillator& j : model.bound) {
    const double detuning = (j.omega_ev - photon_ev) * (j.omega_ev + photon_ev);
    eps += j.strength * plasma2 / Permittivity(detuning, -photon_ev * j.gamma_ev);
  }
  return eps;
}

IndexTablePtr oscillator_index(OscillatorModel model, Provenance provenance) {
  return std::make_shared<OscillatorIndex>(std::move(model), std::move(provenance));
}

}  // namespace karat
