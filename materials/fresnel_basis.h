// The three functions of angle from which the model "fresnel-decomposition" is made.
#pragma once

#include <algorithm>
#include <array>

#include "materials/index/index_table.h"

namespace karat {

// b1 is 0 at normal and 1 at grazing incidence; b2 and b3 are 0 at both ends and at most 1 in
// magnitude. Linear in u = 4 c / (1 + 3 c) between 128 nodes.
class FresnelBasis {
 public:
  static constexpr int kNodes = 128;

  // Computed on first use (some 10 ms), then shared; safe from any thread.
  static const FresnelBasis& instance();

  template <typename Real>
  struct Values {
    Real b1, b2, b3;
  };
  // b1, b2, b3 and a 0, so that four lanes hold a node.
  using Node = std::array<float, 4>;
  const std::array<Node, kNodes>& nodes() const { return nodes_; }

  // Between which nodes a cosine lies: `below` and the next one.
  template <typename Real>
  struct Place {
    unsigned below;
    Real fraction;
  };
  template <typename Real>
  static Place<Real> place(Real cos_theta) {
    const Real u = Real(kNodes - 1) * Real(4) * cos_theta / (Real(1) + Real(3) * cos_theta);
    const int below = std::min(static_cast<int>(u), kNodes - 2);
    return {static_cast<unsigned>(below), u - static_cast<Real>(below)};
  }
  template <typename Real>
  Values<Real> at(Real cos_theta) const {
    const auto [below, t] = place(cos_theta);
    const auto mix = [&, t = t](const Node& a, const Node& b, std::size_t i) {
      const Real first = static_cast<Real>(a[i]);
      return first + (static_cast<Real>(b[i]) - first) * t;
    };
    const Node &a = nodes_[below], &b = nodes_[below + 1];
    return {mix(a, b, 0), mix(a, b, 1), mix(a, b, 2)};
  }

  // Where c2 and c3 are matched: the cosines of the two nodes at which b2 and b3 are most
  // independent of each other.
  const std::array<double, 2>& matching_cosines() const { return matching_; }

  // c2 and c3 with which F0 + (1 - F0) b1 + c2 b2 + c3 b3 is exact at both.
  std::array<double, 2> matched(ComplexIndex index) const;

  // What the basis is computed from: 12 x 12 metals, n from 0.05 to 5 and k from 0.5 to 10, and 12
  // transparent media, n from 1.1 to 3, all in equal ratios.
  static std::vector<ComplexIndex> training_set();
  static double node_cosine(int node);

 private:
  FresnelBasis();

  std::array<Node, kNodes> nodes_;
  std::array<double, 2> matching_{};
};

}  // namespace karat
