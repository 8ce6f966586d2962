// Pearson's chi-square test of a histogram against expected counts.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace karat::test {

// Q(a, x), the upper regularised incomplete gamma function: series below x = a + 1, continued
// fraction (modified Lentz) above. Abramowitz and Stegun 6.5.29 and 6.5.31.
inline double gamma_q(double a, double x) {
  if (!(x > 0.0)) return 1.0;
  const double scale = std::exp(-x + a * std::log(x) - std::lgamma(a));
  if (x < a + 1.0) {
    double term = 1.0 / a, sum = term;
    for (int i = 1; i < 10000 && term > 1e-16 * sum; ++i) sum += term *= x / (a + i);
    return 1.0 - sum * scale;
  }
  double b = x + 1.0 - a, c = 1e300, d = 1.0 / b, h = d;
  for (int i = 1; i < 10000; ++i) {
    const double an = -i * (i - a);
    b += 2.0;
    d = 1.0 / (an * d + b);
    c = b + an / c;
    h *= d * c;
    if (std::abs(d * c - 1.0) < 1e-15) break;
  }
  return scale * h;
}

// The probability of a histogram at least this far from what was expected, if the expectation is
// right. Cells that expect fewer than `least` are pooled, smallest first.
inline double chi_square_p_value(const std::vector<double>& observed,
                                 const std::vector<double>& expected, double least = 10.0) {
  std::vector<std::pair<double, double>> cells;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    cells.emplace_back(std::max(expected[i], 0.0), observed[i]);
  }
  // By what is expected alone: where many cells expect the same, an order by what was observed
  // would pool the few with the few and the many with the many.
  std::stable_sort(cells.begin(), cells.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  double statistic = 0.0, pooled_expected = 0.0, pooled_observed = 0.0;
  int used = 0;
  for (const auto& [e, o] : cells) {
    pooled_expected += e, pooled_observed += o;
    if (pooled_expected < least) continue;
    statistic +=
        (pooled_observed - pooled_expected) * (pooled_observed - pooled_expected) / pooled_expected;
    pooled_expected = pooled_observed = 0.0;
    ++used;
  }
  // What is left over expects less than `least`: counts there beyond any doubt are a failure too.
  if (pooled_observed > least + 10.0 * std::sqrt(least)) return 0.0;
  return used > 1 ? gamma_q(0.5 * (used - 1), 0.5 * statistic) : 1.0;
}

// Significance of one of `tests` tests when all together may fail by chance with probability 1e-3
// (Sidak 1967).
inline double sidak_level(std::size_t tests) {
  return 1.0 - std::pow(1.0 - 1e-3, 1.0 / static_cast<double>(std::max<std::size_t>(tests, 1)));
}

}  // namespace karat::test
