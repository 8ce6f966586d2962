#include "materials/fresnel_study/fresnel_fit.h"

#include <ceres/tiny_solver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "materials/fresnel_exact.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using Values = std::vector<double>;

// The free parameters as unbounded variables x, value = min + (max - min)(1 + sin x)/2, which keeps
// every value in its range and reaches both ends (James and Roos 1975, MINUIT).
class FreeParameters {
 public:
  FreeParameters(std::vector<FresnelParameter> infos, Values start,
                 const std::map<std::string, double>& fixed)
      : infos_(std::move(infos)), start_(std::move(start)) {
    for (std::size_t i = 0; i < infos_.size(); ++i) {
      if (!infos_[i].whole_number && fixed.count(infos_[i].name) == 0) free_.push_back(i);
    }
  }

  std::size_t count() const { return free_.size(); }

  Values values(const double* x) const {
    Values values = start_;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const FresnelParameter& info = infos_[free_[i]];
      const double middle = 0.5 * (info.min + info.max), half = 0.5 * (info.max - info.min);
      values[free_[i]] = std::clamp(middle + half * std::sin(x[i]), info.min, info.max);
    }
    return values;
  }

  // Not quite at the ends, where the sine has no slope.
  Eigen::VectorXd variables(const Values& values) const {
    constexpr double kNearEnd = 1.0 - 1e-7;
    Eigen::VectorXd x(static_cast<Eigen::Index>(free_.size()));
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const FresnelParameter& info = infos_[free_[i]];
      const double at = 2.0 * (values[free_[i]] - info.min) / (info.max - info.min) - 1.0;
      x[static_cast<Eigen::Index>(i)] = std::asin(std::clamp(at, -kNearEnd, kNearEnd));
    }
    return x;
  }

  // Starting points: every combination of a few values of each, in equal ratios where the range is
  // positive, in equal steps elsewhere.
  std::vector<Values> grid() const {
    const int steps = count() == 1 ? 40 : 12;
    std::vector<Values> points{start_};
    for (const std::size_t p : free_) {
      std::vector<Values> finer;
      for (const Values& point : points) {
        for (int i = 0; i <= steps; ++i) {
          finer.push_back(point);
          finer.back()[p] = on_scale(infos_[p], static_cast<double>(i) / steps);
        }
      }
      points = std::move(finer);
    }
    return points;
  }

 private:
  static double on_scale(const FresnelParameter& info, double t) {
    if (info.min > 0.0) return info.min * std::pow(info.max / info.min, t);
    return info.min + (info.max - info.min) * t;
  }

  std::vector<FresnelParameter> infos_;
  Values start_;
  std::vector<std::size_t> free_;
};

// Residuals, and their derivatives by central differences, as TinySolver wants them.
class Residuals {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

  Residuals(const FresnelModel& model, const FresnelData& data, const FreeParameters& free)
      : model_(model), data_(data), free_(free) {}

  int NumResiduals() const { return static_cast<int>(data_.reflectances.size()); }
  int NumParameters() const { return static_cast<int>(free_.count()); }

  bool operator()(const double* x, double* residuals, double* jacobian) const {
    evaluate(free_.values(x), residuals);
    if (!jacobian) return true;
    constexpr double kStep = 1e-6;
    const std::size_t rows = data_.reflectances.size();
    std::vector<double> above(rows), below(rows), moved(x, x + free_.count());
    for (std::size_t p = 0; p < free_.count(); ++p) {
      moved[p] = x[p] + kStep;
      evaluate(free_.values(moved.data()), above.data());
      moved[p] = x[p] - kStep;
      evaluate(free_.values(moved.data()), below.data());
      moved[p] = x[p];
      for (std::size_t r = 0; r < rows; ++r) {
        jacobian[p * rows + r] = (above[r] - below[r]) / (2.0 * kStep);
      }
    }
    return true;
  }

  void evaluate(const Values& values, double* residuals) const {
    for (const ComplexIndex& index : data_.indices) {
      for (const double c : data_.cosines) *residuals++ = model_.evaluate_with(index, c, values);
    }
    residuals -= data_.reflectances.size();
    for (const double wanted : data_.reflectances) *residuals++ -= wanted;
  }

  double squares(const Values& values) const {
    std::vector<double> residuals(data_.reflectances.size());
    evaluate(values, residuals.data());
    double sum = 0.0;
    for (const double r : residuals) sum += r * r;
    return sum;
  }

 private:
  const FresnelModel& model_;
  const FresnelData& data_;
  const FreeParameters& free_;
};

Values solved(const Residuals& residuals, const FreeParameters& free, const Values& start) {
  ceres::TinySolver<Residuals> solver;
  solver.options.max_num_iterations = 200;
  solver.options.gradient_tolerance = 1e-15;
  solver.options.parameter_tolerance = 1e-12;
  solver.options.function_tolerance = 1e-22;
  solver.options.cost_threshold = 1e-30;
  Eigen::VectorXd x = free.variables(start);
  solver.Solve(residuals, &x);
  return free.values(x.data());
}

// What the model would choose for the material in the middle of the data, with the fixed values.
Values start_values(const FresnelModel& model, const FresnelData& data,
                    const std::vector<FresnelParameter>& infos,
                    const std::map<std::string, double>& fixed) {
  Values values = model.chosen(data.indices[data.indices.size() / 2]);
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
  Values start = start_values(model, data, infos, fixed);
  const FreeParameters free(infos, start, fixed);
  if (free.count() == 0) return fresnel_residual(model, data, start);
  const Residuals residuals(model, data, free);

  std::vector<std::pair<double, Values>> starts;
  for (Values& point : free.grid()) {
    const double squares = residuals.squares(point);
    starts.emplace_back(squares, std::move(point));
  }
  constexpr std::size_t kTried = 2;
  std::partial_sort(starts.begin(), starts.begin() + kTried, starts.end());
  starts.resize(kTried);
  starts.emplace_back(residuals.squares(start), start);

  std::pair<double, Values> best = *std::min_element(starts.begin(), starts.end());
  for (const auto& [squares, point] : starts) {
    Values values = solved(residuals, free, point);
    const double left = residuals.squares(values);
    if (left < best.first) best = {left, std::move(values)};
  }
  return fresnel_residual(model, data, std::move(best.second));
}

}  // namespace karat
