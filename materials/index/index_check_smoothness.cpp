// Rows that stand out from their neighbours: slips of typing, joints between data sets, noise.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "materials/index/index_check.h"

namespace karat {
namespace {

using Rows = std::vector<SpectrumSample>;

// A row counts as an outlier where it is this many times as far off as rows nearby usually are,
// and by more than this share of |n + ik|: what is less does not show.
constexpr double kDeviations = 8.0, kShare = 0.01;
constexpr std::size_t kNeighbours = 10;  // on either side, for the usual distance

struct Outlier {
  double nm = 0.0, value = 0.0, expected = 0.0, share = 0.0;
  const char* quantity = "n";
};

// The cubic through the two rows on either side of row i, at row i (Lagrange).
double from_neighbours(const Rows& rows, std::size_t i) {
  const std::size_t at[] = {i - 2, i - 1, i + 1, i + 2};
  double sum = 0.0;
  for (const std::size_t a : at) {
    double weight = 1.0;
    for (const std::size_t b : at) {
      if (a != b) weight *= (rows[i].nm - rows[b].nm) / (rows[a].nm - rows[b].nm);
    }
    sum += weight * rows[a].value;
  }
  return sum;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Median distance of the rows near i, but not i itself and the two on either side, which an
// outlier at i pulls away too.
double usual_distance(const std::vector<double>& distances, std::size_t i) {
  std::vector<double> near;
  for (std::size_t j = i > kNeighbours ? i - kNeighbours : 0;
       j < std::min(distances.size(), i + kNeighbours + 1); ++j) {
    if (j + 2 < i || j > i + 2) near.push_back(std::abs(distances[j]));
  }
  return near.size() < 4 ? 1e300 : median(near);
}

Rows without_repeats(const Rows& rows) {
  Rows result;
  for (const SpectrumSample& row : rows) {
    if (result.empty() || row.nm > result.back().nm) result.push_back(row);
  }
  return result;
}

double magnitude_at(const IndexTable& table, double nm) {
  const ComplexIndex index = table.at(nm);
  return std::hypot(index.n, index.k);
}

// Appends the outliers of one quantity; returns the median distance as a share of |n + ik|.
double find_outliers(const IndexTable& table, const Rows& all, const char* quantity,
                     std::vector<Outlier>& outliers) {
  const Rows rows = without_repeats(all);
  if (rows.size() < 10) return 0.0;
  std::vector<double> distances(rows.size() - 4), shares;
  for (std::size_t i = 2; i + 2 < rows.size(); ++i) {
    distances[i - 2] = rows[i].value - from_neighbours(rows, i);
    shares.push_back(std::abs(distances[i - 2]) / magnitude_at(table, rows[i].nm));
  }
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const double here = std::abs(distances[i]);
    const bool peak = (i == 0 || here >= std::abs(distances[i - 1])) &&
                      (i + 1 == distances.size() || here > std::abs(distances[i + 1]));
    if (!peak || shares[i] < kShare || here < kDeviations * usual_distance(distances, i)) continue;
    const SpectrumSample& row = rows[i + 2];
    outliers.push_back({row.nm, row.value, row.value - distances[i], shares[i], quantity});
  }
  return median(shares);
}

// Repeated wavelengths whose values differ by more than kShare of |n + ik|.
std::size_t jumps(const IndexTable& table, const Rows& rows) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double jump = std::abs(rows[i].value - rows[i - 1].value);
    if (rows[i].nm == rows[i - 1].nm && jump > kShare * magnitude_at(table, rows[i].nm)) ++count;
  }
  return count;
}

std::string text_of(std::vector<Outlier> outliers) {
  constexpr std::size_t kMostNamed = 3;
  std::stable_sort(outliers.begin(), outliers.end(),
                   [](const Outlier& a, const Outlier& b) { return a.share > b.share; });
  std::string text;
  for (std::size_t i = 0; i < std::min(kMostNamed, outliers.size()); ++i) {
    const Outlier& o = outliers[i];
    text += fmt::format("{}{} = {:.4g} at {:.6g} nm, where its neighbours suggest {:.4g}",
                        i ? "; " : "", o.quantity, o.value, o.nm, o.expected);
  }
  if (outliers.size() > kMostNamed) {
    text += fmt::format("; and {} more", outliers.size() - kMostNamed);
  }
  return text;
}

}  // namespace

IndexCheck check_smoothness(const IndexTable& table) {
  IndexCheck check{"smoothness", Verdict::kGood, "", {}};
  if (std::max(table.n_samples().size(), table.k_samples().size()) < 10) {
    check.verdict = Verdict::kUnknown;
    check.text = "fewer than ten rows";
    return check;
  }
  std::vector<Outlier> outliers;
  const double noise = std::max(find_outliers(table, table.n_samples(), "n", outliers),
                                find_outliers(table, table.k_samples(), "k", outliers));
  const std::size_t jump_count = jumps(table, table.n_samples()) + jumps(table, table.k_samples());
  check.figures = {{"outliers", static_cast<double>(outliers.size())},
                   {"jumps", static_cast<double>(jump_count)},
                   {"median_distance_share", noise}};
  check.text = fmt::format("rows lie {:.2g} % off their neighbours in the median", 100.0 * noise);
  if (!outliers.empty())
    check.text += "; a slip, or an edge sharper than the rows can show: " + text_of(outliers);
  if (jump_count > 0) {
    check.text += fmt::format("; {} repeated wavelength{} with different values", jump_count,
                              jump_count == 1 ? "" : "s");
  }
  if (!outliers.empty() || jump_count > 0 || noise > 2.0 * kShare)
    check.verdict = Verdict::kDoubtful;
  return check;
}

}  // namespace karat
