#include "materials/multiple_scattering.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "materials/relative_index.h"
#include "materials/sampling.h"

namespace karat {
namespace {

// Directions where nothing is missing on average are still sampled a little.
constexpr double kDefensive = 0.02;
// Stands for the missing energy where it is none, so that nothing is divided by zero.
constexpr double kLeastMissing = 1e-9;

// Three numbers in [0, 1) from three that were used: the finalizer of SplitMix64 (Steele, Lea and
// Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014).
struct Mixed {
  float side;
  Vec2 direction;

  explicit Mixed(const BsdfNumbers& used) {
    const auto bits = [](float x) { return std::uint64_t{std::bit_cast<std::uint32_t>(x)}; };
    const std::uint64_t first = finalized(bits(used.direction.x) << 32 | bits(used.direction.y));
    const std::uint64_t second = finalized(first + bits(used.lobe) * 0x9e3779b97f4a7c15u);
    const std::uint64_t third = finalized(second + 0x9e3779b97f4a7c15u);
    side = unit(second >> 40);
    direction = {unit(third >> 40), unit(third & 0xffffffu)};
  }

 private:
  static std::uint64_t finalized(std::uint64_t x) {
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return x ^ x >> 31;
  }
  static float unit(std::uint64_t bits24) { return static_cast<float>(bits24) * 0x1p-24f; }
};

// Which shares of the light that a side traps cross in the end.
struct Crossing {
  double from_above, from_below;
};

// `above` and `below` are the mean shares of diffuse light from either side. Light that is trapped
// meets the surface again, as diffuse light of the side on which it is: a Markov chain with the
// states "trapped above" and "trapped below", and with a and b the probabilities of leaving above
// from either,
//   a = reflected_A + shadowed_A a + trapped_A b,  b = refracted_B + shadowed_B b + trapped_B a.
// The flow that crosses must be the same both ways (per n^2, see the head of the class); the two
// estimates of it agree but for the model's own approximations, and their mean is taken.
Crossing energy_shares(const FacetShares& above, const FacetShares& below, double missing_above,
                       double missing_below, double eta) {
  const double a_a = 1.0 - above.shadowed, b_b = 1.0 - below.shadowed;
  const double determinant = a_a * b_b - above.trapped * below.trapped;
  const double a = (above.reflected * b_b + above.trapped * below.refracted) / determinant;
  const double b = (below.refracted * a_a + below.trapped * above.reflected) / determinant;
  const auto over = [](double x, double y) { return x / std::max(y, kLeastMissing); };
  const double down = over(above.shadowed * (1.0 - a) + above.trapped * (1.0 - b), above.lost());
  const double up = over(below.shadowed * b + below.trapped * a, below.lost());
  const double weight_above = missing_above, weight_below = eta * eta * missing_below;
  const double flow =
      std::min({0.5 * (weight_above * down + weight_below * up), weight_above, weight_below});
  return {flow / weight_above, flow / weight_below};
}

MissingEnergy missing_from(const FacetQuadrature& quadrature, Vec2 alpha, Extremes eta) {
  return MissingEnergy(quadrature, alpha, eta.least, eta.largest);
}

}  // namespace

MultipleScattering::MultipleScattering(const Roughness& roughness, const LatticeSpectrum& eta,
                                       bool dispersive)
    : MultipleScattering(FacetQuadrature(roughness), roughness.alpha, eta, dispersive) {}

MultipleScattering::MultipleScattering(const FacetQuadrature& quadrature, Vec2 alpha,
                                       const LatticeSpectrum& eta, bool dispersive)
    : dispersive_(dispersive),
      above_{missing_from(quadrature, alpha, extremes(eta)), {}, {}},
      below_{missing_from(quadrature, alpha,
                          {1.0f / extremes(eta).largest, 1.0f / extremes(eta).least}),
             {},
             {}} {
  const auto [least, largest] = extremes(eta);
  for (int phase = 0; phase < kPhases; ++phase) {
    for (int lane = 0; lane < kLanes; ++lane) {
      if (!dispersive && phase + lane > 0) {
        copy_first(phase, lane);
      } else {
        share_out(phase, lane, double{eta[phase][lane]});
      }
    }
  }
  above_.prepare_sampling(double{least}, double{largest});
  below_.prepare_sampling(1.0 / double{largest}, 1.0 / double{least});
}

void MultipleScattering::share_out(int phase, int lane, double eta) {
  const double above = std::max(above_.missing.mean(eta), kLeastMissing);
  const double below = std::max(below_.missing.mean(1.0 / eta), kLeastMissing);
  const Crossing crossing = energy_shares(above_.missing.mean_shares(eta),
                                          below_.missing.mean_shares(1.0 / eta), above, below, eta);
  above_.crossing[phase][lane] = static_cast<float>(crossing.from_above);
  below_.crossing[phase][lane] = static_cast<float>(crossing.from_below);
  above_.inverse_missing[phase][lane] = static_cast<float>(1.0 / (M_PI * above));
  below_.inverse_missing[phase][lane] = static_cast<float>(1.0 / (M_PI * below));
}

void MultipleScattering::copy_first(int phase, int lane) {
  for (Side* side : {&above_, &below_}) {
    side->crossing[phase][lane] = side->crossing[0][0];
    side->inverse_missing[phase][lane] = side->inverse_missing[0][0];
  }
}

// The bounds crowd where what is missing changes fastest: at grazing and at the critical angle of
// the middle index.
void MultipleScattering::Side::prepare_sampling(double eta_least, double eta_largest) {
  constexpr int kIndices = 9;
  const auto eta = [&](int i) {
    return eta_least + (eta_largest - eta_least) * i / (kIndices - 1);
  };
  std::vector<double> missing_at, bounds{0.0};
  double sum = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    bounds.push_back(missing.cosine_of_fraction((step + 1.0) / kSteps, eta(kIndices / 2)));
    const double cosine = 0.5 * (bounds[bounds.size() - 2] + bounds.back());
    double mean = 0.0;
    for (int i = 0; i < kIndices; ++i) mean += missing.azimuthal_mean(cosine, eta(i)) / kIndices;
    missing_at.push_back(mean);
    sum += mean / kSteps;
  }
  const auto mass = [&](std::size_t i) {
    return (missing_at[i] + kDefensive * std::max(sum, kLeastMissing)) *
           (bounds[i + 1] * bounds[i + 1] - bounds[i] * bounds[i]);
  };
  double whole = 0.0, below = 0.0;
  for (std::size_t i = 0; i < kSteps; ++i) whole += mass(i);
  squares.push_back(0.0f), cumulative.push_back(0.0f);
  for (std::size_t i = 0; i < kSteps; ++i) {
    below += mass(i) / whole;
    squares.push_back(static_cast<float>(bounds[i + 1] * bounds[i + 1]));
    cumulative.push_back(static_cast<float>(below));
    const float width = squares[i + 1] - squares[i];
    density.push_back((cumulative[i + 1] - cumulative[i]) * kInvPi / std::max(width, 1e-30f));
  }
  cumulative.back() = 1.0f;
}

