// RGB workflow: Schlick's approximation with a base colour.
//
// R_c = F0_c + (1 - F0_c)(1 - cos)^5 per channel, F0_c the linear sRGB of the exact reflectance at
// normal incidence under D65, clamped to [0, 1]: the metals of glTF 2.0 (appendix B.2), of game
// engines and of the Disney BRDF (Burley 2012, section 5.5). The colour of gold and of copper is
// outside sRGB; their base colours are clamped, here as there.
// What becomes of the three reflectances: materials/fresnel_rgb.h.
#include "materials/fresnel_rgb.h"
#include "materials/fresnel_terms.h"

namespace karat {
namespace {

class RgbSchlickFresnel final : public RgbFresnel {
 public:
  std::string description() const override {
    return "RGB: schlick with F0 as a linear sRGB colour, clamped to [0, 1]";
  }
  std::string source() const override { return "glTF 2.0, appendix B; Burley 2012"; }

  SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                              float cos_theta) const override {
    const SampledSpectrum& f0 = tables.planes[0][0];
    const float x = fifth_power(1.0f - cos_theta);
    SampledSpectrum channels;
    for (int i = 0; i < kLanes; ++i) channels[i] = f0[i] + (1.0f - f0[i]) * x;
    return mixed(channels, tables, 1, phase);
  }

  Scalar evaluate(ComplexIndex index, double cos_theta) const override {
    const double f0 = normal_incidence(index.n, index.k);
    return {std::nullopt, std::nullopt, f0 + (1.0 - f0) * fifth_power(1.0 - cos_theta)};
  }

 protected:
  FresnelTables prepare_channels(const LatticeIndex& index,
                                 const RgbChannels& channels) const override {
    Rgb f0 = channels.rgb(lattice_of(index, normal_incidence));
    for (double& x : f0) x = std::clamp(x, 0.0, 1.0);
    return {{channel_plane(f0)}};
  }
};

KARAT_REGISTER(FresnelModel, "rgb-schlick", RgbSchlickFresnel);

}  // namespace
}  // namespace karat
