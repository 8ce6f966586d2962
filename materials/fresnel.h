// Fresnel reflectance of an interface to a conductor (or dielectric), exact or approximated.
//
// Angles are those between a direction and the (micro)facet normal. Reflectances are power
// reflectances of unpolarised light unless a name says s or p. n and k are always relative to the
// exterior: prepare() divides by the exterior index, in every model.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "materials/index/index_table.h"
#include "spectral/support/registry.h"

namespace karat {

// What a model precomputed per lattice wavelength; what the planes hold is the model's affair.
struct FresnelTables {
  std::vector<LatticeSpectrum> planes;
};

// A number that a model's formula leaves open: prepare() chooses it, a scene may state it.
struct FresnelParameter {
  std::string name;           // as in a scene: "exponent"
  std::string description;    // one sentence
  double min, max;            // both allowed
  bool per_material;          // one number for all wavelengths; otherwise one per wavelength
  bool whole_number = false;  // a size, which a fit leaves alone
};

// Empty, or what is wrong with a stated value and what is allowed.
std::string parameter_error(const FresnelParameter& parameter, double value);

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

  // False where the value at one wavelength depends on the index at others too: one fitted number
  // for a whole material, or the three channels of a renderer without spectra.
  virtual bool per_wavelength() const { return true; }

  // Runs once at load. `index` is relative to the exterior. Throws InputError where the model
  // cannot work at these wavelengths (colour channels outside the visible).
  virtual FresnelTables prepare(const LatticeIndex& index) const = 0;

  // What the paper's form gives for cos_theta in [0, 1]: finite, but outside [0, 1] where an
  // approximation leaves it, which a study must see. What scatters light takes
  // bounded_reflectance(). Runs in the loop, once per spectrum.
  virtual SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                                      float cos_theta) const = 0;

  // s and p apart, or nothing where the model knows only the unpolarised value.
  virtual std::optional<PolarisedReflectance> polarised(const FresnelTables& tables, int phase,
                                                        float cos_theta) const {
    (void)tables, (void)phase, (void)cos_theta;
    return std::nullopt;
  }

  // The same model in double precision for a material of this index at every wavelength: the check
  // of the float kernel and the `--precision double` of the command line. (Where a model is per
  // wavelength, what the material is at other wavelengths changes nothing.)
  struct Scalar {
    std::optional<double> s, p;
    double unpolarised = 0.0;
  };
  virtual Scalar evaluate(ComplexIndex relative_index, double cos_theta) const = 0;

  // Free parameters, if any. For a model that lists some, prepare(index) is
  // prepare_with(index, what it chooses), and likewise evaluate(); ParametricFresnel
  // (materials/fresnel_parametric.h) says it once for all of them. Values are in the order of
  // parameters(); those of a parameter per material are the same at every wavelength.
  virtual std::vector<FresnelParameter> parameters() const { return {}; }
  virtual std::vector<double> chosen(ComplexIndex relative_index) const {
    (void)relative_index;
    return {};
  }
  virtual FresnelTables prepare_with(const LatticeIndex& index,
                                     const std::vector<LatticeSpectrum>& values) const {
    (void)values;
    return prepare(index);
  }
  virtual double evaluate_with(ComplexIndex relative_index, double cos_theta,
                               const std::vector<double>& values) const {
    (void)values;
    return evaluate(relative_index, cos_theta).unpolarised;
  }
};

// The registered model. Throws InputError with the nearest name and the names there are.
const FresnelModel& fresnel_model(const std::string& name);

// The reflectance in [0, 1], so that no approximation creates light or takes more than there is.
inline SampledSpectrum bounded_reflectance(const FresnelModel& model, const FresnelTables& tables,
                                           int phase, float cos_theta) {
  SampledSpectrum r = model.reflectance(tables, phase, cos_theta);
  for (int i = 0; i < kLanes; ++i) r[i] = std::min(std::max(r[i], 0.0f), 1.0f);
  return r;
}

}  // namespace karat
