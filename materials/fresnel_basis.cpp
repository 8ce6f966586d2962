#include "materials/fresnel_basis.h"

#include <Eigen/Dense>
#include <cmath>

#include "materials/fresnel_exact.h"
#include "materials/fresnel_terms.h"

namespace karat {
namespace {

double in_equal_ratios(double first, double last, int i, int count) {
  return first * std::pow(last / first, static_cast<double>(i) / (count - 1));
}

// Reflectances of the training set minus F0, one column each, and 1 - F0.
struct Training {
  Eigen::MatrixXd rises;
  Eigen::VectorXd absorptances;

  Training() {
    const auto indices = FresnelBasis::training_set();
    const auto count = static_cast<Eigen::Index>(indices.size());
    rises.resize(FresnelBasis::kNodes, count);
    absorptances.resize(count);
    for (Eigen::Index m = 0; m < count; ++m) {
      const ComplexIndex index = indices[static_cast<std::size_t>(m)];
      absorptances[m] = normal_absorptance(index.n, index.k);
      for (int j = 0; j < FresnelBasis::kNodes; ++j) {
        const double r = exact_scalar(index, FresnelBasis::node_cosine(j)).unpolarised;
        rises(j, m) = r - normal_incidence(index.n, index.k);
      }
    }
  }
};

// The left singular vectors of the largest singular values, largest first.
Eigen::MatrixXd singular_vectors(const Eigen::MatrixXd& curves, Eigen::Index count) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(curves * curves.transpose());
  return solver.eigenvectors().rightCols(count).rowwise().reverse();
}

}  // namespace

const FresnelBasis& FresnelBasis::instance() {
  static const FresnelBasis basis;
  return basis;
}

double FresnelBasis::node_cosine(int node) {
  const double u = static_cast<double>(node) / (kNodes - 1);
  return u / (4.0 - 3.0 * u);
}

std::vector<ComplexIndex> FresnelBasis::training_set() {
  constexpr int kCount = 12;
  std::vector<ComplexIndex> indices;
  for (int i = 0; i < kCount; ++i) {
    for (int j = 0; j < kCount; ++j) {
      indices.push_back(
          {in_equal_ratios(0.05, 5.0, i, kCount), in_equal_ratios(0.5, 10.0, j, kCount)});
    }
    indices.push_back({in_equal_ratios(1.1, 3.0, i, kCount), 0.0});
  }
  return indices;
}

FresnelBasis::FresnelBasis() {
  const Training training;
  const Eigen::MatrixXd normalised =
      training.rises * training.absorptances.cwiseInverse().asDiagonal();
  Eigen::VectorXd b1 = singular_vectors(normalised, 1).col(0);
  b1 /= b1[0];
  const Eigen::MatrixXd residual = training.rises - b1 * training.absorptances.transpose();
  Eigen::MatrixXd rest = singular_vectors(residual, 2);
  for (Eigen::Index c = 0; c < 2; ++c) {
    Eigen::Index largest = 0;
    rest.col(c).cwiseAbs().maxCoeff(&largest);
    rest.col(c) /= rest(largest, c);
  }
  // What the ends are but for rounding.
  b1[kNodes - 1] = 0.0;
  rest.row(0).setZero();
  rest.row(kNodes - 1).setZero();
  double independent = 0.0;
  for (int i = 0; i < kNodes; ++i) {
    nodes_[static_cast<std::size_t>(i)] = {static_cast<float>(b1[i]),
                                           static_cast<float>(rest(i, 0)),
                                           static_cast<float>(rest(i, 1)), 0.0f};
    for (int j = 0; j < i; ++j) {
      const double determinant = std::abs(rest(i, 0) * rest(j, 1) - rest(i, 1) * rest(j, 0));
      if (!(determinant > independent)) continue;
      independent = determinant;
      matching_ = {node_cosine(i), node_cosine(j)};
    }
  }
}

std::array<double, 2> FresnelBasis::matched(ComplexIndex index) const {
  const double f0 = normal_incidence(index.n, index.k);
  std::array<Values<double>, 2> b{};
  std::array<double, 2> rest{};
  for (std::size_t i = 0; i < 2; ++i) {
    b[i] = at(matching_[i]);
    rest[i] = exact_scalar(index, matching_[i]).unpolarised - f0 -
              normal_absorptance(index.n, index.k) * b[i].b1;
  }
  const double determinant = b[0].b2 * b[1].b3 - b[0].b3 * b[1].b2;
  return {(rest[0] * b[1].b3 - rest[1] * b[0].b3) / determinant,
          (rest[1] * b[0].b2 - rest[0] * b[1].b2) / determinant};
}

}  // namespace karat
