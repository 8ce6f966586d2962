#include "materials/fresnel_eval.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace karat {
namespace {

// The cosine by the sine of the complement: exactly 0 at 90 degrees, and accurate next to it.
double cosine(double theta_deg) {
  return std::sin((90.0 - theta_deg) * (std::numbers::pi / 180.0));
}

ComplexIndex relative(const FresnelQuery& query) {
  return {query.n / query.n_exterior, query.k / query.n_exterior};
}

// Evaluates queries through tables that a lattice full of their indices was prepared to.
class LatticeEvaluation {
 public:
  LatticeEvaluation(const FresnelModel& model, const std::vector<double>& values)
      : model_(model), index_(std::make_unique<LatticeIndex>()) {
    for (const double value : values) values_.emplace_back(static_cast<float>(value));
  }

  // How many queries from `first` on share a lattice: as many as it has places, where a model looks
  // at one wavelength at a time; otherwise those of one and the same material.
  std::size_t block(const std::vector<FresnelQuery>& queries, std::size_t first) const {
    if (model_.per_wavelength()) {
      return std::min<std::size_t>(kLatticeSize, queries.size() - first);
    }
    const ComplexIndex m = relative(queries[first]);
    std::size_t count = 1;
    for (; count < kLatticeSize && first + count < queries.size(); ++count) {
      const ComplexIndex other = relative(queries[first + count]);
      if (other.n != m.n || other.k != m.k) break;
    }
    return count;
  }

  // The rest of the lattice holds the last of them; each query is asked for at its own place.
  void evaluate(const std::vector<FresnelQuery>& queries, std::size_t first, std::size_t count,
                std::vector<FresnelModel::Scalar>& results) {
    for (std::size_t i = 0; i < kLatticeSize; ++i) {
      const ComplexIndex m = relative(queries[first + std::min(i, count - 1)]);
      const int phase = static_cast<int>(i) / kLanes, lane = static_cast<int>(i) % kLanes;
      index_->n[phase][lane] = static_cast<float>(m.n);
      index_->k[phase][lane] = static_cast<float>(m.k);
    }
    const FresnelTables tables =
        values_.empty() ? model_.prepare(*index_) : model_.prepare_with(*index_, values_);
    for (std::size_t i = 0; i < count; ++i) {
      const int phase = static_cast<int>(i) / kLanes, lane = static_cast<int>(i) % kLanes;
      const float cos_theta = static_cast<float>(cosine(queries[first + i].theta_deg));
      FresnelModel::Scalar result;
      result.unpolarised = double{model_.reflectance(tables, phase, cos_theta)[lane]};
      if (const auto apart = model_.polarised(tables, phase, cos_theta)) {
        result.s = double{apart->s[lane]};
        result.p = double{apart->p[lane]};
      }
      results.push_back(result);
    }
  }

 private:
  const FresnelModel& model_;
  std::unique_ptr<LatticeIndex> index_;
  std::vector<LatticeSpectrum> values_;
};

FresnelModel::Scalar in_double(const FresnelModel& model, const FresnelQuery& query,
                               const std::vector<double>& values) {
  const double c = cosine(query.theta_deg);
  if (values.empty()) return model.evaluate(relative(query), c);
  return {std::nullopt, std::nullopt, model.evaluate_with(relative(query), c, values)};
}

}  // namespace

std::vector<FresnelModel::Scalar> evaluate_fresnel(const FresnelModel& model,
                                                   const std::vector<FresnelQuery>& queries,
                                                   FresnelPrecision precision,
                                                   const std::vector<double>& values) {
  std::vector<FresnelModel::Scalar> results;
  results.reserve(queries.size());
  if (precision == FresnelPrecision::kDouble) {
    for (const FresnelQuery& query : queries) results.push_back(in_double(model, query, values));
    return results;
  }
  LatticeEvaluation lattice(model, values);
  while (results.size() < queries.size()) {
    const std::size_t first = results.size();
    lattice.evaluate(queries, first, lattice.block(queries, first), results);
  }
  return results;
}

}  // namespace karat
