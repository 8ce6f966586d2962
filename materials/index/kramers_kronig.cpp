#include "materials/index/kramers_kronig.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "materials/index/nonnegative_least_squares.h"

namespace karat {
namespace {

// Distances of the outer nodes from the measured interval, as shares of its ends: close to the
// ends, where k acts most sharply, they are dense.
constexpr double kBelow[] = {0.98, 0.95, 0.90, 0.83, 0.74, 0.62,
                             0.48, 0.35, 0.22, 0.12, 0.05, 0.01};
constexpr double kAbove[] = {1.02, 1.05, 1.11, 1.2,  1.35, 1.6,  2.0,
                             2.8,  4.0,  7.0,  15.0, 40.0, 200.0};

// A logarithm whose pole is left out: at a node the poles of the two segments that meet there
// cancel, because k is continuous.
double log_of(double x, double scale) {
  return std::abs(x) < 1e-13 * scale ? 0.0 : std::log(std::abs(x));
}

// 2/pi P int w' k / (w'^2 - w^2) dw' over a segment in which k runs linearly from k0 to k1.
double segment(double e0, double k0, double e1, double k1, double w) {
  const double slope = (k1 - k0) / (e1 - e0), offset = k0 - slope * e0;
  const double minus = log_of(e1 - w, w) - log_of(e0 - w, w);
  const double plus = std::log((e1 + w) / (e0 + w));
  return (offset * (minus + plus) + slope * (2.0 * (e1 - e0) + w * (minus - plus))) /
         std::numbers::pi;
}

// What the hat function of node i adds to n at w.
double hat(const std::vector<double>& nodes, std::size_t i, double w) {
  double sum = 0.0;
  if (i > 0) sum += segment(nodes[i - 1], 0.0, nodes[i], 1.0, w);
  if (i + 1 < nodes.size()) sum += segment(nodes[i], 1.0, nodes[i + 1], 0.0, w);
  return sum;
}

// Nodes of k: outer ones below, the measured energies, outer ones above.
struct Nodes {
  std::vector<double> energy_ev;
  std::size_t first = 0, last = 0;  // of the measured ones
};

Nodes nodes_of(const std::vector<double>& measured) {
  Nodes nodes;
  for (auto it = std::rbegin(kBelow); it != std::rend(kBelow); ++it) {
    nodes.energy_ev.push_back(*it * measured.front());
  }
  nodes.first = nodes.energy_ev.size();
  nodes.energy_ev.insert(nodes.energy_ev.end(), measured.begin(), measured.end());
  nodes.last = nodes.energy_ev.size() - 1;
  for (const double share : kAbove) nodes.energy_ev.push_back(share * measured.back());
  return nodes;
}

// The measured k's own part of n - 1, with k falling linearly to 0 at the first outer nodes.
Eigen::VectorXd inner_part(const EnergyIndex& index, const Nodes& nodes, double scale) {
  const auto count = static_cast<Eigen::Index>(index.k.size());
  Eigen::VectorXd part = Eigen::VectorXd::Zero(count);
  for (Eigen::Index row = 0; row < count; ++row) {
    const double w = index.energy_ev[static_cast<std::size_t>(row)];
    const auto& e = nodes.energy_ev;
    double sum = segment(e[nodes.first - 1], 0.0, e[nodes.first], index.k.front(), w) +
                 segment(e[nodes.last], index.k.back(), e[nodes.last + 1], 0.0, w);
    for (std::size_t i = 0; i + 1 < index.k.size(); ++i) {
      sum += segment(index.energy_ev[i], index.k[i], index.energy_ev[i + 1], index.k[i + 1], w);
    }
    part[row] = scale * sum;
  }
  return part;
}

// Columns: the outer nodes, then absorption at energies far below and far above all of them.
Eigen::MatrixXd outer_parts(const EnergyIndex& index, const Nodes& nodes,
                            const std::vector<std::size_t>& outer) {
  const auto rows = static_cast<Eigen::Index>(index.energy_ev.size());
  const auto columns = static_cast<Eigen::Index>(outer.size());
  Eigen::MatrixXd parts(rows, columns + 2);
  const double lowest = index.energy_ev.front();
  for (Eigen::Index row = 0; row < rows; ++row) {
    const double w = index.energy_ev[static_cast<std::size_t>(row)];
    for (Eigen::Index j = 0; j < columns; ++j) {
      parts(row, j) = hat(nodes.energy_ev, outer[static_cast<std::size_t>(j)], w);
    }
    parts(row, columns) = -(lowest / w) * (lowest / w);
    parts(row, columns + 1) = 1.0;
  }
  return parts;
}

// Square roots of the shares of log energy that the rows stand for, divided by |1 + n + ik|.
Eigen::VectorXd root_weights(const EnergyIndex& index) {
  const std::vector<double>& energy = index.energy_ev;
  const std::size_t count = energy.size();
  Eigen::VectorXd weights(static_cast<Eigen::Index>(count));
  const double whole = std::log(energy.back() / energy.front());
  for (std::size_t i = 0; i < count; ++i) {
    const double low = energy[i == 0 ? 0 : i - 1], high = energy[std::min(i + 1, count - 1)];
    weights[static_cast<Eigen::Index>(i)] = std::sqrt(0.5 * std::log(high / low) / whole) /
                                            std::hypot(index.n[i] + 1.0, index.k[i], 1e-3);
  }
  return weights;
}

}  // namespace

KramersKronigFit kramers_kronig_fit(const EnergyIndex& index, double scale) {
  const Nodes nodes = nodes_of(index.energy_ev);
  std::vector<std::size_t> outer;
  for (std::size_t i = 0; i < nodes.energy_ev.size(); ++i) {
    if (i < nodes.first || i > nodes.last) outer.push_back(i);
  }
  const Eigen::VectorXd inner = inner_part(index, nodes, scale);
  const Eigen::MatrixXd parts = outer_parts(index, nodes, outer);
  const Eigen::VectorXd measured =
      Eigen::Map<const Eigen::VectorXd>(index.n.data(), static_cast<Eigen::Index>(index.n.size()));
  const Eigen::VectorXd wanted = (measured - inner).array() - 1.0;
  const Eigen::VectorXd weights = root_weights(index);
  const Eigen::VectorXd chosen = nonnegative_least_squares(
      weights.asDiagonal() * parts, (weights.array() * wanted.array()).matrix());
  const Eigen::VectorXd difference = wanted - parts * chosen;

  KramersKronigFit fit;
  for (Eigen::Index i = 0; i < difference.size(); ++i) {
    fit.n.push_back(measured[i] - difference[i]);
  }
  fit.rms = (weights.array() * difference.array()).matrix().norm();
  for (std::size_t j = 0; j < outer.size(); ++j) {
    fit.outer_energy_ev.push_back(nodes.energy_ev[outer[j]]);
    fit.outer_k.push_back(chosen[static_cast<Eigen::Index>(j)]);
  }
  return fit;
}

}  // namespace karat
