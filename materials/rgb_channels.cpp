#include "materials/rgb_channels.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <map>
#include <mutex>
#include <vector>

#include "spectral/illuminant.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr WavelengthRange kColour{400.0, 700.0};

// The primaries are linear between nodes 10 nm apart, and constant outside them.
constexpr int kNodes = 41;
constexpr double kFirstNode = 380.0, kNodeStep = 10.0;

using Weights = std::array<std::array<double, kLatticeSize>, 3>;  // by lattice wavelength

double wavelength_nm(const WavelengthLattice& lattice, int place) {
  return lattice.wavelength_nm(place / kPhases, place % kPhases);
}

// What an illuminant of D65's power at a wavelength adds to each channel, 1 in sum.
Weights channel_weights(const WavelengthLattice& lattice) {
  const SpectrumPtr light = illuminant("D65");
  const Observer& eye = observer();
  Weights weights;
  std::array<double, 3> sums{};
  for (int place = 0; place < kLatticeSize; ++place) {
    const double nm = wavelength_nm(lattice, place);
    const bool seen = light->range().covers({nm, nm}) && eye.range.covers({nm, nm});
    const double power = seen ? (*light)(nm) : 0.0;
    const Rgb rgb =
        linear_srgb_of_xyz({(*eye.xbar)(nm)*power, (*eye.ybar)(nm)*power, (*eye.zbar)(nm)*power});
    for (std::size_t c = 0; c < 3; ++c) {
      weights[c][static_cast<std::size_t>(place)] = rgb[c];
      sums[c] += rgb[c];
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    for (double& w : weights[c]) w /= sums[c];
  }
  return weights;
}

// Which nodes a lattice wavelength lies between, and how far.
struct Place {
  int node;
  double t;
};
Place node_place(double nm) {
  const double x = std::clamp((nm - kFirstNode) / kNodeStep, 0.0, double{kNodes - 1});
  const int node = std::min(static_cast<int>(x), kNodes - 2);
  return {node, x - node};
}

// The values of two primaries at the nodes; the third is what is missing to 1. The sum of squared
// steps of all three is least, subject to the colours and to no primary being negative: a quadratic
// programme, solved by the primal-dual active set (Hintermueller, Ito and Kunisch 2002).
class SmoothestPrimaries {
 public:
  SmoothestPrimaries(const WavelengthLattice& lattice, const Weights& weights) {
    add_smoothness();
    add_colours(lattice, weights);
    add_signs();
  }

  // Row c, column node.
  Eigen::MatrixXd solve() const {
    std::vector<bool> active(static_cast<std::size_t>(signs_.rows()), false);
    Eigen::VectorXd x;
    for (int i = 0; i < kMostIterations; ++i) {
      const Eigen::VectorXd multipliers = solve_with(active, x);
      const Eigen::VectorXd slack = signs_ * x - sign_bounds_;
      bool changed = false;
      for (Eigen::Index r = 0; r < slack.size(); ++r) {
        const bool next = multipliers[r] - slack[r] > 1e-12;
        changed |= next != active[static_cast<std::size_t>(r)];
        active[static_cast<std::size_t>(r)] = next;
      }
      if (!changed) return values(x);
    }
    throw std::logic_error("no primaries for these wavelengths");
  }

 private:
  static constexpr Eigen::Index kUnknowns = 2 * kNodes;
  static constexpr int kMostIterations = 100;

  // The gradient of (sum of squared steps) / 2 of r, g and 1 - r - g.
  void add_smoothness() {
    Eigen::MatrixXd steps = Eigen::MatrixXd::Zero(kNodes, kNodes);
    for (int i = 0; i + 1 < kNodes; ++i) {
      steps(i, i) += 1.0, steps(i + 1, i + 1) += 1.0;
      steps(i, i + 1) -= 1.0, steps(i + 1, i) -= 1.0;
    }
    hessian_.resize(kUnknowns, kUnknowns);
    hessian_ << 2.0 * steps, steps, steps, 2.0 * steps;
  }

  void add_colours(const WavelengthLattice& lattice, const Weights& weights) {
    colours_ = Eigen::MatrixXd::Zero(6, kUnknowns);
    colour_values_ = Eigen::VectorXd::Zero(6);
    for (int primary = 0; primary < 2; ++primary) {
      for (int c = 0; c < 3; ++c) {
        const int row = 3 * primary + c;
        for (int place = 0; place < kLatticeSize; ++place) {
          const auto [node, t] = node_place(wavelength_nm(lattice, place));
          const double w = weights[static_cast<std::size_t>(c)][static_cast<std::size_t>(place)];
          colours_(row, primary * kNodes + node) += w * (1.0 - t);
          colours_(row, primary * kNodes + node + 1) += w * t;
        }
        colour_values_[row] = primary == c ? 1.0 : 0.0;
      }
    }
  }

  // r >= 0, g >= 0, -r - g >= -1.
  void add_signs() {
    signs_ = Eigen::MatrixXd::Zero(3 * kNodes, kUnknowns);
    sign_bounds_ = Eigen::VectorXd::Zero(3 * kNodes);
    for (int i = 0; i < kNodes; ++i) {
      signs_(i, i) = 1.0;
      signs_(kNodes + i, kNodes + i) = 1.0;
      signs_(2 * kNodes + i, i) = -1.0;
      signs_(2 * kNodes + i, kNodes + i) = -1.0;
      sign_bounds_[2 * kNodes + i] = -1.0;
    }
  }

  // The minimum where the active signs hold as equalities; returns the multipliers of all signs.
  Eigen::VectorXd solve_with(const std::vector<bool>& active, Eigen::VectorXd& x) const {
    std::vector<Eigen::Index> rows;
    for (std::size_t r = 0; r < active.size(); ++r) {
      if (active[r]) rows.push_back(static_cast<Eigen::Index>(r));
    }
    const auto equalities = static_cast<Eigen::Index>(rows.size()) + colours_.rows();
    Eigen::MatrixXd constraints(equalities, kUnknowns);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(kUnknowns + equalities);
    // The third primary's steps are those of -r - g: no linear term.
    constraints.topRows(colours_.rows()) = colours_;
    right.segment(kUnknowns, colours_.rows()) = colour_values_;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto at = colours_.rows() + static_cast<Eigen::Index>(i);
      constraints.row(at) = signs_.row(rows[i]);
      right[kUnknowns + at] = sign_bounds_[rows[i]];
    }
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(right.size(), right.size());
    system.topLeftCorner(kUnknowns, kUnknowns) = hessian_;
    system.topRightCorner(kUnknowns, equalities) = -constraints.transpose();
    system.bottomLeftCorner(equalities, kUnknowns) = constraints;
    const Eigen::VectorXd solution = system.colPivHouseholderQr().solve(right);
    x = solution.head(kUnknowns);
    Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(signs_.rows());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      multipliers[rows[i]] = solution[kUnknowns + colours_.rows() + static_cast<Eigen::Index>(i)];
    }
    return multipliers;
  }

  static Eigen::MatrixXd values(const Eigen::VectorXd& x) {
    Eigen::MatrixXd result(2, kNodes);
    result.row(0) = x.head(kNodes).transpose();
    result.row(1) = x.tail(kNodes).transpose();
    return result;
  }

  Eigen::MatrixXd hessian_, colours_, signs_;
  Eigen::VectorXd colour_values_, sign_bounds_;
};

}  // namespace

