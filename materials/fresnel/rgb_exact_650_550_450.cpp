// RGB workflow: n and k at three wavelengths, then the exact equations.
//
// 650, 550 and 450 nm: the round numbers at which artists look up n and k for red, green and blue
// (Arnold's and V-Ray's documentation of complex indices; Gulbrandsen 2014, section 4).
// What becomes of the three reflectances: materials/fresnel_rgb.h.
#include "materials/fresnel_rgb.h"

namespace karat {
namespace {

constexpr Rgb kWavelengths{{650.0, 550.0, 450.0}};  // red, green, blue in nm

class RgbRoundWavelengthsFresnel final : public RgbExactFresnel {
 public:
  std::string description() const override {
    return "RGB: exact at 650, 550 and 450 nm, one wavelength per channel";
  }
  std::string source() const override { return "usual practice for renderers without spectra"; }

 protected:
  ChannelIndex channel_index(const LatticeIndex& index, const RgbChannels&) const override {
    return index_at(index, kWavelengths);
  }
};

KARAT_REGISTER(FresnelModel, "rgb-exact-650-550-450", RgbRoundWavelengthsFresnel);

}  // namespace
}  // namespace karat
