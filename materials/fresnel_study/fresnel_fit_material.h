// Fits over the wavelengths of a measured material.
#pragma once

#include "materials/fresnel_study/fresnel_fit.h"

namespace karat {

struct MaterialFitOptions {
  double n_exterior = 1.0;  // above 0
  bool over_range = false;  // one set of values for all wavelengths
  std::map<std::string, double> fixed = {};
};

struct FresnelFits {
  std::vector<FresnelParameter> parameters;
  std::vector<double> wavelengths_nm;
  bool per_wavelength = true;
  std::vector<FresnelFit> fits;  // one a wavelength, or one for all
  double max_abs_error = 0.0, rms_error = 0.0;
};

// Whether each wavelength gets values of its own: not where one set is asked for, or the model has
// a parameter per material.
bool fits_per_wavelength(const FresnelModel& model, const MaterialFitOptions& options);

// Fits `model` to the exact reflectances of `table` at these wavelengths (at least one) and 0 to 89
// degrees in steps of 1, unweighted: each wavelength by itself, or all at once, see
// fits_per_wavelength(). Throws InputError where the table does not cover
// the wavelengths or has a negative index.
FresnelFits fit_material(const FresnelModel& model, const IndexTable& table,
                         std::vector<double> wavelengths_nm, const MaterialFitOptions& options);

}  // namespace karat
