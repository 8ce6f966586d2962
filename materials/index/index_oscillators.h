// Indices from formulas of the permittivity: Drude's free electrons and Lorentz' bound ones.
#pragma once

#include <vector>

#include "materials/index/index_table.h"
#include "materials/mixing_rule.h"

namespace karat {

// All energies in eV (hbar times the angular frequency or damping rate).
struct Oscillator {
  double strength;  // f_j, of the squared plasma energy
  double gamma_ev;  // Gamma_j > 0
  double omega_ev;  // omega_j > 0
};

struct OscillatorModel {
  double plasma_ev = 0.0;         // hbar omega_p
  double eps_inf = 1.0;           // permittivity far above all resonances
  double free_strength = 0.0;     // f_0: Omega_p = sqrt(f_0) omega_p
  double free_gamma_ev = 0.0;     // Gamma_0
  std::vector<Oscillator> bound;  // j = 1 ... k
};

// At a photon energy above 0. Rakic, Djurisic, Elazar, Majewski, Appl. Opt. 37, 5271-5283 (1998),
// equations 1 to 3, here for exp(-i omega t):
//   eps_inf - f_0 omega_p^2 / (w (w + i Gamma_0))
//           + sum f_j omega_p^2 / (omega_j^2 - w^2 - i w Gamma_j)
Permittivity permittivity_of(const OscillatorModel& model, double photon_ev);

// The same as a table without end: where the formula was fitted, its source knows. at() throws
// InputError at a resonance without damping.
IndexTablePtr oscillator_index(OscillatorModel model, Provenance provenance);

// hc / e, exact in the SI of 2019: photon energy in eV times wavelength in nm.
inline constexpr double kEvNm = 1239.8419843320026;

}  // namespace karat
