// {"drude": ...} and {"lorentz": ...}: indices from formulas of the permittivity.
#pragma once

#include "render/spectrum_reader.h"

namespace karat {

// {"drude": {"plasma_eV", "gamma_eV", "eps_inf"}}
IndexTablePtr read_drude(const JsonValue& value, const ReadContext& context);

// {"lorentz": {"plasma_eV", "eps_inf", "f0", "gamma0_eV", "oscillators": [{"f", "gamma_eV",
// "omega_eV"}, ...]}}
IndexTablePtr read_lorentz(const JsonValue& value, const ReadContext& context);

}  // namespace karat
