// Fresnel reflectance of an interface to a conductor (or dielectric), exact or approximated.
//
// Angles are those between a direction and the (micro)facet normal. Reflectances are power
// reflectances of unpolarised light unless a name says s or p. n and k are always relative to the
// exterior: prepare() divides by the exterior index, in every model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "materials/index_table.h"
#include "spectral/support/registry.h"

namespace karat {

// What a model precomputed per lattice wavelength; what the planes hold is the model's affair.
struct FresnelTables {
  std::vector<LatticeSpectrum> planes;
};

struct PolarisedReflectance {
  SampledSpectrum s;
  SampledSpectrum p;
};

// Stateless and shared. One source file per model, ending in
//   KARAT_REGISTER(FresnelModel, "name", Class);
class FresnelModel {
 public:
  virtual ~FresnelModel() = default;

  // One sentence, the paper, and the equation.
  virtual std::string description() const = 0;
  virtual std::string source() const = 0;

  // Runs once at load. `index` is relative to the exterior.
  virtual FresnelTables prepare(const LatticeIndex& index) const = 0;

  // In [0, 1] for cos_theta in [0, 1]; runs in the loop, once per spectrum.
  virtual SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                                      float cos_theta) const = 0;

  // s and p apart, or nothing where the model knows only the unpolarised value.
  virtual std::optional<PolarisedReflectance> polarised(const FresnelTables& tables, int phase,
                                                        float cos_theta) const {
    (void)tables, (void)phase, (void)cos_theta;
    return std::nullopt;
  }

  // The same model for one wavelength in double precision: the check of the float kernel and the
  // `--precision double` of the command line.
  struct Scalar {
    std::optional<double> s, p;
    double unpolarised = 0.0;
  };
  virtual Scalar evaluate(ComplexIndex relative_index, double cos_theta) const = 0;
};

}  // namespace karat
