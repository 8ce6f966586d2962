#include "materials/fresnel_study/fresnel_fit.h"

#include <ceres/tiny_solver.h>

#include <algorithm>
#include <cmath>

#include "materials/fresnel_exact.h"
#include "materials/fresnel_study/fresnel_fit_problem.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using Values = FitProblem::Values;

struct Candidate {
  double squares;
  Values values;

  bool operator<(const Candidate& other) const { return squares < other.squares; }
};

// Differences as a function of some curved parameters, the linear ones solved for, as TinySolver
// wants them. The variables x are unbounded, place = (1 + sin x)/2, which keeps every value in its
// range (James and Roos 1975, MINUIT); at the ends of the range the sine has no slope, so that they
// are searched by themselves.
class Residuals {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

  Residuals(const FitProblem& problem, const Values& base, const std::vector<std::size_t>& searched)
      : problem_(problem), base_(base), searched_(searched) {}

  int NumResiduals() const { return static_cast<int>(problem_.count()); }
  int NumParameters() const { return static_cast<int>(searched_.size()); }

  bool operator()(const double* x, double* residuals, double* jacobian) const {
    problem_.residuals(values(x), residuals);
    if (!jacobian) return true;
    constexpr double kStep = 1e-6;
    const std::size_t rows = problem_.count();
    std::vector<double> above(rows), below(rows), moved(x, x + searched_.size());
    for (std::size_t p = 0; p < searched_.size(); ++p) {
      moved[p] = x[p] + kStep;
      problem_.residuals(values(moved.data()), above.data());
      moved[p] = x[p] - kStep;
      problem_.residuals(values(moved.data()), below.data());
      moved[p] = x[p];
      for (std::size_t r = 0; r < rows; ++r) {
        jacobian[p * rows + r] = (above[r] - below[r]) / (2.0 * kStep);
      }
    }
    return true;
  }

  Values values(const double* x) const {
    Values values = base_;
    for (std::size_t i = 0; i < searched_.size(); ++i) {
      values[searched_[i]] = problem_.value_at(searched_[i], 0.5 + 0.5 * std::sin(x[i]));
    }
    problem_.solve_linear(values);
    return values;
  }

  Eigen::VectorXd variables(const Values& values, double from_ends) const {
    Eigen::VectorXd x(static_cast<Eigen::Index>(searched_.size()));
    for (std::size_t i = 0; i < searched_.size(); ++i) {
      const double place = problem_.place_of(searched_[i], values[searched_[i]]);
      x[static_cast<Eigen::Index>(i)] =
          std::asin(2.0 * std::clamp(place, from_ends, 1.0 - from_ends) - 1.0);
    }
    return x;
  }

 private:
  const FitProblem& problem_;
  const Values& base_;
  const std::vector<std::size_t>& searched_;
};

// The least sum of squares over some curved parameters, `base` giving the values of the others.
class Search {
 public:
  Search(const FitProblem& problem, Values base, std::vector<std::size_t> searched)
      : problem_(problem), base_(std::move(base)), searched_(std::move(searched)) {
    // At most about 700 points.
    const double even =
        std::pow(700.0, 1.0 / static_cast<double>(std::max<std::size_t>(1, searched_.size())));
    steps_ = std::clamp<std::size_t>(static_cast<std::size_t>(even), 2, 64);
  }

  // From the lowest local minima of the grid and from the other starts, and at the ends of every
  // range, which are searches with one parameter less.
  Candidate best(const std::vector<Values>& other_starts = {}) const {
    if (searched_.empty()) return with_linear(base_);
    std::vector<Candidate> starts;
    for (const Values& values : other_starts) starts.push_back(with_linear(values));
    keep_lowest(starts, 3);
    for (Candidate& minimum : local_minima()) starts.push_back(std::move(minimum));
    Candidate best = *std::min_element(starts.begin(), starts.end());
    for (const Candidate& start : starts) best = std::min(best, solved(start));
    for (std::size_t i = 0; i < searched_.size(); ++i) {
      for (const double end : {0.0, 1.0}) best = std::min(best, with_held(i, end).best());
    }
    return best;
  }

 private:
  static void keep_lowest(std::vector<Candidate>& candidates, std::size_t most) {
    std::sort(candidates.begin(), candidates.end());
    if (candidates.size() > most) candidates.resize(most);
  }

  Candidate with_linear(Values values) const {
    problem_.solve_linear(values);
    return {problem_.squares(values), values};
  }

  Search with_held(std::size_t i, double place) const {
    Values base = base_;
    base[searched_[i]] = problem_.value_at(searched_[i], place);
    std::vector<std::size_t> rest = searched_;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    return {problem_, std::move(base), std::move(rest)};
  }

