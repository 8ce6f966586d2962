#include "materials/missing_energy.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace karat {
namespace {

constexpr int kRareIntervals = 48, kDenseIntervals = 3 * 32;
constexpr double kRowsPerEta = 40.0;
constexpr int kMostRows = 17;
// Azimuths: the quadrature is done at few places and carried over to many by the polynomial through
// them (barycentric form, Berrut and Trefethen 2004, equation 5.4).
constexpr int kPlaces = 7, kColumns = 25;
constexpr float kGrazingCosine = 1e-4f;  // stands for 0, where nothing can be integrated

// Chebyshev points of the second kind on [0, 1].
double place(int i) { return 0.5 - 0.5 * std::cos(M_PI * i / (kPlaces - 1)); }

double through_places(const std::array<double, kPlaces>& values, double x) {
  double numerator = 0.0, denominator = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    const double value = values[static_cast<std::size_t>(i)];
    const double distance = x - place(i);
    if (std::abs(distance) < 1e-12) return value;
    const bool end = i == 0 || i == kPlaces - 1;
    const double weight = (i % 2 == 0 ? 1.0 : -1.0) * (end ? 0.5 : 1.0) / distance;
    numerator += weight * value, denominator += weight;
  }
  return numerator / denominator;
}

// The azimuth's direction in which the distribution is `width` wide.
Vec2 azimuth_of(double width, Vec2 alpha) {
  const double x2 = double{alpha.x} * double{alpha.x}, y2 = double{alpha.y} * double{alpha.y};
  const double sine2 = std::clamp((width * width - x2) / (y2 - x2), 0.0, 1.0);
  return {static_cast<float>(std::sqrt(1.0 - sine2)), static_cast<float>(std::sqrt(sine2))};
}

void add(FacetShares& sum, const FacetShares& shares, double weight) {
  sum.reflected += weight * shares.reflected, sum.refracted += weight * shares.refracted;
  sum.shadowed += weight * shares.shadowed, sum.trapped += weight * shares.trapped;
}

}  // namespace

MissingEnergy::MissingEnergy(const FacetQuadrature& quadrature, Vec2 alpha, float least,
                             float largest)
    : dense_(largest < 1.0f),
      intervals_(dense_ ? kDenseIntervals : kRareIntervals),
      alpha_(alpha),
      first_width_(alpha.x) {
  const double range = double{largest} - double{least};
  const bool constant = !(range > 1e-6 * double{largest});
  rows_ = constant ? 1 : std::min(2 + static_cast<int>(range * kRowsPerEta), kMostRows);
  first_eta_ = least;
  rows_per_eta_ = constant ? 0.0f : static_cast<float>((rows_ - 1) / range);
  const bool isotropic = alpha.x == alpha.y;
  columns_ = isotropic ? 1 : kColumns;
  columns_per_width_ = isotropic ? 0.0f : (kColumns - 1) / (alpha.y - alpha.x);

  // How much of the circle each column stands for.
  column_weight_.assign(static_cast<std::size_t>(columns_), isotropic ? 1.0 : 0.0);
  constexpr int kAzimuths = 720;
  for (int i = 0; i < kAzimuths && !isotropic; ++i) {
    const double phi = 0.5 * M_PI * (i + 0.5) / kAzimuths;
    const float at =
        column({static_cast<float>(std::cos(phi)), static_cast<float>(std::sin(phi)), 0.0f});
    const int j = std::clamp(static_cast<int>(at), 0, columns_ - 2);
    const double across = double{at} - j;
    column_weight_[static_cast<std::size_t>(j)] += (1.0 - across) / kAzimuths;
    column_weight_[static_cast<std::size_t>(j) + 1] += across / kAzimuths;
  }

  const auto stride = static_cast<std::size_t>(intervals_ + 1);
  table_.resize(static_cast<std::size_t>(rows_ * columns_) * stride);
  for (int row = 0; row < rows_; ++row) {
    const double eta = constant ? double{least} : double{least} + range * row / (rows_ - 1);
    FacetShares means;
    double whole = 0.0, before = 0.0;
    for (int node = 0; node <= intervals_; ++node) {
      const double cosine = std::clamp(cosine_at(node, eta), double{kGrazingCosine}, 1.0);
      // The node's part of the integral of 2 cos d(cos), between the middles to its neighbours.
      const double edge = cosine_at(std::min(node + 0.5, double(intervals_)), eta);
      const double weight = edge * edge - before * before;
      before = edge, whole += weight;
      const auto sine = static_cast<float>(std::sqrt(1.0 - cosine * cosine));
      std::array<double, kPlaces> missing{};
      const int places = isotropic ? 1 : kPlaces;
      for (int i = 0; i < places; ++i) {
        const Vec2 toward =
            isotropic ? Vec2{1.0f, 0.0f}
                      : azimuth_of(double{alpha.x} + double(alpha.y - alpha.x) * place(i), alpha);
        const FacetShares shares =
            quadrature.shares({sine * toward.x, sine * toward.y, static_cast<float>(cosine)},
                              static_cast<float>(eta));
        missing[static_cast<std::size_t>(i)] = shares.lost();
        add(means, shares, weight / places);
      }
      for (int j = 0; j < columns_; ++j) {
        const double value =
            isotropic ? missing[0] : through_places(missing, double(j) / (kColumns - 1));
        table_[static_cast<std::size_t>(row * columns_ + j) * stride +
               static_cast<std::size_t>(node)] = static_cast<float>(std::clamp(value, 0.0, 1.0));
      }
    }
    mean_shares_.push_back({});
    add(mean_shares_.back(), means, 1.0 / whole);
  }
}

