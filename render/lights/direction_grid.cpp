#include "render/lights/direction_grid.h"

#include <algorithm>
#include <cmath>

namespace karat {
namespace {

constexpr double kPiD = 3.14159265358979323846;
constexpr double kEvenShare = 0.01;

// Writes running sums of `weights` as fractions of the whole; returns the whole.
double running_sums(const std::vector<double>& weights, float* upper) {
  double sum = 0.0, whole = 0.0;
  for (const double w : weights) whole += w;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += weights[i];
    upper[i] = static_cast<float>(sum / whole);
  }
  upper[weights.size() - 1] = 1.0f;
  return whole;
}

// The interval of a running sum that holds u, and where in it u lies, in [0, 1).
struct Choice {
  std::size_t index;
  float within;
};
Choice choose(const float* upper, std::size_t count, float u) {
  const float* chosen = std::upper_bound(upper, upper + count - 1, u);
  const float lower = chosen == upper ? 0.0f : chosen[-1];
  return {static_cast<std::size_t>(chosen - upper),
          std::min((u - lower) / (*chosen - lower), 0.99999994f)};
}

// What sample() draws, roundings included.
float probability(const float* upper, std::size_t i) {
  return upper[i] - (i == 0 ? 0.0f : upper[i - 1]);
}

}  // namespace

DirectionGrid::DirectionGrid(int columns, int rows, const std::vector<float>& weights)
    : columns_(static_cast<std::size_t>(columns)),
      rows_(static_cast<std::size_t>(rows)),
      row_upper_(rows_),
      column_upper_(weights.size()) {
  for (int i = 0; i <= rows; ++i) {
    row_z_.push_back(static_cast<float>(std::cos(kPiD * i / rows)));
  }
  std::vector<double> row_sums(rows_);
  double whole = 0.0;
  const auto share = [&](std::size_t row) { return 0.5 * (double{row_z_[row]} - row_z_[row + 1]); };
  for (std::size_t i = 0; i < weights.size(); ++i) whole += weights[i] * share(i / columns_);
  const double even = kEvenShare * whole / static_cast<double>(columns_);
  std::vector<double> row_weights(columns_);
  for (std::size_t row = 0; row < rows_; ++row) {
    for (std::size_t j = 0; j < columns_; ++j) {
      row_weights[j] = double{weights[row * columns_ + j]} + even;
    }
    row_sums[row] = share(row) * running_sums(row_weights, &column_upper_[row * columns_]);
  }
  running_sums(row_sums, row_upper_.data());
}

float DirectionGrid::cell_pdf(std::size_t row, std::size_t column) const {
  const float columns = static_cast<float>(columns_);
  return probability(row_upper_.data(), row) * probability(&column_upper_[row * columns_], column) *
         columns / (2.0f * kPi * (row_z_[row] - row_z_[row + 1]));
}

DirectionGrid::Sample DirectionGrid::sample(Vec2 u) const {
  const Choice row = choose(row_upper_.data(), rows_, u.y);
  const Choice column = choose(&column_upper_[row.index * columns_], columns_, u.x);
  const float z = row_z_[row.index] + row.within * (row_z_[row.index + 1] - row_z_[row.index]);
  const float longitude =
      (static_cast<float>(column.index) + column.within) / static_cast<float>(columns_);
  const float angle = 2.0f * kPi * longitude - kPi, r = std::sqrt(std::max(0.0f, 1.0f - z * z));
  return {{r * std::sin(angle), r * std::cos(angle), z}, cell_pdf(row.index, column.index)};
}

float DirectionGrid::pdf(Vec3 direction) const {
  const Vec2 at = latlong(direction);
  const auto cell = [](float x, std::size_t n) {
    return std::min(static_cast<std::size_t>(x * static_cast<float>(n)), n - 1);
  };
  return cell_pdf(cell(at.y, rows_), cell(at.x, columns_));
}

Vec2 latlong(Vec3 d) {
  const float longitude = 0.5f + 0.5f * kInvPi * std::atan2(d.x, d.y);
  const float angle = kInvPi * std::atan2(std::sqrt(d.x * d.x + d.y * d.y), d.z);
  return {longitude < 1.0f ? longitude : 0.0f, angle};
}

}  // namespace karat
