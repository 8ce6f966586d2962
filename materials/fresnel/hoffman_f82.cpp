// Schlick's approximation with a term that makes it exact near the dip of metals, at 81.8 degrees.
//
// R = S(c) - b c (1 - c)^6 with S the model "schlick" and b = (S(mu) - F(mu)) / (mu (1 - mu)^6),
// mu = 1/7, F(mu) the exact reflectance: Hoffman, "Fresnel equations considered harmful", MAM 2019,
// equations 6 and 7; Kutz, Hasan and Edmondson 2021 (Adobe Standard Material); OpenPBR 1.0. mu is
// where c (1 - c)^6 is largest. Exact at 0, 81.8 and 90 degrees.
//
// These formats store the tint F(mu) / S(mu) and clamp it to 1, which gold, silver and brass exceed
// at short wavelengths: here F(mu) itself is the parameter, and nothing is clamped. What
// the clamped tint costs is the model "rgb-f82".
#include "materials/fresnel_exact.h"
#include "materials/fresnel_f82.h"
#include "materials/fresnel_parametric.h"

namespace karat {
namespace {

class HoffmanF82Fresnel final : public ParametricFresnel {
 public:
  std::string description() const override {
    return "schlick minus b cos (1 - cos)^6, exact at 81.8 degrees too";
  }
  std::string source() const override {
    return "Hoffman 2019, MAM, 10.2312/mam.20191305; Kutz, Hasan and Edmondson 2021; OpenPBR";
  }
  std::vector<FresnelParameter> parameters() const override {
    return {{"f82", "reflectance where the cosine is 1/7, at 81.8 degrees", 0.0, 1.0, false}};
  }
  std::vector<double> chosen(ComplexIndex index) const override {
    return {exact_scalar(index, kF82Cosine).unpolarised};
  }

  FresnelTables prepare_with(const LatticeIndex& index,
                             const std::vector<LatticeSpectrum>& values) const override {
    FresnelTables tables{{lattice_of(index, normal_incidence), {}}};
    for (int phase = 0; phase < kPhases; ++phase) {
      for (int i = 0; i < kLanes; ++i) {
        const double f0 = normal_incidence(double{index.n[phase][i]}, double{index.k[phase][i]});
        const double b = f82_strength(f0, double{values[0][phase][i]});
        tables.planes[1][phase][i] = static_cast<float>(b);
      }
    }
    return tables;
  }

  SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                              float cos_theta) const override {
    const SampledSpectrum& f0 = tables.planes[0][phase];
    const SampledSpectrum& b = tables.planes[1][phase];
    const float x = fifth_power(1.0f - cos_theta), dip = f82_dip(cos_theta);
    SampledSpectrum r;
    for (int i = 0; i < kLanes; ++i) r[i] = f0[i] + (1.0f - f0[i]) * x - b[i] * dip;
    return r;
  }

  double evaluate_with(ComplexIndex index, double cos_theta,
                       const std::vector<double>& values) const override {
    const double f0 = normal_incidence(index.n, index.k);
    const double dip = f82_strength(f0, values[0]) * f82_dip(cos_theta);
    return schlick_from_f0(f0, cos_theta) - dip;
  }
};

KARAT_REGISTER(FresnelModel, "hoffman-f82", HoffmanF82Fresnel);

}  // namespace
}  // namespace karat
