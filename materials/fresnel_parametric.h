// What models with free parameters share: they choose values for a material, and are evaluated with
// values, chosen or given.
#pragma once

#include "materials/fresnel_terms.h"

namespace karat {

// A model states parameters(), chosen() for one wavelength, reflectance() and evaluate_with(). One
// whose values hold for a whole material overrides chosen_on() too, and one that needs other planes
// than F0 and the values prepare_with().
class ParametricFresnel : public FresnelModel {
 public:
  FresnelTables prepare(const LatticeIndex& index) const override {
    return prepare_with(index, chosen_on(index));
  }
  Scalar evaluate(ComplexIndex index, double cos_theta) const final {
    return {std::nullopt, std::nullopt, evaluate_with(index, cos_theta, chosen(index))};
  }
  // F0, then the values in the order of parameters().
  FresnelTables prepare_with(const LatticeIndex& index,
                             const std::vector<LatticeSpectrum>& values) const override {
    FresnelTables tables{{lattice_of(index, normal_incidence)}};
    tables.planes.insert(tables.planes.end(), values.begin(), values.end());
    return tables;
  }
  double evaluate_with(ComplexIndex index, double cos_theta,
                       const std::vector<double>& values) const override = 0;

  // The values for a material, one spectrum per parameter.
  virtual std::vector<LatticeSpectrum> chosen_on(const LatticeIndex& index) const {
    std::vector<LatticeSpectrum> values(parameters().size());
    for (int phase = 0; phase < kPhases; ++phase) {
      for (int i = 0; i < kLanes; ++i) {
        const auto at = chosen({double{index.n[phase][i]}, double{index.k[phase][i]}});
        for (std::size_t p = 0; p < at.size(); ++p) {
          values[p][phase][i] = static_cast<float>(at[p]);
        }
      }
    }
    return values;
  }
};

}  // namespace karat
