#include "materials/fresnel_study/fresnel_on_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "materials/fresnel_study/fresnel_study.h"
#include "materials/index/index_coverage.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr int kAlbedoNodes = 64;

struct Quadrature {
  std::vector<double> nodes, weights;
};

// Gauss and Legendre on [0, 1]: roots of P_n by Newton's method from Tricomi's estimates; Davis and
// Rabinowitz, "Methods of Numerical Integration", section 2.7.
Quadrature gauss_legendre(int count) {
  Quadrature rule;
  for (int i = 0; i < count; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5)), slope = 0.0;
    for (int iteration = 0; iteration < 20; ++iteration) {
      double previous = 1.0, value = x;
      for (int n = 2; n <= count; ++n) {
        const double next = ((2 * n - 1) * x * value - (n - 1) * previous) / n;
        previous = value, value = next;
      }
      slope = count * (x * value - previous) / (x * x - 1.0);
      x -= value / slope;
    }
    rule.nodes.push_back(0.5 * (1.0 + x));
    rule.weights.push_back(1.0 / ((1.0 - x * x) * slope * slope));
  }
  return rule;
}

// By the sine of the complement: exactly 0 at 90 degrees, and accurate next to it.
double cosine(double angle_deg) {
  return std::sin((90.0 - angle_deg) * (std::numbers::pi / 180.0));
}

// `evaluate(cos_theta, values)` writes one value per wavelength.
template <typename F>
std::vector<double> albedo_of(std::size_t wavelengths, F&& evaluate) {
  static const Quadrature rule = gauss_legendre(kAlbedoNodes);
  std::vector<double> albedo(wavelengths), values(wavelengths);
  for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
    evaluate(rule.nodes[j], values.data());
    for (std::size_t i = 0; i < wavelengths; ++i) {
      albedo[i] += 2.0 * rule.weights[j] * rule.nodes[j] * values[i];
    }
  }
  return albedo;
}

}  // namespace

std::vector<ComplexIndex> indices_at(const IndexTable& table,
                                     const std::vector<double>& wavelengths_nm) {
  require_coverage(table, {wavelengths_nm.front(), wavelengths_nm.back()}, RangePolicy::kError);
  std::vector<ComplexIndex> indices;
  for (const double nm : wavelengths_nm) {
    const ComplexIndex index = table.at(nm);
    if (!(index.n > 0.0 && index.k >= 0.0)) {
      throw InputError(
          fmt::format("index table \"{}\": n = {:g}, k = {:g} at {:g} nm; n above 0 "
                      "and k at least 0 are needed",
                      table.provenance().name, index.n, index.k, nm));
    }
    indices.push_back(index);
  }
  return indices;
}

FresnelOnGrid::FresnelOnGrid(const FresnelModel& model, const IndexTable& table,
                             const std::vector<double>& wavelengths_nm)
    : model_(model) {
  tables_ = model.prepare(model.per_wavelength() ? packed(table, wavelengths_nm)
                                                 : spread(table, wavelengths_nm));
}

LatticeIndex FresnelOnGrid::packed(const IndexTable& table,
                                   const std::vector<double>& wavelengths_nm) {
  const std::size_t count = wavelengths_nm.size();
  if (count > kLatticeSize) {
    throw InputError(
        fmt::format("{} wavelengths; at most {} are allowed", count, int{kLatticeSize}));
  }
  const std::vector<ComplexIndex> indices = indices_at(table, wavelengths_nm);
  LatticeIndex lattice;
  for (std::size_t i = 0; i < kLatticeSize; ++i) {
    const ComplexIndex index = indices[std::min(i, count - 1)];
    const int phase = static_cast<int>(i) / kLanes, lane = static_cast<int>(i) % kLanes;
    lattice.n[phase][lane] = static_cast<float>(index.n);
    lattice.k[phase][lane] = static_cast<float>(index.k);
    if (i < count) places_.push_back({i, i, 0.0});
  }
  phases_ = (count + kLanes - 1) / kLanes;
  return lattice;
}

