// Colours of reflectance curves, and their differences.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "materials/fresnel_study/fresnel_study.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

// sum(S xyzbar R) over whole nanometres, with R linear between the grid's wavelengths, is a sum
// over the grid's own values: these are its weights, scaled to Y = 1 for R = 1.
std::vector<Xyz> colour_weights(const std::vector<double>& wavelengths_nm,
                                const FresnelViewing& viewing) {
  const SpectrumPtr light = illuminant(viewing.illuminant);
  const Observer& eye = observer(viewing.observer);
  std::vector<Xyz> weights(wavelengths_nm.size(), Xyz{});
  double y = 0.0;
  const double first = std::ceil(std::max(wavelengths_nm.front(), eye.range.min_nm));
  const double last = std::min(wavelengths_nm.back(), eye.range.max_nm);
  for (double nm = first; nm <= last; nm += 1.0) {
    const auto above = std::upper_bound(wavelengths_nm.begin(), wavelengths_nm.end(), nm);
    const auto j = std::min<std::size_t>(static_cast<std::size_t>(above - wavelengths_nm.begin()),
                                         wavelengths_nm.size() - 1);
    const std::size_t i = j == 0 ? 0 : j - 1;
    const double width = wavelengths_nm[j] - wavelengths_nm[i];
    const double t = width > 0.0 ? (nm - wavelengths_nm[i]) / width : 0.0;
    for (int channel = 0; channel < 3; ++channel) {
      const double value = (*light)(nm)*eye[channel](nm);
      const auto x = static_cast<std::size_t>(channel);
      weights[i][x] += (1.0 - t) * value;
      weights[j][x] += t * value;
      if (channel == 1) y += value;
    }
  }
  if (!(y > 0.0)) {
    throw InputError("illuminant \"" + viewing.illuminant + "\" has no visible power between the " +
                     "wavelengths of the study; no colours can be computed");
  }
  for (Xyz& weight : weights) {
    for (double& value : weight) value /= y;
  }
  return weights;
}

Xyz weighted(const std::vector<Xyz>& weights, const double* values) {
  Xyz sum{};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    for (std::size_t x = 0; x < 3; ++x) sum[x] += weights[i][x] * values[i];
  }
  return sum;
}

Xyz white_of(const std::vector<Xyz>& weights) {
  const std::vector<double> ones(weights.size(), 1.0);
  return weighted(weights, ones.data());
}

}  // namespace

FresnelColours fresnel_colours(const FresnelCurves& curves, const FresnelGrid& grid,
                               const FresnelViewing& viewing) {
  const auto weights = colour_weights(grid.wavelengths_nm, viewing);
  FresnelColours colours;
  for (std::size_t a = 0; a < grid.angles_deg.size(); ++a) {
    colours.per_angle.push_back(weighted(weights, &curves.unpolarised[a * weights.size()]));
  }
  colours.albedo = weighted(weights, curves.albedo.data());
  return colours;
}

FresnelColourErrors fresnel_colour_errors(const FresnelColours& model, const FresnelColours& exact,
                                          const FresnelGrid& grid, const FresnelViewing& viewing) {
  const Xyz white = white_of(colour_weights(grid.wavelengths_nm, viewing));
  const auto difference = [&](const Xyz& a, const Xyz& b) {
    return delta_e_2000(lab_of_xyz(a, white), lab_of_xyz(b, white));
  };
  FresnelColourErrors errors;
  for (std::size_t a = 0; a < exact.per_angle.size(); ++a) {
    errors.delta_e.push_back(difference(model.per_angle[a], exact.per_angle[a]));
  }
  const auto worst = std::max_element(errors.delta_e.begin(), errors.delta_e.end());
  errors.max = *worst;
  errors.worst_deg = grid.angles_deg[static_cast<std::size_t>(worst - errors.delta_e.begin())];
  errors.mean = std::accumulate(errors.delta_e.begin(), errors.delta_e.end(), 0.0) /
                static_cast<double>(errors.delta_e.size());
  errors.albedo = difference(model.albedo, exact.albedo);
  return errors;
}

}  // namespace karat
