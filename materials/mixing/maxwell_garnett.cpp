// Small separate spheres in a host: with b = (eps - eps_host) / (eps + 2 eps_host),
// b(mixture) = sum f_i b_i. It resonates where eps_i is near -2 eps_host: the colour of gold ruby
// glass. Not for fractions above some 0.3, and not for alloys.
#include "materials/mixing_rule.h"

namespace karat {
namespace {

class MaxwellGarnett final : public MixingRule {
 public:
  std::string description() const override {
    return "separate spheres in a host (\"host\", or the part of largest volume)";
  }
  std::string source() const override {
    return "J. C. Maxwell Garnett, Phil. Trans. R. Soc. A 203, 385-420 (1904)";
  }
  bool has_host() const override { return true; }

  Permittivity mixed(std::span<const MixingPart> parts, std::size_t host) const override {
    const Permittivity outside = parts[host].permittivity;
    Permittivity polarisability = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (i == host) continue;
      const Permittivity inside = parts[i].permittivity;
      polarisability += parts[i].fraction * (inside - outside) / (inside + 2.0 * outside);
    }
    return outside * (1.0 + 2.0 * polarisability) / (1.0 - polarisability);
  }
};

KARAT_REGISTER(MixingRule, "maxwell-garnett", MaxwellGarnett);

}  // namespace
}  // namespace karat
