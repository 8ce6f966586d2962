// Cube roots of the permittivities add by volume; made for powders without a host.
#include <algorithm>
#include <cmath>

#include "materials/mixing_rule.h"

namespace karat {
namespace {

class Looyenga final : public MixingRule {
 public:
  std::string description() const override {
    return "eps^(1/3) = sum f_i eps_i^(1/3): mixtures without a host, such as powders";
  }
  std::string source() const override { return "Looyenga, Physica 31, 401-406 (1965)"; }
  // The angle of eps lies in [0, pi], so that of its cube root in [0, pi/3]: so does that of a sum.
  Permittivity mixed(std::span<const MixingPart> parts, std::size_t) const override {
    Permittivity sum = 0.0;
    for (const MixingPart& part : parts) {
      const double angle = std::arg(part.permittivity) / 3.0;
      sum += part.fraction * std::polar(std::cbrt(std::abs(part.permittivity)), angle);
    }
    const Permittivity cube = sum * sum * sum;
    return {cube.real(), std::max(cube.imag(), 0.0)};
  }
};

KARAT_REGISTER(MixingRule, "looyenga", Looyenga);

}  // namespace
}  // namespace karat
