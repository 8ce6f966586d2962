// The artist-friendly metal: reflectivity at normal incidence and one edge tint.
//
// With r = F0 and the edge tint g
//   n = g (1 - r)/(1 + r) + (1 - g)(1 + sqrt r)/(1 - sqrt r),  k^2 = (r (n + 1)^2 - (n - 1)^2)/(1 -
//   r),
// then the exact equations: Gulbrandsen, "Artist friendly metallic Fresnel", JCGT 3(4), 2014,
// 64-72, equations 5 and 6. Per wavelength this only renames n and k, and is exact. The
// approximation is what the model is used for: one g for a material. Here r is exact at every
// wavelength, and g is the one number of least squared error over the lattice's wavelengths and
// over angles spread evenly between 0 and 90 degrees. A stated edge tint may be a spectrum.
//
// The paper's g is in [0, 1]. Where n is below (1 - r)/(1 + r), a nearly transparent medium thinner
// than what surrounds it, n and k need a g above 1, and have one: 1 + n^2 for k = 0, at most 2.
#include "materials/fresnel_angles.h"
#include "materials/fresnel_parametric.h"

namespace karat {
namespace {

constexpr int kWavelengths = 32;  // of the lattice, for the fit
constexpr double kLargestTint = 2.0;

// What of n and k stays when only F0 is known: the ends between which g interpolates.
struct Reflectivity {
  double r, absorptance, least_n, largest_n;

  explicit Reflectivity(ComplexIndex index)
      : r(normal_incidence(index.n, index.k)),
        absorptance(std::max(normal_absorptance(index.n, index.k), 1e-12)),
        least_n(absorptance / (1.0 + r)),
        largest_n((1.0 + std::sqrt(r)) * (1.0 + std::sqrt(r)) / absorptance) {}

  double tint(double n) const {
    const double width = largest_n - least_n;
    return width > 0.0 ? std::clamp((largest_n - n) / width, 0.0, kLargestTint) : 1.0;
  }
  ComplexIndex index(double tint) const {
    const double n = std::max(tint * least_n + (1.0 - tint) * largest_n, 0.0);
    // What is left of a k of 0 by rounding would matter at a critical angle.
    const double square = (n + 1.0) * (n + 1.0);
    const double difference = r * square - (n - 1.0) * (n - 1.0);
    if (difference <= 1e-15 * square) return {n, 0.0};
    return {n, std::sqrt(difference / absorptance)};
  }
};

// The squared error that one g leaves at some wavelengths of a material.
class TintFit {
 public:
  explicit TintFit(const LatticeIndex& index) {
    for (int w = 0; w < kWavelengths; ++w) {
      const int place = w * (kLatticeSize / kWavelengths) + kLatticeSize / kWavelengths / 2;
      const int lane = place / kPhases, phase = place % kPhases;
      const ComplexIndex m{double{index.n[phase][lane]}, double{index.k[phase][lane]}};
      reflectivities_.emplace_back(m);
      own_tints_.push_back(reflectivities_.back().tint(m.n));
      wanted_.push_back(exact_at_fit_cosines(m));
    }
  }

  double best() const {
    // A material of one index has its tint, which the angles of the fit alone may leave open.
    const auto [least_own, largest_own] = std::minmax_element(own_tints_.begin(), own_tints_.end());
    if (*least_own == *largest_own) return *least_own;
    constexpr int kEven = 120;
    constexpr double kLast = 2.0 * kMiddle, kStep = kLast / kEven;
    double best = 0.0, error = squares(best);
    for (int i = 1; i <= kEven; ++i) {
      const double x = kStep * i, e = squares(x);
      if (e < error) best = x, error = e;
    }
    return tint(golden_section(std::max(best - kStep, 0.0), std::min(best + kStep, kLast)));
  }

 private:
  static constexpr double kMiddle = 20.0;

  // Metals crowd next to g = 1, where n is largest over 1 - g. The search therefore runs over x: g
  // = 1 - exp(-x) from 0 to 1, and from there to 2 by the same curve turned round.
  static double tint(double x) {
    return x < kMiddle ? 1.0 - std::exp(-x) : 1.0 + std::exp(x - 2.0 * kMiddle);
  }

  double squares(double x) const {
    double sum = 0.0;
    for (std::size_t w = 0; w < wanted_.size(); ++w) {
      const ComplexIndex m = reflectivities_[w].index(tint(x));
      for (std::size_t j = 0; j < kFitAngles; j += 2) {
        const double e = exact_scalar(m, fit_cosines()[j]).unpolarised - wanted_[w][j];
        sum += e * e;
      }
    }
    return sum;
  }

  double golden_section(double low, double high) const {
    const double ratio = 1.0 / std::numbers::phi;
    double a = high - ratio * (high - low), b = low + ratio * (high - low);
    double at_a = squares(a), at_b = squares(b);
    while (high - low > 1e-7) {
      if (at_a < at_b) {
        high = b, b = a, at_b = at_a;
        a = high - ratio * (high - low), at_a = squares(a);
      } else {
        low = a, a = b, at_a = at_b;
        b = low + ratio * (high - low), at_b = squares(b);
      }
    }
    return 0.5 * (low + high);
  }

  std::vector<Reflectivity> reflectivities_;
  std::vector<double> own_tints_;
  std::vector<FitAngles> wanted_;
};

class GulbrandsenFresnel final : public ParametricFresnel {
 public:
  std::string description() const override {
    return "exact equations for the n and k of F0 and one edge tint for the whole material";
  }
  std::string source() const override { return "Gulbrandsen 2014, JCGT 3(4), 64-72"; }
  bool per_wavelength() const override { return false; }
  std::vector<FresnelParameter> parameters() const override {
    return {{"edge_tint", "0: no absorption; 1: the least n of this reflectivity, above 1: less",
             0.0, kLargestTint, false}};
  }
  std::vector<double> chosen(ComplexIndex index) const override {
    return {Reflectivity(index).tint(index.n)};
  }

  // g of metals is next to 1, where a float of it would leave n inexact.
  FresnelTables prepare(const LatticeIndex& index) const override {
    const double tint = TintFit(index).best();
    return exact_tables(index, [&](double n, double k) {
      return Reflectivity({n, k}).index(tint);
    });
  }
  FresnelTables prepare_with(const LatticeIndex& index,
                             const std::vector<LatticeSpectrum>& values) const override {
    LatticeIndex substitute;
    for (int phase = 0; phase < kPhases; ++phase) {
      for (int i = 0; i < kLanes; ++i) {
        const Reflectivity r({double{index.n[phase][i]}, double{index.k[phase][i]}});
        const ComplexIndex m = r.index(double{values[0][phase][i]});
        substitute.n[phase][i] = static_cast<float>(m.n);
        substitute.k[phase][i] = static_cast<float>(m.k);
      }
    }
    return exact_tables(substitute, [](double n, double k) { return ComplexIndex{n, k}; });
  }

  SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                              float cos_theta) const override {
    return exact_reflectance(tables, phase, cos_theta);
  }

  double evaluate_with(ComplexIndex index, double cos_theta,
                       const std::vector<double>& values) const override {
    return exact_scalar(Reflectivity(index).index(values[0]), cos_theta).unpolarised;
  }
};

KARAT_REGISTER(FresnelModel, "gulbrandsen", GulbrandsenFresnel);

}  // namespace
}  // namespace karat
