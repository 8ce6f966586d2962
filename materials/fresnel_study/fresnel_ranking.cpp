#include "materials/fresnel_study/fresnel_ranking.h"

#include <algorithm>
#include <cmath>

namespace karat {
namespace {

FresnelRank rank_of(std::size_t model, const std::vector<FresnelMaterialStudy>& materials) {
  FresnelRank rank;
  rank.model = materials.front().models[model].model;
  const double count = static_cast<double>(materials.size());
  double square = 0.0;
  for (const FresnelMaterialStudy& material : materials) {
    const FresnelModelStudy& study = material.models[model];
    rank.max_abs_error = std::max(rank.max_abs_error, study.error.max_abs);
    square += study.error.rms * study.error.rms;
    rank.delta_e_mean += study.colour_error.mean / count;
    rank.delta_e_albedo = std::max(rank.delta_e_albedo, study.colour_error.albedo);
    if (rank.worst_material.empty() || study.colour_error.max > rank.delta_e_max) {
      rank.delta_e_max = study.colour_error.max;
      rank.worst_material = material.table->provenance().name;
    }
  }
  rank.rms_error = std::sqrt(square / count);
  return rank;
}

bool beats(const FresnelRank& a, const FresnelRank& b) {
  const bool as_cheap = a.cost_relative <= b.cost_relative * (1.0 + kSameCost);
  const double a_error = std::max(a.delta_e_mean, kNoError);
  const double b_error = std::max(b.delta_e_mean, kNoError);
  const bool as_near = a_error <= b_error * (1.0 + kSameError);
  const bool cheaper = a.cost_relative < b.cost_relative * (1.0 - kSameCost);
  const bool nearer = a_error < b_error * (1.0 - kSameError);
  return as_cheap && as_near && (cheaper || nearer);
}

}  // namespace

std::vector<FresnelRank> rank_fresnel_models(const std::vector<FresnelMaterialStudy>& materials,
                                             const std::vector<FresnelCost>& costs) {
  std::vector<FresnelRank> ranks;
  if (materials.empty()) return ranks;
  for (std::size_t i = 0; i < materials.front().models.size(); ++i) {
    ranks.push_back(rank_of(i, materials));
    const auto cost = std::find_if(costs.begin(), costs.end(), [&](const FresnelCost& c) {
      return c.model == ranks.back().model;
    });
    if (cost != costs.end()) ranks.back().cost_relative = cost->relative.median;
  }
  for (FresnelRank& rank : ranks) {
    rank.efficient = std::none_of(ranks.begin(), ranks.end(),
                                  [&](const FresnelRank& other) { return beats(other, rank); });
  }
  return ranks;
}

}  // namespace karat
