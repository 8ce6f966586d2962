#include "materials/fresnel_study/fresnel_fit_problem.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace karat {
namespace {

// Every choice of bounds is tried, three for each parameter.
constexpr std::size_t kMostLinear = 5;

// The z in [0, 1]^m with the least z' G z - 2 g' z. The objective is convex, so that it is the best
// of the points that satisfy the bounds among the least ones of each face.
Eigen::VectorXd least_in_unit_box(const Eigen::MatrixXd& gram, const Eigen::VectorXd& right) {
  const Eigen::Index m = right.size();
  double least = std::numeric_limits<double>::infinity();
  Eigen::VectorXd best = Eigen::VectorXd::Zero(m);
  for (int face = 0; face < std::pow(3, m); ++face) {
    Eigen::MatrixXd a = gram;
    Eigen::VectorXd b = right;
    int digits = face;
    for (Eigen::Index j = 0; j < m; ++j, digits /= 3) {
      if (digits % 3 == 0) continue;
      a.row(j).setZero();
      a(j, j) = 1.0, b[j] = digits % 3 - 1;
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(a);
    if (!lu.isInvertible()) continue;
    const Eigen::VectorXd z = lu.solve(b);
    if (!(z.minCoeff() >= 0.0 && z.maxCoeff() <= 1.0)) continue;
    const double value = z.dot(gram * z) - 2.0 * right.dot(z);
    if (value < least) least = value, best = z;
    if (face == 0) break;  // the least of all satisfies the bounds
  }
  return best;
}

}  // namespace

FitProblem::FitProblem(const FresnelModel& model, const FresnelData& data,
                       std::vector<std::size_t> free, const Values& start)
    : model_(model), data_(data), infos_(model.parameters()) {
  Values elsewhere = start;
  for (const std::size_t p : free) elsewhere[p] = value_at(p, 0.3);
  for (const std::size_t p : free) {
    const bool linear =
        linear_.size() < kMostLinear && linear_in(p, start) && linear_in(p, elsewhere);
    (linear ? linear_ : curved_).push_back(p);
  }
}

double FitProblem::value_at(std::size_t parameter, double place) const {
  const auto& [min, max] = std::pair(infos_[parameter].min, infos_[parameter].max);
  if (place <= 0.0) return min;
  if (place >= 1.0) return max;
  const double value = min > 0.0 ? min * std::pow(max / min, place) : min + (max - min) * place;
  return std::clamp(value, min, max);
}

double FitProblem::place_of(std::size_t parameter, double value) const {
  const auto& [min, max] = std::pair(infos_[parameter].min, infos_[parameter].max);
  return min > 0.0 ? std::log(value / min) / std::log(max / min) : (value - min) / (max - min);
}

// Straight along the parameter, at a slope that the linear ones found before leave as it is.
bool FitProblem::linear_in(std::size_t parameter, Values values) const {
  const FresnelParameter& info = infos_[parameter];
  const auto at = [&](double t) {
    values[parameter] = info.min + (info.max - info.min) * t;
    return residuals(values);
  };
  const std::vector<double> first = at(0.0), last = at(1.0);
  double scale = 0.0;
  for (std::size_t r = 0; r < count(); ++r) scale = std::max(scale, std::abs(last[r] - first[r]));
  if (!(scale > 1e-12)) return false;
  const auto differs = [&](const std::vector<double>& found, const auto& expected) {
    for (std::size_t r = 0; r < count(); ++r) {
      if (!(std::abs(found[r] - expected(r)) <= 1e-10 * (scale + 1.0))) return true;
    }
    return false;
  };
  for (const double t : {0.2, 0.5, 0.9}) {
    if (differs(at(t), [&](auto r) { return first[r] + t * (last[r] - first[r]); })) return false;
  }
  for (const std::size_t other : linear_) {
    const double before = values[other];
    values[other] = before == infos_[other].min ? infos_[other].max : infos_[other].min;
    const std::vector<double> lower = at(0.0), upper = at(1.0);
    if (differs(upper, [&](auto r) { return lower[r] + last[r] - first[r]; })) return false;
    values[other] = before;
  }
  return true;
}

void FitProblem::solve_linear(Values& values) const {
  if (linear_.empty()) return;
  for (const std::size_t p : linear_) values[p] = infos_[p].min;
  const std::vector<double> base = residuals(values);
  std::vector<std::vector<double>> columns;
  for (const std::size_t p : linear_) {
    values[p] = infos_[p].max;
    columns.push_back(residuals(values));
    std::transform(columns.back().begin(), columns.back().end(), base.begin(),
                   columns.back().begin(), std::minus<>());
    values[p] = infos_[p].min;
  }
  const auto product = [](const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  };
  const auto m = static_cast<Eigen::Index>(columns.size());
  Eigen::MatrixXd gram(m, m);
  Eigen::VectorXd right(m);
  for (Eigen::Index i = 0; i < m; ++i) {
    const std::vector<double>& column = columns[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < m; ++j) {
      gram(i, j) = product(column, columns[static_cast<std::size_t>(j)]);
    }
    right[i] = -product(column, base);
  }
  const Eigen::VectorXd z = least_in_unit_box(gram, right);
  for (Eigen::Index j = 0; j < m; ++j) {
    const std::size_t p = linear_[static_cast<std::size_t>(j)];
    const FresnelParameter& info = infos_[p];
    values[p] = z[j] == 1.0 ? info.max : info.min + (info.max - info.min) * z[j];
  }
}

void FitProblem::residuals(const Values& values, double* out) const {
  const double* wanted = data_.reflectances.data();
  for (const ComplexIndex& index : data_.indices) {
    for (const double c : data_.cosines) {
      *out++ = model_.evaluate_with(index, c, values) - *wanted++;
    }
  }
}

std::vector<double> FitProblem::residuals(const Values& values) const {
  std::vector<double> found(count());
  residuals(values, found.data());
  return found;
}

double FitProblem::squares(const Values& values) const {
  double sum = 0.0;
  for (const double r : residuals(values)) sum += r * r;
  return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

}  // namespace karat
