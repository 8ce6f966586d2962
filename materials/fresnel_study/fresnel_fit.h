// Fitting the free parameters of a Fresnel model to reflectances, by least squares.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "materials/fresnel.h"

namespace karat {

// What to fit to: a reflectance for every index at every cosine, index by index.
struct FresnelData {
  std::vector<ComplexIndex> indices;  // relative to the exterior
  std::vector<double> cosines;        // in [0, 1]
  std::vector<double> reflectances;   // indices.size() x cosines.size()
};

// The exact reflectances.
FresnelData exact_data(std::vector<ComplexIndex> indices, std::vector<double> cosines);

struct FresnelFit {
  std::vector<double> values;  // in the order of the model's parameters()
  double max_abs_error = 0.0, rms_error = 0.0;
};

// What is left with these values: unweighted over indices and cosines.
FresnelFit fresnel_residual(const FresnelModel& model, const FresnelData& data,
                            std::vector<double> values);

// One set of values for all indices, each within its parameter's range, with the least sum of
// squared differences. Parameters named in `fixed` keep the value given there. Those in which the
// model is linear are solved for; the others are found by Levenberg and Marquardt's method (Ceres'
// small solver) from the local minima of a grid and from what the model would choose, and at the
// ends of their ranges. Throws InputError for an unknown name or a value out of range. Whole
// numbers keep what the model chooses for the index in the middle unless they are fixed. Where
// nothing is left to fit, the result is the residual.
FresnelFit fit_fresnel(const FresnelModel& model, const FresnelData& data,
                       const std::map<std::string, double>& fixed = {});

}  // namespace karat
