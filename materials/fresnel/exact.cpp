// The exact reflectance of a plane interface to an absorbing medium: the equations, and why they
// are written so, stand in materials/fresnel_exact.h.
#include "materials/fresnel_exact.h"

namespace karat {
namespace {

class ExactFresnel final : public FresnelModel {
 public:
  std::string description() const override {
    return "exact Fresnel equations for a complex index, per wavelength";
  }
  std::string source() const override {
    return "Fresnel 1823; Born and Wolf, Principles of Optics, section 14.2";
  }

  FresnelTables prepare(const LatticeIndex& index) const override {
    return exact_tables(index, [](double n, double k) { return ComplexIndex{n, k}; });
  }

  SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                              float cos_theta) const override {
    return exact_reflectance(tables, phase, cos_theta);
  }

  std::optional<PolarisedReflectance> polarised(const FresnelTables& tables, int phase,
                                                float cos_theta) const override {
    return exact_polarised(tables, phase, cos_theta);
  }

  Scalar evaluate(ComplexIndex index, double cos_theta) const override {
    return exact_scalar(index, cos_theta);
  }
};

KARAT_REGISTER(FresnelModel, "exact", ExactFresnel);

}  // namespace
}  // namespace karat
