// The parameter "fresnel" of materials: which model, and what its free parameters are.
#pragma once

#include "materials/fresnel.h"
#include "materials/material.h"

namespace karat {

// `fresnel`: a model's name, or the name with values for all that the model leaves open.
ParameterInfo fresnel_parameter();

struct PreparedFresnel {
  const FresnelModel* model;
  FresnelTables tables;
};

// The model that `parameters` or the context's override names, prepared for `index`. Values that
// the scene states count for the model for which it states them: an override by another model drops
// them, with a warning. Throws InputError for a value missing, unknown, out of range, or varying
// over wavelength where the model takes one number.
PreparedFresnel prepare_fresnel(const Parameters& parameters, const LatticeIndex& index,
                                const MaterialContext& context);

}  // namespace karat
