#include "render/fresnel_probes.h"

#include <memory>

namespace karat {
namespace {

class RepeatedExact final : public FresnelModel {
 public:
  RepeatedExact(int evaluations, std::atomic<std::uint64_t>* calls)
      : evaluations_(evaluations), calls_(calls) {}

  std::string description() const override { return "exact, evaluated several times"; }
  std::string source() const override { return "a probe for measurements"; }
  FresnelTables prepare(const LatticeIndex& index) const override { return exact_.prepare(index); }

  SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                              float cos_theta) const override {
    if (calls_) calls_->fetch_add(1, std::memory_order_relaxed);
    SampledSpectrum result;
    for (int i = 0; i < evaluations_; ++i) result = exact_.reflectance(tables, phase, cos_theta);
    return result;
  }
  std::optional<PolarisedReflectance> polarised(const FresnelTables& tables, int phase,
                                                float cos_theta) const override {
    return exact_.polarised(tables, phase, cos_theta);
  }
  Scalar evaluate(ComplexIndex index, double cos_theta) const override {
    return exact_.evaluate(index, cos_theta);
  }

 private:
  const FresnelModel& exact_ = *Registry<FresnelModel>::instance().find("exact");
  int evaluations_;
  std::atomic<std::uint64_t>* calls_;
};

}  // namespace

FresnelProbe::FresnelProbe(int evaluations, bool counts)
    : name_("exact, " + std::to_string(evaluations) + (counts ? " times, counted" : " times")) {
  Registry<FresnelModel>::instance().add(
      name_, std::make_unique<const RepeatedExact>(evaluations, counts ? &calls_ : nullptr));
}

FresnelProbe::~FresnelProbe() { Registry<FresnelModel>::instance().remove(name_); }

}  // namespace karat