float MultipleScattering::Side::pdf(float cos_theta) const {
  const auto bound =
      std::upper_bound(squares.begin() + 1, squares.end() - 1, cos_theta * cos_theta);
  return density[static_cast<std::size_t>(bound - squares.begin() - 1)] * cos_theta;
}

MultipleScattering::Densities MultipleScattering::densities(const Vec3& wo, const Vec3& wi,
                                                            const SampledSpectrum& eta_o,
                                                            const SampledSpectrum& eta_i,
                                                            int phase) const {
  const Side &near = side(wo.z), &far = side(wi.z);
  const bool crosses = wo.z * wi.z < 0.0f;
  const float cosine = std::abs(wi.z), pdf = far.pdf(cosine);
  if (!dispersive_) {
    const float crossing = near.crossing[phase][0];
    const float lost = near.missing.at(wo, eta_o[0]) * (crosses ? crossing : 1.0f - crossing);
    return {SampledSpectrum(lost * far.missing.at(wi, eta_i[0]) * far.inverse_missing[phase][0] *
                            cosine),
            SampledSpectrum(lost * pdf)};
  }
  SampledSpectrum lost = near.missing.at(wo, eta_o);
  const SampledSpectrum& crossing = near.crossing[phase];
  lost *= crosses ? crossing : SampledSpectrum(1.0f) - crossing;
  return {lost * far.missing.at(wi, eta_i) * far.inverse_missing[phase] * cosine, lost * pdf};
}

Vec3 MultipleScattering::sample(const Vec3& wo, const BsdfNumbers& used, int phase,
                                int hero) const {
  const Mixed u(used);
  const bool crosses = u.side < side(wo.z).crossing[phase][hero];
  const Side& far = side(crosses ? -wo.z : wo.z);
  const auto bound =
      std::upper_bound(far.cumulative.begin() + 1, far.cumulative.end() - 1, u.direction.x);
  const auto i = static_cast<std::size_t>(bound - far.cumulative.begin()) - 1;
  const float part = (u.direction.x - far.cumulative[i]) /
                     std::max(far.cumulative[i + 1] - far.cumulative[i], 1e-30f);
  const float square = std::clamp(far.squares[i] + part * (far.squares[i + 1] - far.squares[i]),
                                  far.squares[i], far.squares[i + 1]);
  const float sine = std::sqrt(1.0f - square);
  const auto [s, c] = sin_cos_turns(u.direction.y);
  const float up = (wo.z > 0.0f) != crosses ? 1.0f : -1.0f;
  return {sine * c, sine * s, up * std::sqrt(square)};
}

}  // namespace karat
