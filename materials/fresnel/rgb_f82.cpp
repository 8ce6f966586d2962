// RGB workflow: base colour and F82 tint, as Adobe Standard Material and OpenPBR have them.
//
// Per channel the model "hoffman-f82" with F(mu) = tint S(mu): Kutz, Hasan and Edmondson, "Novel
// aspects of the Adobe Standard Material", 2021; OpenPBR 1.0, section "Metal". Base colour: linear
// sRGB of F0 under D65. Tint: linear sRGB of the exact F(mu) over that of S(mu). Both are clamped
// to [0, 1], as these formats demand; gold, silver and brass would need a tint above 1 in blue.
// What becomes of the three reflectances: materials/fresnel_rgb.h.
#include "materials/fresnel_f82.h"
#include "materials/fresnel_rgb.h"

namespace karat {
namespace {

double tinted(double f0, double f82) {
  const double s = schlick_from_f0(f0, kF82Cosine);
  return f82_strength(f0, std::clamp(f82 / s, 0.0, 1.0) * s);
}

class RgbF82Fresnel final : public RgbFresnel {
 public:
  std::string description() const override {
    return "RGB: hoffman-f82 with base colour and tint in linear sRGB, clamped to [0, 1]";
  }
  std::string source() const override {
    return "Kutz, Hasan and Edmondson 2021 (Adobe Standard Material); OpenPBR 1.0";
  }

  SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                              float cos_theta) const override {
    const SampledSpectrum& f0 = tables.planes[0][0];
    const SampledSpectrum& b = tables.planes[1][0];
    const float x = fifth_power(1.0f - cos_theta), dip = f82_dip(cos_theta);
    SampledSpectrum channels;
    for (int i = 0; i < kLanes; ++i) {
      channels[i] = std::clamp(f0[i] + (1.0f - f0[i]) * x - b[i] * dip, 0.0f, 1.0f);
    }
    return mixed(channels, tables, 2, phase);
  }

  Scalar evaluate(ComplexIndex index, double cos_theta) const override {
    const double f0 = normal_incidence(index.n, index.k);
    const double b = tinted(f0, exact_scalar(index, kF82Cosine).unpolarised);
    const double r = schlick_from_f0(f0, cos_theta) - b * f82_dip(cos_theta);
    return {std::nullopt, std::nullopt, std::clamp(r, 0.0, 1.0)};
  }

 protected:
  FresnelTables prepare_channels(const LatticeIndex& index,
                                 const RgbChannels& channels) const override {
    Rgb f0 = channels.rgb(lattice_of(index, normal_incidence));
    const Rgb f82 = channels.rgb(lattice_of(index, [](double n, double k) {
      return exact_scalar({n, k}, kF82Cosine).unpolarised;
    }));
    Rgb b;
    for (std::size_t c = 0; c < 3; ++c) {
      f0[c] = std::clamp(f0[c], 0.0, 1.0);
      b[c] = tinted(f0[c], f82[c]);
    }
    return {{channel_plane(f0), channel_plane(b)}};
  }
};

KARAT_REGISTER(FresnelModel, "rgb-f82", RgbF82Fresnel);

}  // namespace
}  // namespace karat
