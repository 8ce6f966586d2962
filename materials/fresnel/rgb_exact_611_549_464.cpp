// RGB workflow: n and k at three wavelengths, then the exact equations.
//
// 611, 549 and 464 nm: the dominant wavelengths of the sRGB primaries under D65.
// What becomes of the three reflectances: materials/fresnel_rgb.h.
#include "materials/fresnel_rgb.h"

namespace karat {
namespace {

constexpr Rgb kWavelengths{{611.0, 549.0, 464.0}};  // red, green, blue in nm

class RgbDominantWavelengthsFresnel final : public RgbExactFresnel {
 public:
  std::string description() const override {
    return "RGB: exact at 611, 549 and 464 nm, one wavelength per channel";
  }
  std::string source() const override { return "dominant wavelengths of the sRGB primaries"; }

 protected:
  ChannelIndex channel_index(const LatticeIndex& index, const RgbChannels&) const override {
    return index_at(index, kWavelengths);
  }
};

KARAT_REGISTER(FresnelModel, "rgb-exact-611-549-464", RgbDominantWavelengthsFresnel);

}  // namespace
}  // namespace karat
