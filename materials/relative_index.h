// The parameters that conductors and dielectrics share: a medium, and what lies outside it.
#pragma once

#include <string>

#include "materials/index/index_table.h"
#include "materials/material.h"

namespace karat {

// `exterior`: optional; vacuum, n = 1, when absent.
ParameterInfo exterior_parameter();

// The table of the parameter `exterior`, or of vacuum; warns where it absorbs within the lattice.
IndexTablePtr exterior_index(const Parameters& parameters, const MaterialContext& context);

// n and k of the parameter `name` relative to the parameter `exterior` at the lattice wavelengths.
// An exterior that absorbs (k above 1e-3 anywhere) is taken by its n alone, with a warning.
LatticeIndex relative_index(const std::string& name, const Parameters& parameters,
                            const MaterialContext& context);

// Warns that `what` ("interior") absorbs where its k exceeds 1e-3, and what is done about it.
void warn_if_absorbing(const std::string& what, const LatticeSpectrum& k, const std::string& done,
                       const MaterialContext& context);

struct Extremes {
  float least, largest;
};
Extremes extremes(const LatticeSpectrum& spectrum);

}  // namespace karat
