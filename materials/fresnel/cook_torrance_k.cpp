// The extinction recovered from the reflectance at normal incidence.
//
// n = 1, k = 2 sqrt(F0 / (1 - F0)), then the exact equations: Cook and Torrance, "A reflectance
// model for computer graphics", ACM TOG 1(1), 1982, section 5 ("The Fresnel equation", for when
// only F0 is known). An alternative to cook-torrance-n, never used together with it: the two
// recovered at once do not reflect F0. Exact where n = 1.
#include "materials/fresnel_exact.h"
#include "materials/fresnel_terms.h"

namespace karat {
namespace {

class CookTorranceExtinctionFresnel final : public ExactFormFresnel {
 public:
  std::string description() const override {
    return "exact equations for n = 1, k = 2 sqrt(F0 / (1 - F0))";
  }
  std::string source() const override {
    return "Cook and Torrance 1982, ACM Transactions on Graphics 1(1), section 5";
  }

  // 1 - F0 is computed apart, as next to 1 the difference cancels. A material that reflects all
  // gets a large extinction.
  ComplexIndex substitute(ComplexIndex index) const override {
    const auto [n, k] = index;
    const double rest = std::max(normal_absorptance(n, k), 1e-12);
    return {1.0, 2.0 * std::sqrt(normal_incidence(n, k) / rest)};
  }
};

KARAT_REGISTER(FresnelModel, "cook-torrance-k", CookTorranceExtinctionFresnel);

}  // namespace
}  // namespace karat
