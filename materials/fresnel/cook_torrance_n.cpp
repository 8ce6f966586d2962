// The index recovered from the reflectance at normal incidence, without absorption.
//
// n = (1 + sqrt(F0)) / (1 - sqrt(F0)), k = 0, then the exact equations: Cook and Torrance, "A
// reflectance model for computer graphics", ACM TOG 1(1), 1982, section 5 ("The Fresnel equation",
// for when only F0 is known). An alternative to cook-torrance-k, never used together with it: the
// two recovered at once do not reflect F0. Exact where k = 0 and n >= 1; for n < 1 it is the medium
// 1/n, which has the same F0 and no total reflection.
#include "materials/fresnel_exact.h"
#include "materials/fresnel_terms.h"

namespace karat {
namespace {

class CookTorranceIndexFresnel final : public ExactFormFresnel {
 public:
  std::string description() const override {
    return "exact equations for n = (1 + sqrt F0) / (1 - sqrt F0), k = 0";
  }
  std::string source() const override {
    return "Cook and Torrance 1982, ACM Transactions on Graphics 1(1), section 5";
  }

  // 1 - sqrt(F0) as (1 - F0) / (1 + sqrt(F0)), which does not cancel. A material that reflects
  // all gets a large index.
  ComplexIndex substitute(ComplexIndex index) const override {
    const auto [n, k] = index;
    const double root = std::sqrt(normal_incidence(n, k));
    const double rest = std::max(normal_absorptance(n, k), 1e-12);
    return {(1.0 + root) * (1.0 + root) / rest, 0.0};
  }
};

KARAT_REGISTER(FresnelModel, "cook-torrance-n", CookTorranceIndexFresnel);

}  // namespace
}  // namespace karat
