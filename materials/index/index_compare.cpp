#include "materials/index/index_compare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "materials/fresnel.h"
#include "spectral/support/error.h"

namespace karat {

IndexComparison::IndexComparison(const std::vector<IndexTablePtr>& tables,
                                 const ColourConditions& conditions) {
  for (const IndexTablePtr& table : tables) {
    ComparedTable compared{table, std::nullopt, ""};
    try {
      compared.colour = index_colour(*table, conditions);
    } catch (const InputError& error) {
      compared.problem = error.what();
    }
    tables_.push_back(std::move(compared));
  }
}

std::optional<double> IndexComparison::difference(std::size_t i, std::size_t j) const {
  const auto &a = tables_[i].colour, &b = tables_[j].colour;
  if (!a || !b) return std::nullopt;
  return delta_e_2000(a->lab, b->lab);
}

std::optional<IndexComparison::Summary> IndexComparison::summary() const {
  Summary summary;
  summary.typical_mean = std::numeric_limits<double>::max();
  std::vector<double> all;
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    double sum = 0.0;
    std::size_t others = 0;
    for (std::size_t j = 0; j < tables_.size(); ++j) {
      const auto difference = i == j ? std::nullopt : this->difference(i, j);
      if (!difference) continue;
      sum += *difference;
      ++others;
      if (j > i) continue;
      all.push_back(*difference);
      if (*difference < summary.largest) continue;
      summary.largest = *difference;
      summary.largest_i = j;
      summary.largest_j = i;
    }
    if (others > 0 && sum < summary.typical_mean * static_cast<double>(others)) {
      summary.typical_mean = sum / static_cast<double>(others);
      summary.typical = i;
    }
  }
  if (all.empty()) return std::nullopt;
  summary.pairs = all.size();
  const std::size_t half = all.size() / 2;
  std::sort(all.begin(), all.end());
  summary.median = all.size() % 2 == 1 ? all[half] : 0.5 * (all[half - 1] + all[half]);
  return summary;
}

std::vector<ModelDifference> model_differences(const IndexTable& table, ColourConditions conditions,
                                               const std::vector<double>& angles_deg) {
  std::vector<ModelDifference> result;
  for (const std::string& model : Registry<FresnelModel>::instance().names()) {
    if (model == "exact") continue;
    ModelDifference difference{model, {}};
    for (const double angle : angles_deg) {
      conditions.cos_theta = std::cos(angle * std::numbers::pi / 180.0);
      conditions.fresnel = "exact";
      const Lab exact = index_colour(table, conditions).lab;
      conditions.fresnel = model;
      difference.ciede2000.push_back(delta_e_2000(index_colour(table, conditions).lab, exact));
    }
    result.push_back(std::move(difference));
  }
  return result;
}

}  // namespace karat
