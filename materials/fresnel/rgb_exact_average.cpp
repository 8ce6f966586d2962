// RGB workflow: n and k averaged over each colour channel, then the exact equations.
//
// n_c = sum of n(lambda) w_c(lambda), w_c the weights with which linear sRGB sees a reflectance
// under D65 (1931 observer): n and k are treated as if they were colours, as in pbrt-v3 and in the
// RGB variants of Mitsuba, whose "n = (0.14, 0.37, 1.44)" for gold is made so. The weights are
// negative in places; n and k are kept from falling below 0. A constant n stays what it is. What
// becomes of the three reflectances: materials/fresnel_rgb.h.
#include "materials/fresnel_rgb.h"

namespace karat {
namespace {

Rgb not_negative(Rgb rgb) {
  for (double& x : rgb) x = std::max(x, 0.0);
  return rgb;
}

class RgbAverageFresnel final : public RgbExactFresnel {
 public:
  std::string description() const override {
    return "RGB: exact for n and k turned into linear sRGB as if they were colours";
  }
  std::string source() const override {
    return "Pharr, Jakob and Humphreys 2016 (pbrt-v3); the RGB variants of Mitsuba";
  }

 protected:
  ChannelIndex channel_index(const LatticeIndex& index,
                             const RgbChannels& channels) const override {
    return {not_negative(channels.rgb(index.n)), not_negative(channels.rgb(index.k))};
  }
};

KARAT_REGISTER(FresnelModel, "rgb-exact-average", RgbAverageFresnel);

}  // namespace
}  // namespace karat
