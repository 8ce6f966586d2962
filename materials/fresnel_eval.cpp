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

// Fills a lattice with the queries from `first` on (its rest with the last of them), and asks for
// each at its own place.
void evaluate_block(const FresnelModel& model, const std::vector<FresnelQuery>& queries,
                    std::size_t first, std::vector<FresnelModel::Scalar>& results) {
  const std::size_t count = std::min<std::size_t>(kLatticeSize, queries.size() - first);
  const auto index = std::make_unique<LatticeIndex>();
  for (std::size_t i = 0; i < kLatticeSize; ++i) {
    const ComplexIndex m = relative(queries[first + std::min(i, count - 1)]);
    const int phase = static_cast<int>(i) / kLanes, lane = static_cast<int>(i) % kLanes;
    index->n[phase][lane] = static_cast<float>(m.n);
    index->k[phase][lane] = static_cast<float>(m.k);
  }
  const FresnelTables tables = model.prepare(*index);
  for (std::size_t i = 0; i < count; ++i) {
    const int phase = static_cast<int>(i) / kLanes, lane = static_cast<int>(i) % kLanes;
    const float cos_theta = static_cast<float>(cosine(queries[first + i].theta_deg));
    FresnelModel::Scalar result;
    result.unpolarised = double{model.reflectance(tables, phase, cos_theta)[lane]};
    if (const auto apart = model.polarised(tables, phase, cos_theta)) {
      result.s = double{apart->s[lane]};
      result.p = double{apart->p[lane]};
    }
    results.push_back(result);
  }
}

}  // namespace

std::vector<FresnelModel::Scalar> evaluate_fresnel(const FresnelModel& model,
                                                   const std::vector<FresnelQuery>& queries,
                                                   FresnelPrecision precision) {
  std::vector<FresnelModel::Scalar> results;
  results.reserve(queries.size());
  if (precision == FresnelPrecision::kDouble) {
    for (const FresnelQuery& query : queries) {
      results.push_back(model.evaluate(relative(query), cosine(query.theta_deg)));
    }
    return results;
  }
  for (std::size_t first = 0; first < queries.size(); first += kLatticeSize) {
    evaluate_block(model, queries, first, results);
  }
  return results;
}

}  // namespace karat
