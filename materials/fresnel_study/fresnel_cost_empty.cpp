#include "materials/fresnel_study/fresnel_cost_empty.h"

namespace karat {
namespace {

class Nothing final : public FresnelModel {
 public:
  std::string description() const override { return "nothing"; }
  std::string source() const override { return ""; }
  FresnelTables prepare(const LatticeIndex& index) const override { return {{index.n}}; }
  SampledSpectrum reflectance(const FresnelTables& tables, int phase, float) const override {
    return tables.planes[0][phase];
  }
  Scalar evaluate(ComplexIndex, double) const override { return {}; }
};

}  // namespace

const FresnelModel& empty_fresnel_model() {
  static const Nothing model;
  return model;
}

}  // namespace karat
