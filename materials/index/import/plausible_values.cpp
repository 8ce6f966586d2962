#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "materials/index/import/plausible.h"
#include "materials/index/index_table.h"

namespace karat {
namespace {

// In the visible no table of the database but zinc's (Querry; n = 13.9, which its own comments call
// implausible) has more than n = 8.2 or k = 10.1.
constexpr double kMostN = 9.0, kMostK = 12.0;
constexpr std::size_t kFewestVisible = 3;
constexpr double kWidestVisibleGapNm = 60.0;  // 0.1 eV in the red, as Johnson and Christy measured

double nm_of(const ImportRow& row) { return row.um.value * 1e3; }

bool is_visible(const ImportRow& row) { return kVisible.covers({nm_of(row), nm_of(row)}); }

// Rows for which something holds: how many, and the first of them.
struct Found {
  std::size_t count = 0;
  const ImportRow* first = nullptr;

  // "at line 12 (700 nm) and 3 more"
  std::string where() const {
    return fmt::format("at line {} ({:.6g} nm){}", first->line, nm_of(*first),
                       count > 1 ? fmt::format(" and {} more", count - 1) : "");
  }
};

template <typename Condition>
Found found(const ImportSeries& series, Condition holds) {
  Found result;
  for (const ImportRow& row : series.rows) {
    if (holds(row) && result.count++ == 0) result.first = &row;
  }
  return result;
}

void doubt_signs(const ImportSeries& series, Doubts& doubts) {
  const Found n = found(series, [](const ImportRow& row) { return row.n.value < 0.0; });
  if (series.has_n && n.count > 0) {
    doubts.implausible.push_back(
        fmt::format("n = {} {}: n of a material is not negative; are the columns right "
                    "(--columns)?",
                    n.first->n.text, n.where()));
  }
  const Found k = found(series, [](const ImportRow& row) { return row.k.value < 0.0; });
  if (!series.has_k || k.count == 0) return;
  const Found positive = found(series, [](const ImportRow& row) { return row.k.value > 0.0; });
  if (positive.count == 0) {
    doubts.implausible.push_back(
        "k is negative throughout: the file uses the other sign convention, n - ik, where Karat "
        "means n + ik with k >= 0 for absorption; --negate-k changes the sign");
  } else if (k.count > positive.count) {
    doubts.implausible.push_back(
        fmt::format("k is negative in {} of {} rows and positive {}: if the file uses the other "
                    "sign convention, n - ik, say --negate-k and correct the rest",
                    k.count, series.rows.size(), positive.where()));
  } else {
    doubts.implausible.push_back(
        fmt::format("k = {} {}: a negative k amplifies light; set it to what was meant, or leave "
                    "the rows out",
                    k.first->k.text, k.where()));
  }
}

void doubt_magnitudes(const ImportSeries& series, Doubts& doubts) {
  const Found n = found(series, [](const ImportRow& row) {
    return is_visible(row) && std::abs(row.n.value) > kMostN;
  });
  if (series.has_n && n.count > 0) {
    doubts.implausible.push_back(
        fmt::format("n = {} {}: no material has more than {} in the visible; are columns and unit "
                    "right (--columns, --unit)?",
                    n.first->n.text, n.where(), kMostN));
  }
  const Found k = found(series, [](const ImportRow& row) {
    return is_visible(row) && std::abs(row.k.value) > kMostK;
  });
  if (series.has_k && k.count > 0) {
    doubts.implausible.push_back(
        fmt::format("k = {} {}: no material has more than {} in the visible; are columns and unit "
                    "right (--columns, --unit)? (An absorption coefficient is not k.)",
                    k.first->k.text, k.where(), kMostK));
  }
  const Found zero =
      found(series, [&](const ImportRow& row) { return row.n.value == 0.0 && row.k.value == 0.0; });
  if (series.has_n && zero.count > 0) {
    doubts.implausible.push_back(
        fmt::format("n = 0 {} {}: some programs write that where nothing was measured; leave "
                    "these rows out",
                    series.has_k ? "and k = 0" : "", zero.where()));
  }
}

// n and k at a wavelength within the rows' range, linear between rows.
ComplexIndex at(const std::vector<ImportRow>& rows, double um) {
  auto right = std::lower_bound(rows.begin(), rows.end(), um,
                                [](const ImportRow& row, double x) { return row.um.value < x; });
  if (right == rows.begin()) return {right->n.value, right->k.value};
  if (right == rows.end()) return {rows.back().n.value, rows.back().k.value};
  const auto left = right - 1;
  const double t = (um - left->um.value) / (right->um.value - left->um.value);
  return {std::lerp(left->n.value, right->n.value, t), std::lerp(left->k.value, right->k.value, t)};
}

// n that is above `ratio` times k from `from_um` to 0.75 um (so that the material is nearly
// transparent there) yet rises by the factor `rise`: dispersion is normal where nothing absorbs,
// but the k of a metal does just that.
bool rises_like_k(const ImportSeries& series, double from_um, double rise, double ratio) {
  constexpr double kToUm = 0.75, kStepUm = 0.01;
  if (!series.range_nm().covers({from_um * 1e3, kToUm * 1e3})) return false;
  const int steps = static_cast<int>(std::lround((kToUm - from_um) / kStepUm));
  for (int i = 0; i <= steps; ++i) {
    const ComplexIndex index = at(series.rows, from_um + i * kStepUm);
    if (!(index.n > ratio * index.k)) return false;
  }
  return at(series.rows, kToUm).n > rise * at(series.rows, from_um).n;
}

// n next to nothing, k like the n of a transparent material.
bool lacks_n(const ImportSeries& series) {
  std::size_t visible = 0;
  for (const ImportRow& row : series.rows) {
    if (!is_visible(row)) continue;
    ++visible;
    if (row.n.value >= 0.02 || row.k.value <= 0.8) return false;
  }
  return visible > 0;
}

// Tried on the 678 tables of n and k in the database that cover 400 to 750 nm: none is refused,
// five are warned of; with n and k exchanged 314 are refused (70 of 129 of elemental metals) and 16
// more metals warned of.
void doubt_places(const ImportSeries& series, Doubts& doubts) {
  if (!series.has_n || !series.has_k) return;
  constexpr const char* kAdvice = ": are n and k in each other's place (--columns wavelength,k,n)?";
  if (lacks_n(series)) {
    doubts.implausible.push_back(std::string("n is below 0.02 and k above 0.8 in the visible") +
                                 kAdvice);
  } else if (rises_like_k(series, 0.6, 1.15, 4.0)) {
    doubts.implausible.push_back(
        std::string("n rises from 600 to 750 nm by more than 15 % although k is small, which no "
                    "transparent material's does, but the k of metals") +
        kAdvice);
  } else if (rises_like_k(series, 0.55, 1.2, 2.0)) {
    doubts.warnings.push_back(
        std::string("n rises from 550 to 750 nm by more than 20 % although k is below n/2") +
        kAdvice);
  }
}

void doubt_sampling(const ImportSeries& series, Doubts& doubts) {
  if (!series.range_nm().covers(kVisible)) return;
  std::size_t visible = 0;
  double gap = 0.0;
  for (std::size_t i = 0; i < series.rows.size(); ++i) {
    visible += is_visible(series.rows[i]);
    if (i == 0) continue;
    const double from = std::max(nm_of(series.rows[i - 1]), kVisible.min_nm);
    const double to = std::min(nm_of(series.rows[i]), kVisible.max_nm);
    gap = std::max(gap, to - from);
  }
  const std::string what = fmt::format("{} row{} in 380 to 780 nm, up to {:.4g} nm apart", visible,
                                       visible == 1 ? "" : "s", gap);
  if (visible < kFewestVisible) {
    doubts.implausible.push_back(what + ": too few to tell a colour; is the unit right (--unit)?");
  } else if (gap > kWidestVisibleGapNm) {
    doubts.warnings.push_back(what + ": between them n and k are straight lines");
  }
}

}  // namespace

void doubt_values(const ImportSeries& series, Doubts& doubts) {
  doubt_signs(series, doubts);
  doubt_magnitudes(series, doubts);
  doubt_places(series, doubts);
  doubt_sampling(series, doubts);
}

}  // namespace karat
