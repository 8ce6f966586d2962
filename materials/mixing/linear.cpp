// The mean of the permittivities by volume: the upper bound of Wiener 1912, exact where the
// interfaces lie along the electric field, and the usual first guess for solid solutions.
#include "materials/mixing_rule.h"

namespace karat {
namespace {

class LinearMixing final : public MixingRule {
 public:
  std::string description() const override {
    return "mean of the permittivities by volume: sum f_i eps_i";
  }
  std::string source() const override {
    return "Wiener, Abh. Saechs. Ges. Wiss. 32, 509-604 (1912), upper bound";
  }
  Permittivity mixed(std::span<const MixingPart> parts, std::size_t) const override {
    Permittivity sum = 0.0;
    for (const MixingPart& part : parts) sum += part.fraction * part.permittivity;
    return sum;
  }
};

KARAT_REGISTER(MixingRule, "linear", LinearMixing);

}  // namespace
}  // namespace karat
