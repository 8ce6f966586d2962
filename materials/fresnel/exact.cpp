// The exact reflectance of a plane interface to an absorbing medium: the equations, and why they
// are written so, stand in materials/fresnel_exact.h.
#include "materials/fresnel_exact.h"

namespace karat {
namespace {

class ExactFresnel final : public ExactFormFresnel {
 public:
  std::string description() const override {
    return "exact Fresnel equations for a complex index, per wavelength";
  }
  std::string source() const override {
    return "Fresnel 1823; Born and Wolf, Principles of Optics, section 14.2";
  }

  ComplexIndex substitute(ComplexIndex index) const override { return index; }
};

KARAT_REGISTER(FresnelModel, "exact", ExactFresnel);

}  // namespace
}  // namespace karat