  // Points of an even grid over all searched parameters that no neighbour along an axis is below.
  std::vector<Candidate> local_minima() const {
    const std::size_t side = steps_ + 1;
    std::vector<Candidate> grid, minima;
    std::size_t total = 1;
    for (std::size_t i = 0; i < searched_.size(); ++i) total *= side;
    for (std::size_t point = 0; point < total; ++point) {
      Values values = base_;
      for (std::size_t i = 0, digits = point; i < searched_.size(); ++i, digits /= side) {
        const double place = static_cast<double>(digits % side) / static_cast<double>(steps_);
        values[searched_[i]] = problem_.value_at(searched_[i], place);
      }
      grid.push_back(with_linear(std::move(values)));
    }
    for (std::size_t point = 0; point < total; ++point) {
      bool lowest = true;
      for (std::size_t stride = 1; stride < total; stride *= side) {
        const std::size_t digit = point / stride % side;
        lowest &= digit == 0 || !(grid[point - stride] < grid[point]);
        lowest &= digit == steps_ || !(grid[point + stride] < grid[point]);
      }
      if (lowest) minima.push_back(grid[point]);
    }
    constexpr std::size_t kMostMinima = 8;
    keep_lowest(minima, kMostMinima);
    return minima;
  }

  Candidate solved(const Candidate& start) const {
    const Residuals residuals(problem_, base_, searched_);
    ceres::TinySolver<Residuals> solver;
    solver.options.max_num_iterations = 100;
    solver.options.gradient_tolerance = 1e-15;
    solver.options.parameter_tolerance = 1e-12;
    solver.options.function_tolerance = 1e-22;
    solver.options.cost_threshold = 1e-30;
    Eigen::VectorXd x =
        residuals.variables(start.values, std::min(1e-3, 0.25 / static_cast<double>(steps_)));
    solver.Solve(residuals, &x);
    Values values = residuals.values(x.data());
    return {problem_.squares(values), values};
  }

  const FitProblem& problem_;
  Values base_;
  std::vector<std::size_t> searched_;
  std::size_t steps_;
};

// What the model would choose for a material of this index, with the fixed values.
Values start_values(const FresnelModel& model, ComplexIndex index,
                    const std::vector<FresnelParameter>& infos,
                    const std::map<std::string, double>& fixed) {
  Values values = model.chosen(index);
  std::vector<std::string> known;
  for (const FresnelParameter& info : infos) known.push_back(info.name);
  for (const auto& [name, value] : fixed) {
    const auto it = std::find(known.begin(), known.end(), name);
    if (it == known.end()) throw InputError(unknown_name_message("parameter", name, known));
    const auto i = static_cast<std::size_t>(it - known.begin());
    const std::string error = parameter_error(infos[i], value);
    if (!error.empty()) throw InputError("", name, error);
    values[i] = value;
  }
  return values;
}

}  // namespace

FresnelData exact_data(std::vector<ComplexIndex> indices, std::vector<double> cosines) {
  FresnelData data{std::move(indices), std::move(cosines), {}};
  for (const ComplexIndex& index : data.indices) {
    for (const double c : data.cosines) {
      data.reflectances.push_back(exact_scalar(index, c).unpolarised);
    }
  }
  return data;
}

FresnelFit fresnel_residual(const FresnelModel& model, const FresnelData& data,
                            std::vector<double> values) {
  FresnelFit fit{std::move(values), 0.0, 0.0};
  auto wanted = data.reflectances.begin();
  for (const ComplexIndex& index : data.indices) {
    for (const double c : data.cosines) {
      const double error = model.evaluate_with(index, c, fit.values) - *wanted++;
      fit.max_abs_error = std::max(fit.max_abs_error, std::abs(error));
      fit.rms_error += error * error;
    }
  }
  fit.rms_error = std::sqrt(fit.rms_error / static_cast<double>(data.reflectances.size()));
  return fit;
}

FresnelFit fit_fresnel(const FresnelModel& model, const FresnelData& data,
                       const std::map<std::string, double>& fixed) {
  const std::vector<FresnelParameter> infos = model.parameters();
  const auto start_for = [&](std::size_t i) {
    return start_values(model, data.indices[i], infos, fixed);
  };
  const Values start = start_for(data.indices.size() / 2);
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < infos.size(); ++i) {
    if (!infos[i].whole_number && fixed.count(infos[i].name) == 0) free.push_back(i);
  }
  if (free.empty()) return fresnel_residual(model, data, start);

  const FitProblem problem(model, data, std::move(free), start);
  std::vector<Values> starts;
  for (std::size_t i = 0; i < data.indices.size(); i += 1 + data.indices.size() / 32) {
    starts.push_back(start_for(i));
    for (std::size_t p = 0; p < infos.size(); ++p) {
      if (infos[p].whole_number) starts.back()[p] = start[p];
    }
  }
  const Candidate found = Search(problem, start, problem.curved()).best(starts);
  return fresnel_residual(model, data,
                          problem.squares(start) <= found.squares ? start : found.values);
}

}  // namespace karat
