// The sphere of directions as a grid of latitude and longitude with a density in every cell.
#pragma once

#include <cstddef>
#include <vector>

#include "materials/vector.h"

namespace karat {

// Cells are `columns` equal steps in longitude by `rows` equal steps in the angle from +z (row 0
// holds +z). Longitude runs over [0, 1) and wraps: 1/2 is the direction +y, 3/4 is +x. The density
// is constant within a cell, per solid angle.
class DirectionGrid {
 public:
  DirectionGrid() = default;
  // One weight (>= 0, per solid angle) for each cell, row by row; not all zero. A hundredth of all
  // samples is spread evenly, so that the density is nowhere zero.
  DirectionGrid(int columns, int rows, const std::vector<float>& weights);

  struct Sample {
    Vec3 direction;
    float pdf;
  };
  Sample sample(Vec2 u) const;
  float pdf(Vec3 direction) const;

 private:
  float cell_pdf(std::size_t row, std::size_t column) const;

  std::size_t columns_ = 0, rows_ = 0;
  std::vector<float> row_z_;         // cos of the angle from +z at the rows' borders
  std::vector<float> row_upper_;     // running sum of the rows' probabilities
  std::vector<float> column_upper_;  // within each row
};

// The longitude of a unit direction, in [0, 1), and its angle from +z as a fraction of pi.
Vec2 latlong(Vec3 direction);

}  // namespace karat
