// Index tables side by side: how far their colours lie apart.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "materials/index/index_colour.h"

namespace karat {

struct ComparedTable {
  IndexTablePtr table;
  std::optional<IndexColour> colour;
  std::string problem;  // why there is no colour: the range, negative values
};

class IndexComparison {
 public:
  // Tables without a colour under `conditions` are kept, with the reason.
  IndexComparison(const std::vector<IndexTablePtr>& tables, const ColourConditions& conditions);

  const std::vector<ComparedTable>& tables() const { return tables_; }

  // CIEDE2000 between two of them; nothing where one has no colour.
  std::optional<double> difference(std::size_t i, std::size_t j) const;

  // Over all pairs that have colours.
  struct Summary {
    std::size_t pairs = 0;
    double median = 0.0, largest = 0.0;
    std::size_t largest_i = 0, largest_j = 0;
    std::size_t typical = 0;  // the table with the least mean difference from the others
    double typical_mean = 0.0;
  };
  // Nothing where fewer than two tables have a colour.
  std::optional<Summary> summary() const;

 private:
  std::vector<ComparedTable> tables_;
};

// What the registered Fresnel models, other than the exact one, do to the colour of one table.
struct ModelDifference {
  std::string model;
  std::vector<double> ciede2000;  // from the colour of the exact equations, per angle
};
std::vector<ModelDifference> model_differences(const IndexTable& table, ColourConditions conditions,
                                               const std::vector<double>& angles_deg);

}  // namespace karat
