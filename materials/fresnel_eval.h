// Fresnel models at single combinations of index and angle: command line, studies, tests.
#pragma once

#include <vector>

#include "materials/fresnel.h"

namespace karat {

struct FresnelQuery {
  double n = 1.0, k = 0.0;  // absolute; both are divided by n_exterior
  double theta_deg = 0.0;   // in [0, 90]
  double n_exterior = 1.0;  // above 0
};

enum class FresnelPrecision {
  kFloat,   // the renderer's own kernel: prepare() and reflectance() on the lattice
  kDouble,  // FresnelModel::evaluate
};

// One result per query, in their order; each query is a material of this index at every wavelength.
// s and p are absent where the model knows only their mean. `values`, where not empty, are those of
// model.parameters(); otherwise the model chooses them.
std::vector<FresnelModel::Scalar> evaluate_fresnel(const FresnelModel& model,
                                                   const std::vector<FresnelQuery>& queries,
                                                   FresnelPrecision precision,
                                                   const std::vector<double>& values = {});

}  // namespace karat
