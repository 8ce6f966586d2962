// Whether n and k can belong to one causal and passive material.
#pragma once

#include <vector>

namespace karat {

// A complex index over photon energy, energies in eV, above 0 and strictly increasing.
struct EnergyIndex {
  std::vector<double> energy_ev;
  std::vector<double> n, k;
};

// The n that k implies: n(w) - 1 = 2/pi P int_0^inf w' k(w') / (w'^2 - w^2) dw' (Kramers-Kronig;
// Lucarini et al. 2005, "Kramers-Kronig Relations in Optical Materials Research").
//
// Measured is only an interval. What k adds from outside of it is unknown, but it is not arbitrary:
// a passive material has k >= 0 there too, so that it adds a sum of terms 1 / (w'^2 - w^2) with
// weights that are not negative (Milton, Eyre and Mantese 1997, Phys. Rev. Lett. 79, 3062). The
// weights that bring n closest to the measured one are found by non-negative least squares, with k
// piecewise linear outside as Kuzmenko 2005 (Rev. Sci. Instrum. 76, 083108) has it inside. What
// remains is an inconsistency that no passive absorption outside could explain.
struct KramersKronigFit {
  std::vector<double> n;  // that k implies, at the energies given
  double rms = 0.0;       // of the difference to the measured n, as a share of |1 + n + ik| there,
                          // evenly over log energy: what a reflection amplitude feels of it
  // The outer absorption that was chosen: k at energies outside.
  std::vector<double> outer_energy_ev, outer_k;
};

// At least 5 energies. `scale` multiplies k: a table whose k were wrong by a factor would fit best
// with another than 1.
KramersKronigFit kramers_kronig_fit(const EnergyIndex& index, double scale = 1.0);

}  // namespace karat