RgbChannels::RgbChannels(const WavelengthLattice& lattice) {
  if (!lattice.range().covers(kColour)) {
    throw InputError(fmt::format(
        "colour channels need wavelengths from {:g} to {:g} nm; the scene has {:g} to {:g} nm",
        kColour.min_nm, kColour.max_nm, lattice.range().min_nm, lattice.range().max_nm));
  }
  const Weights weights = channel_weights(lattice);
  const Eigen::MatrixXd nodes = SmoothestPrimaries(lattice, weights).solve();
  for (int place = 0; place < kLatticeSize; ++place) {
    const int lane = place / kPhases, phase = place % kPhases;
    const auto [node, t] = node_place(wavelength_nm(lattice, place));
    std::array<double, 3> value{0.0, 0.0, 1.0};
    for (int c = 0; c < 2; ++c) {
      const double v = nodes(c, node) * (1.0 - t) + nodes(c, node + 1) * t;
      value[static_cast<std::size_t>(c)] = std::clamp(v, 0.0, 1.0);
      value[2] -= value[static_cast<std::size_t>(c)];
    }
    for (std::size_t c = 0; c < 3; ++c) {
      primaries_[c][phase][lane] = static_cast<float>(std::max(value[c], 0.0));
      weights_[c][phase][lane] = static_cast<float>(weights[c][static_cast<std::size_t>(place)]);
    }
  }
}

Rgb RgbChannels::rgb(const LatticeSpectrum& spectrum) const {
  Rgb sums{}, norms{};
  for (std::size_t c = 0; c < 3; ++c) {
    for (int phase = 0; phase < kPhases; ++phase) {
      for (int i = 0; i < kLanes; ++i) {
        sums[c] += double{weights_[c][phase][i]} * double{spectrum[phase][i]};
        norms[c] += double{weights_[c][phase][i]};
      }
    }
    sums[c] /= norms[c];
  }
  return sums;
}

std::shared_ptr<const RgbChannels> RgbChannels::of(const WavelengthLattice& lattice) {
  static std::mutex mutex;
  static std::map<std::pair<double, double>, std::shared_ptr<const RgbChannels>> known;
  const std::scoped_lock lock(mutex);
  auto& entry = known[{lattice.range().min_nm, lattice.range().max_nm}];
  if (!entry) entry = std::make_shared<const RgbChannels>(lattice);
  return entry;
}

}  // namespace karat
