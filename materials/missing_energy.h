// What single scattering lacks to 1 on one side of a rough dielectric interface, tabulated.
#pragma once

#include <vector>

#include "materials/facet_quadrature.h"
#include "spectral/sampled_spectrum.h"

namespace karat {

// 1 - E(w, eta), where E is the share of the energy from direction w that leaves after one
// scattering. Piecewise linear in eta, in the root of the distance of cos(theta) from grazing and
// from the critical angle (where light that skims the far side is trapped; that place moves with
// eta, and the nodes with it), and in the width of the distribution seen from w's azimuth,
// sqrt(alpha_x^2 cos^2 phi + alpha_y^2 sin^2 phi).
class MissingEnergy {
 public:
  // Indices of the far side over this one lie in [least, largest], on one side of 1.
  MissingEnergy(const FacetQuadrature& quadrature, Vec2 alpha, float least, float largest);

  // In [0, 1], for a unit w on this side (either sign of z).
  float at(const Vec3& w, float eta) const { return at(std::abs(w.z), column(w), eta); }
  SampledSpectrum at(const Vec3& w, const SampledSpectrum& eta) const {
    const float cos_theta = std::abs(w.z), place = column(w);
    SampledSpectrum missing;
#pragma omp simd
    for (int i = 0; i < kLanes; ++i) missing[i] = at(cos_theta, place, eta[i]);
    return missing;
  }

  // The mean over azimuth and the mean over the hemisphere, weighted with the cosine, of exactly
  // the function that at() interpolates. Load time.
  double azimuthal_mean(double cos_theta, double eta) const;
  double mean(double eta) const;
  // The cosine at a fraction of the way from grazing to normal along the table's nodes.
  double cosine_of_fraction(double fraction, double eta) const {
    return cosine_at(fraction * intervals_, eta);
  }
  // Cosine-weighted means of all shares.
  FacetShares mean_shares(double eta) const;

 private:
  // Position among the nodes of cos(theta), and back.
  float node_position(float cos_theta, float eta) const;
  double cosine_at(double position, double eta) const;
  float row_position(float eta) const { return (eta - first_eta_) * rows_per_eta_; }
  float column(const Vec3& w) const;
  float at(float cos_theta, float column, float eta) const;
  double row_mean(int row, int node) const;  // over azimuth

  bool dense_;     // the far side has the lower index: there is a critical angle
  int intervals_;  // between nodes of cos(theta)
  int rows_, columns_;
  float first_eta_, rows_per_eta_;
  Vec2 alpha_;
  float first_width_, columns_per_width_;
  std::vector<double> column_weight_;
  std::vector<float> table_;  // [row][column][node]
  std::vector<FacetShares> mean_shares_;
};

inline float MissingEnergy::node_position(float cos_theta, float eta) const {
  const auto n = static_cast<float>(intervals_);
  if (!dense_) return n * std::sqrt(cos_theta);
  const float third = n * (1.0f / 3.0f);
  const float critical = std::sqrt(std::max(0.0f, (1.0f - eta) * (1.0f + eta)));
  const float half = 0.5f * critical;
  const float away = cos_theta - critical;
  const float grazing = third * std::sqrt(cos_theta / half);
  const float near_critical =
      third * std::sqrt(std::abs(away) / (away < 0.0f ? half : 1.0f - critical));
  return cos_theta < half ? grazing : 2.0f * third + (away < 0.0f ? -near_critical : near_critical);
}

inline float MissingEnergy::column(const Vec3& w) const {
  if (columns_ == 1) return 0.0f;
  const float x = alpha_.x * w.x, y = alpha_.y * w.y;
  const float width = std::sqrt((x * x + y * y) / std::max(w.x * w.x + w.y * w.y, 1e-30f));
  return (width - first_width_) * columns_per_width_;
}

// Positions are clamped so that the last node is reached from the last interval.
inline float MissingEnergy::at(float cos_theta, float column, float eta) const {
  const auto clamped = [](float position, int intervals) {
    return std::max(0, std::min(static_cast<int>(position), intervals - 1));
  };
  const float t = node_position(std::min(cos_theta, 1.0f), eta), r = row_position(eta);
  const int node = clamped(t, intervals_);
  const int row = clamped(r, rows_ - 1), next_row = rows_ > 1 ? row + 1 : row;
  const int place = clamped(column, columns_ - 1), next_place = columns_ > 1 ? place + 1 : place;
  const float along = t - static_cast<float>(node), fraction = r - static_cast<float>(row);
  const float across = column - static_cast<float>(place);
  const int stride = intervals_ + 1;
  const auto value = [&](int i, int j) {
    const float* pair = table_.data() + (i * columns_ + j) * stride + node;
    return pair[0] + along * (pair[1] - pair[0]);
  };
  const auto row_value = [&](int i) {
    const float here = value(i, place);
    return columns_ > 1 ? here + across * (value(i, next_place) - here) : here;
  };
  const float here = row_value(row);
  return rows_ > 1 ? here + fraction * (row_value(next_row) - here) : here;
}

}  // namespace karat
