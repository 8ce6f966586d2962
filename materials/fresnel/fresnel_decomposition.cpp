// Reflectance as a sum of few functions of the angle alone.
//
// R = F0 + (1 - F0) b1(c) + c2 b2(c) + c3 b3(c): Belcour, Bati and Barla, "Bringing an accurate
// Fresnel to real-time rendering: a preintegrable decomposition", SIGGRAPH 2020 courses,
// 10.1145/3388767.3407325. b1 is the first singular vector of the curves (R - F0)/(1 - F0) of
// metals and transparent media, b2 and b3 are those of what it leaves. The published basis is not
// at hand: materials/fresnel_basis.cpp computes one from a stated training set. c2 and c3 make R
// exact at two matching angles per wavelength; it is exact at 0 and 90 degrees too. The sum may
// leave [0, 1] far from the training set.
#include "materials/fresnel_basis.h"
#include "materials/fresnel_parametric.h"

namespace karat {
namespace {

class FresnelDecomposition final : public ParametricFresnel {
 public:
  std::string description() const override {
    return "F0 + (1 - F0) b1 + c2 b2 + c3 b3, exact at 0, 90 and two more angles";
  }
  std::string source() const override {
    return "Belcour, Bati and Barla 2020, 10.1145/3388767.3407325; basis computed here";
  }
  std::vector<FresnelParameter> parameters() const override {
    return {{"c2", "weight of the second function", -10.0, 10.0, false},
            {"c3", "weight of the third function", -10.0, 10.0, false}};
  }
  std::vector<double> chosen(ComplexIndex index) const override {
    const auto [c2, c3] = FresnelBasis::instance().matched(index);
    return {std::clamp(c2, -10.0, 10.0), std::clamp(c3, -10.0, 10.0)};
  }

  // The nodes of the basis lie behind the parameters, four lanes each: to ask for instance() in the
  // loop would take longer than all the rest.
  FresnelTables prepare_with(const LatticeIndex& index,
                             const std::vector<LatticeSpectrum>& values) const override {
    static_assert(4 * FresnelBasis::kNodes <= kLatticeSize && kLanes % 4 == 0);
    FresnelTables tables = ParametricFresnel::prepare_with(index, values);
    LatticeSpectrum& plane = tables.planes.emplace_back(0.0f);
    const auto& nodes = FresnelBasis::instance().nodes();
    for (unsigned j = 0; j < FresnelBasis::kNodes; ++j) {
      std::copy(nodes[j].begin(), nodes[j].end(), &plane[phase_of(j)][lane_of(j)]);
    }
    return tables;
  }

  SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                              float cos_theta) const override {
    const SampledSpectrum& f0 = tables.planes[0][phase];
    const SampledSpectrum& c2 = tables.planes[1][phase];
    const SampledSpectrum& c3 = tables.planes[2][phase];
    const auto [below, fraction] = FresnelBasis::place(cos_theta);
    const LatticeSpectrum& plane = tables.planes[3];
    const float* a = plane[phase_of(below)].lane.data() + lane_of(below);
    const float* b = plane[phase_of(below + 1)].lane.data() + lane_of(below + 1);
    const float t = fraction;
    alignas(16) float basis[4];
#pragma omp simd
    for (int i = 0; i < 4; ++i) basis[i] = a[i] + (b[i] - a[i]) * t;
    const float first = basis[0], second = basis[1], third = basis[2];
    SampledSpectrum r;
    for (int i = 0; i < kLanes; ++i) {
      r[i] = f0[i] + (1.0f - f0[i]) * first + c2[i] * second + c3[i] * third;
    }
    return r;
  }

  double evaluate_with(ComplexIndex index, double cos_theta,
                       const std::vector<double>& values) const override {
    const double f0 = normal_incidence(index.n, index.k);
    const auto b = FresnelBasis::instance().at(cos_theta);
    return f0 + (1.0 - f0) * b.b1 + values[0] * b.b2 + values[1] * b.b3;
  }

 private:
  // Where in a plane the four lanes of a node begin.
  static int phase_of(unsigned node) { return static_cast<int>(4 * node / kLanes); }
  static int lane_of(unsigned node) { return static_cast<int>(4 * node % kLanes); }
};

KARAT_REGISTER(FresnelModel, "fresnel-decomposition", FresnelDecomposition);

}  // namespace
}  // namespace karat
