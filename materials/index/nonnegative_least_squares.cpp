#include "materials/index/nonnegative_least_squares.h"

#include <Eigen/QR>
#include <algorithm>
#include <vector>

namespace karat {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The unconstrained solution over the columns in `passive`, zero elsewhere.
VectorXd solution_over(const MatrixXd& a, const VectorXd& b, const std::vector<bool>& passive) {
  std::vector<Index> columns;
  for (Index j = 0; j < a.cols(); ++j) {
    if (passive[static_cast<std::size_t>(j)]) columns.push_back(j);
  }
  VectorXd x = VectorXd::Zero(a.cols());
  if (columns.empty()) return x;
  MatrixXd part(a.rows(), static_cast<Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j) {
    part.col(static_cast<Index>(j)) = a.col(columns[j]);
  }
  const VectorXd solved = part.colPivHouseholderQr().solve(b);
  for (std::size_t j = 0; j < columns.size(); ++j) x[columns[j]] = solved[static_cast<Index>(j)];
  return x;
}

// Moves x towards `wanted` until a variable reaches 0, which leaves the passive set. True where
// none had to.
bool step_within_bounds(VectorXd& x, const VectorXd& wanted, std::vector<bool>& passive) {
  double share = 1.0;
  for (Index j = 0; j < x.size(); ++j) {
    if (passive[static_cast<std::size_t>(j)] && wanted[j] <= 0.0) {
      share = std::min(share, x[j] / (x[j] - wanted[j]));
    }
  }
  if (share >= 1.0) {
    x = wanted;
    return true;
  }
  x += share * (wanted - x);
  for (Index j = 0; j < x.size(); ++j) {
    if (passive[static_cast<std::size_t>(j)] && wanted[j] <= 0.0 && x[j] <= 1e-14 * x.maxCoeff()) {
      x[j] = 0.0;
      passive[static_cast<std::size_t>(j)] = false;
    }
  }
  return false;
}

}  // namespace

VectorXd nonnegative_least_squares(const MatrixXd& a, const VectorXd& b) {
  VectorXd x = VectorXd::Zero(a.cols());
  std::vector<bool> passive(static_cast<std::size_t>(a.cols()), false);
  const double tolerance = 1e-12 * (a.transpose() * b).cwiseAbs().maxCoeff();
  for (Index round = 0; round < 10 * a.cols(); ++round) {
    const VectorXd gradient = a.transpose() * (b - a * x);
    Index best = -1;
    for (Index j = 0; j < a.cols(); ++j) {
      if (passive[static_cast<std::size_t>(j)] || !(gradient[j] > tolerance)) continue;
      if (best < 0 || gradient[j] > gradient[best]) best = j;
    }
    if (best < 0) break;
    passive[static_cast<std::size_t>(best)] = true;
    for (Index inner = 0; inner < a.cols(); ++inner) {
      if (step_within_bounds(x, solution_over(a, b, passive), passive)) break;
    }
  }
  return x;
}

}  // namespace karat