double MissingEnergy::cosine_at(double position, double eta) const {
  const double n = intervals_;
  if (!dense_) return position * position / (n * n);
  const double third = n / 3.0, critical = std::sqrt(std::max(0.0, 1.0 - eta * eta));
  if (position < third) return 0.5 * critical * position * position / (third * third);
  const double away = (position - 2.0 * third) / third;
  return critical + (away < 0.0 ? -0.5 * critical : 1.0 - critical) * away * away;
}

double MissingEnergy::row_mean(int row, int node) const {
  double sum = 0.0;
  for (int j = 0; j < columns_; ++j) {
    sum += column_weight_[static_cast<std::size_t>(j)] *
           double{table_[static_cast<std::size_t>((row * columns_ + j) * (intervals_ + 1) + node)]};
  }
  return sum;
}

double MissingEnergy::azimuthal_mean(double cos_theta, double eta) const {
  double sum = 0.0;
  for (int j = 0; j < columns_; ++j) {
    sum +=
        column_weight_[static_cast<std::size_t>(j)] *
        double{at(static_cast<float>(cos_theta), static_cast<float>(j), static_cast<float>(eta))};
  }
  return sum;
}

// The integral of missing d(cos^2), interval by interval: missing is linear there, so that by parts
// it is [missing cos^2] - slope * (the integral of cos^2 over the interval), and cos^2 is a
// polynomial of degree 4 that Gauss' rule of three points integrates exactly.
double MissingEnergy::mean(double eta) const {
  constexpr std::array<double, 3> kAt{0.1127016653792583, 0.5, 0.8872983346207417};
  constexpr std::array<double, 3> kWeight{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  const double r = rows_ > 1 ? double{row_position(static_cast<float>(eta))} : 0.0;
  const int row = std::clamp(static_cast<int>(r), 0, std::max(rows_ - 2, 0));
  const double fraction = r - row;
  const auto missing = [&](int node) {
    const double here = row_mean(row, node);
    return rows_ > 1 ? here + fraction * (row_mean(row + 1, node) - here) : here;
  };
  double sum = missing(intervals_);  // cos^2 = 1 at the last node, 0 at the first
  double last = missing(0);
  for (int node = 0; node < intervals_; ++node) {
    const double next = missing(node + 1);
    double squares = 0.0;
    for (std::size_t i = 0; i < kAt.size(); ++i) {
      const double cosine = cosine_at(node + kAt[i], eta);
      squares += kWeight[i] * cosine * cosine;
    }
    sum -= (next - last) * squares;
    last = next;
  }
  return sum;
}

FacetShares MissingEnergy::mean_shares(double eta) const {
  if (rows_ == 1) return mean_shares_[0];
  const double r = double{row_position(static_cast<float>(eta))};
  const int row = std::clamp(static_cast<int>(r), 0, rows_ - 2);
  FacetShares shares;
  add(shares, mean_shares_[static_cast<std::size_t>(row)], 1.0 - (r - row));
  add(shares, mean_shares_[static_cast<std::size_t>(row) + 1], r - row);
  return shares;
}

}  // namespace karat
