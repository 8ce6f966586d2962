#include "render/oscillator_reader.h"

#include <fmt/format.h>

#include <utility>

#include "materials/index/index_oscillators.h"

namespace karat {
namespace {

constexpr std::size_t kMostOscillators = 1000;
constexpr double kLargestEv = 1e6;

double energy(const JsonValue& object, const std::string& key, bool above_zero) {
  return object.member(key).number({0.0, kLargestEv, above_zero});
}

double number_or(const JsonValue& object, const std::string& key, double otherwise,
                 const Allowed& allowed) {
  return object.has(key) ? object.member(key).number(allowed) : otherwise;
}

IndexTablePtr formula_index(const OscillatorModel& model, const std::string& what,
                            const JsonValue& value) {
  Provenance provenance;
  provenance.name = fmt::format("{} {}: plasma {:g} eV, eps_inf {:g}, f0 {:g}, gamma0 {:g} eV",
                                what, value.place(), model.plasma_ev, model.eps_inf,
                                model.free_strength, model.free_gamma_ev);
  for (const Oscillator& j : model.bound) {
    provenance.name +=
        fmt::format("; f {:g}, gamma {:g} eV, omega {:g} eV", j.strength, j.gamma_ev, j.omega_ev);
  }
  provenance.reference = "in the notation of Rakic et al., Appl. Opt. 37, 5271-5283 (1998)";
  return oscillator_index(model, std::move(provenance));
}

}  // namespace

IndexTablePtr read_drude(const JsonValue& value, const ReadContext&) {
  value.allow_keys({"drude"});
  const JsonValue drude = value.member("drude");
  drude.allow_keys({"plasma_eV", "gamma_eV", "eps_inf"});
  OscillatorModel model;
  model.plasma_ev = energy(drude, "plasma_eV", true);
  model.free_gamma_ev = energy(drude, "gamma_eV", false);
  model.free_strength = 1.0;
  model.eps_inf = number_or(drude, "eps_inf", 1.0, {0.0, 1e6, true});
  return formula_index(model, "drude", value);
}

IndexTablePtr read_lorentz(const JsonValue& value, const ReadContext&) {
  value.allow_keys({"lorentz"});
  const JsonValue lorentz = value.member("lorentz");
  lorentz.allow_keys({"plasma_eV", "eps_inf", "f0", "gamma0_eV", "oscillators"});
  OscillatorModel model;
  model.plasma_ev = energy(lorentz, "plasma_eV", true);
  model.eps_inf = number_or(lorentz, "eps_inf", 1.0, {0.0, 1e6, true});
  model.free_strength = number_or(lorentz, "f0", 0.0, {0.0, 1e6});
  if (lorentz.has("f0") || lorentz.has("gamma0_eV")) {
    if (!lorentz.has("f0")) lorentz.fail("\"f0\" is missing beside \"gamma0_eV\"");
    model.free_gamma_ev = energy(lorentz, "gamma0_eV", false);
  }
  const JsonValue oscillators = lorentz.member("oscillators");
  if (oscillators.require_array().size() == 0 || oscillators.size() > kMostOscillators) {
    oscillators.fail_found(fmt::format("a list of 1 to {} oscillators", kMostOscillators));
  }
  for (std::size_t i = 0; i < oscillators.size(); ++i) {
    const JsonValue j = oscillators.element(i);
    j.allow_keys({"f", "gamma_eV", "omega_eV"});
    model.bound.push_back({j.member("f").number({0.0, 1e6}), energy(j, "gamma_eV", true),
                           energy(j, "omega_eV", true)});
  }
  return formula_index(model, "lorentz", value);
}

}  // namespace karat
