#include "materials/fresnel_study/fresnel_fit_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "spectral/support/error.h"

namespace karat {
namespace {

std::vector<double> cosines_of_degrees() {
  std::vector<double> cosines;
  for (int degrees = 0; degrees < 90; ++degrees) {
    cosines.push_back(std::sin((90.0 - degrees) * (std::numbers::pi / 180.0)));
  }
  return cosines;
}

std::vector<ComplexIndex> relative_indices(const IndexTable& table,
                                           const std::vector<double>& wavelengths_nm,
                                           double n_exterior) {
  const auto [least, largest] = std::minmax_element(wavelengths_nm.begin(), wavelengths_nm.end());
  require_coverage(table, {*least, *largest}, RangePolicy::kError);
  std::vector<ComplexIndex> indices;
  for (const double nm : wavelengths_nm) {
    const ComplexIndex index = table.at(nm);
    if (!(index.n >= 0.0 && index.k >= 0.0)) {
      throw InputError(table.provenance().name, "",
                       fmt::format("n = {:g}, k = {:g} at {:g} nm; both must be 0 or above",
                                   index.n, index.k, nm));
    }
    indices.push_back({index.n / n_exterior, index.k / n_exterior});
  }
  return indices;
}

}  // namespace

bool fits_per_wavelength(const FresnelModel& model, const MaterialFitOptions& options) {
  const std::vector<FresnelParameter> infos = model.parameters();
  return !options.over_range &&
         std::none_of(infos.begin(), infos.end(), [](const auto& i) { return i.per_material; });
}

FresnelFits fit_material(const FresnelModel& model, const IndexTable& table,
                         std::vector<double> wavelengths_nm, const MaterialFitOptions& options) {
  FresnelFits result{
      model.parameters(), std::move(wavelengths_nm), fits_per_wavelength(model, options), {}};
  const auto indices = relative_indices(table, result.wavelengths_nm, options.n_exterior);
  const auto add = [&](std::vector<ComplexIndex> chosen) {
    result.fits.push_back(
        fit_fresnel(model, exact_data(std::move(chosen), cosines_of_degrees()), options.fixed));
  };
  if (result.per_wavelength) {
    for (const ComplexIndex& index : indices) add({index});
  } else {
    add(indices);
  }
  for (const FresnelFit& fit : result.fits) {
    result.max_abs_error = std::max(result.max_abs_error, fit.max_abs_error);
    result.rms_error += fit.rms_error * fit.rms_error;
  }
  result.rms_error = std::sqrt(result.rms_error / static_cast<double>(result.fits.size()));
  return result;
}

}  // namespace karat
