// Least squares with variables that are not negative.
#pragma once

#include <Eigen/Core>

namespace karat {

// The x >= 0 that minimises |A x - b|: C. L. Lawson and R. J. Hanson, "Solving Least Squares
// Problems" (1974), algorithm NNLS (23.10). Finite input; columns of A need not be independent.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace karat