LatticeIndex FresnelOnGrid::spread(const IndexTable& table,
                                   const std::vector<double>& wavelengths_nm) {
  WavelengthRange range{wavelengths_nm.front(), wavelengths_nm.back()};
  require_coverage(table, range, RangePolicy::kError);
  if (is_covered(table.range(), kVisible)) {
    range.min_nm = std::min(range.min_nm, kVisible.min_nm);
    range.max_nm = std::max(range.max_nm, kVisible.max_nm);
  }
  const WavelengthLattice lattice(range);
  const auto slot_of = [](int bin) {  // bin `lane * kPhases + phase`
    return static_cast<std::size_t>(bin % kPhases) * kLanes +
           static_cast<std::size_t>(bin / kPhases);
  };
  for (const double nm : wavelengths_nm) {
    const double width = lattice.bin_width_nm();
    // Half a bin beyond the centres of the first and the last one the line through two goes on.
    const double bin = width > 0.0 ? (nm - range.min_nm) / width - 0.5 : 0.0;
    const int below = std::clamp(static_cast<int>(bin), 0, kLatticeSize - 2);
    places_.push_back({slot_of(below), slot_of(below + 1), bin - below});
  }
  phases_ = kPhases;
  return on_lattice(table, lattice);
}

void FresnelOnGrid::read(const std::vector<float>& slots, double* values) const {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto [slot, next, t] = places_[i];
    values[i] =
        t == 0.0 ? double{slots[slot]} : (1.0 - t) * double{slots[slot]} + t * double{slots[next]};
  }
}

void FresnelOnGrid::reflectance(double cos_theta, double* values) const {
  std::vector<float> slots(phases_ * kLanes);
  for (std::size_t phase = 0; phase < phases_; ++phase) {
    const SampledSpectrum r =
        model_.reflectance(tables_, static_cast<int>(phase), static_cast<float>(cos_theta));
    std::copy(r.lane.begin(), r.lane.end(),
              slots.begin() + static_cast<std::ptrdiff_t>(phase) * kLanes);
  }
  read(slots, values);
}

bool FresnelOnGrid::polarised(double cos_theta, double* s, double* p) const {
  std::vector<float> s_slots(phases_ * kLanes), p_slots(phases_ * kLanes);
  for (std::size_t phase = 0; phase < phases_; ++phase) {
    const auto apart =
        model_.polarised(tables_, static_cast<int>(phase), static_cast<float>(cos_theta));
    if (!apart) return false;
    const auto place = static_cast<std::ptrdiff_t>(phase) * kLanes;
    std::copy(apart->s.lane.begin(), apart->s.lane.end(), s_slots.begin() + place);
    std::copy(apart->p.lane.begin(), apart->p.lane.end(), p_slots.begin() + place);
  }
  read(s_slots, s), read(p_slots, p);
  return true;
}

FresnelCurves fresnel_curves(const FresnelModel& model, const IndexTable& table,
                             const FresnelGrid& grid) {
  const FresnelOnGrid prepared(model, table, grid.wavelengths_nm);
  const std::size_t wavelengths = grid.wavelengths_nm.size();
  FresnelCurves curves;
  curves.unpolarised.resize(grid.size()), curves.s.resize(grid.size()),
      curves.p.resize(grid.size());
  bool polarised = true;
  for (std::size_t a = 0; a < grid.angles_deg.size(); ++a) {
    const double c = cosine(grid.angles_deg[a]);
    prepared.reflectance(c, &curves.unpolarised[a * wavelengths]);
    polarised =
        polarised && prepared.polarised(c, &curves.s[a * wavelengths], &curves.p[a * wavelengths]);
  }
  if (!polarised) curves.s.clear(), curves.p.clear();
  curves.albedo =
      albedo_of(wavelengths, [&](double c, double* out) { prepared.reflectance(c, out); });
  return curves;
}

FresnelCurves exact_fresnel_curves(const IndexTable& table, const FresnelGrid& grid) {
  const FresnelModel& exact = *Registry<FresnelModel>::instance().find("exact");
  const std::vector<ComplexIndex> indices = indices_at(table, grid.wavelengths_nm);
  FresnelCurves curves;
  for (const double angle : grid.angles_deg) {
    for (const ComplexIndex index : indices) {
      const FresnelModel::Scalar r = exact.evaluate(index, cosine(angle));
      curves.unpolarised.push_back(r.unpolarised);
      curves.s.push_back(*r.s), curves.p.push_back(*r.p);
    }
  }
  curves.albedo = albedo_of(indices.size(), [&](double c, double* out) {
    for (std::size_t i = 0; i < indices.size(); ++i)
      out[i] = exact.evaluate(indices[i], c).unpolarised;
  });
  return curves;
}

}  // namespace karat
