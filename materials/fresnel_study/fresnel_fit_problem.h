// The least-squares problem behind a fit. Parameters in which the model is linear are solved for,
// so that only the others are searched (variable projection: Golub and Pereyra 1973,
// 10.1137/0710036).
#pragma once

#include "materials/fresnel_study/fresnel_fit.h"

namespace karat {

class FitProblem {
 public:
  using Values = std::vector<double>;  // in the order of the model's parameters()

  // Finds out in which of the `free` parameters, as places in that order, the model is linear:
  // everywhere, whatever the others are. `model` and `data` must outlive the problem.
  FitProblem(const FresnelModel& model, const FresnelData& data, std::vector<std::size_t> free,
             const Values& start);

  std::size_t count() const { return data_.reflectances.size(); }
  const std::vector<std::size_t>& curved() const { return curved_; }
  const std::vector<std::size_t>& linear() const { return linear_; }

  // The value at a place from 0 to 1 in a parameter's range, and back: in equal ratios where the
  // range is positive, in equal steps elsewhere. Exact at both ends.
  double value_at(std::size_t parameter, double place) const;
  double place_of(std::size_t parameter, double value) const;

  // Gives the linear parameters, within their ranges, the values of least squares.
  void solve_linear(Values& values) const;

  // count() differences, the model's value less the wanted one, and the sum of their squares:
  // infinite where the model gives no number.
  void residuals(const Values& values, double* out) const;
  double squares(const Values& values) const;

 private:
  bool linear_in(std::size_t parameter, Values values) const;
  std::vector<double> residuals(const Values& values) const;

  const FresnelModel& model_;
  const FresnelData& data_;
  std::vector<FresnelParameter> infos_;
  std::vector<std::size_t> linear_, curved_;
};

}  // namespace karat
