// Models over all materials of a study: how wrong, how expensive, and which are worth choosing.
#pragma once

#include <string>
#include <vector>

#include "materials/fresnel_study/fresnel_cost.h"
#include "materials/fresnel_study/fresnel_study.h"

namespace karat {

// Costs within this part of each other are the same, which is what a study repeats to from process
// to process. So are errors within a part of each other or below a floor, which is far below what
// an eye or a picture's eight bits can tell, but above what roundings make.
inline constexpr double kSameCost = 0.1, kSameError = 0.01, kNoError = 1e-3;

struct FresnelRank {
  std::string model;
  double cost_relative = 0.0;   // median, "exact" is 1
  double max_abs_error = 0.0;   // the worst material's
  double rms_error = 0.0;       // root of the mean square over materials
  double delta_e_mean = 0.0;    // mean over materials and angles
  double delta_e_max = 0.0;     // the worst material's and angle's
  double delta_e_albedo = 0.0;  // the worst material's
  std::string worst_material;   // of delta_e_max
  // No other model is better in cost or delta_e_mean, and as good in the other.
  bool efficient = false;
};

// In the order of the study's models.
std::vector<FresnelRank> rank_fresnel_models(const std::vector<FresnelMaterialStudy>& materials,
                                             const std::vector<FresnelCost>& costs);

}  // namespace karat
