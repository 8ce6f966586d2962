// Do n and k belong together? Kramers-Kronig over a finite range.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "materials/index/index_check.h"
#include "materials/index/kramers_kronig.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

// Shares of |1 + n + ik|, found by running the check over the tables that ship with Karat: those
// fitted with a causal model stay below 0.001, Johnson and Christy's noble metals, measured
// directly, below 0.017, and tables put together from several sources reach 0.1.
constexpr double kConsistent = 0.02, kInconsistent = 0.05;
constexpr double kTransparent = 0.01;  // a k below hardly adds to n
constexpr double kHcNm = 1239.841984;  // eV nm
constexpr std::size_t kMostEnergies = 200;
constexpr int kOctaveSteps = 16;

// Wavelengths, ascending: the table's rows where there are enough, otherwise evenly in their
// logarithm; of very many those that are far enough apart.
std::vector<double> wavelengths_of(const IndexTable& table) {
  const WavelengthRange range = table.range();
  std::vector<double> nm;
  const auto take = [&](const std::vector<SpectrumSample>& rows) {
    for (const SpectrumSample& row : rows) {
      if (range.covers({row.nm, row.nm})) nm.push_back(row.nm);
    }
  };
  take(table.n_samples());
  take(table.k_samples());
  if (nm.empty()) {
    for (int i = 0; i <= 100; ++i) {
      nm.push_back(range.min_nm * std::pow(range.max_nm / range.min_nm, i / 100.0));
    }
  }
  std::sort(nm.begin(), nm.end());
  const double apart = std::pow(nm.back() / nm.front(), 1.0 / kMostEnergies);
  std::vector<double> chosen;
  for (const double at : nm) {
    const bool dense = nm.size() > kMostEnergies;
    if (chosen.empty() || at >= chosen.back() * (dense ? apart : 1.0 + 1e-9)) chosen.push_back(at);
  }
  return chosen;
}

EnergyIndex energy_index(const IndexTable& table) {
  EnergyIndex index;
  std::vector<double> nm = wavelengths_of(table);
  for (auto it = nm.rbegin(); it != nm.rend(); ++it) {
    const ComplexIndex value = table.at(*it);
    index.energy_ev.push_back(kHcNm / *it);
    index.n.push_back(value.n);
    index.k.push_back(value.k);
  }
  return index;
}

// The factor, 1 or beyond in steps of `ratio`, up to which k could be changed unnoticed.
double unnoticed(const EnergyIndex& index, double ratio, double limit) {
  double factor = 1.0;
  for (int i = 0; i < kOctaveSteps; ++i) {
    if (kramers_kronig_fit(index, factor * ratio).rms > limit) return factor;
    factor *= ratio;
  }
  return factor;
}

struct Largest {
  double difference = 0.0, nm = 0.0, measured = 0.0, implied = 0.0;
};

Largest largest_difference(const EnergyIndex& index, const KramersKronigFit& fit) {
  Largest largest;
  double share = -1.0;
  for (std::size_t i = 0; i < index.n.size(); ++i) {
    const double difference = std::abs(index.n[i] - fit.n[i]);
    const double here = difference / std::hypot(index.n[i] + 1.0, index.k[i], 1e-3);
    if (!(here > share)) continue;
    share = here;
    largest = {difference, kHcNm / index.energy_ev[i], index.n[i], fit.n[i]};
  }
  return largest;
}

std::string resolution_text(double low, double high, bool consistent) {
  const bool no_low = low<0.51, no_high = high> 1.95;
  if (!consistent) return "";
  if (no_low && no_high) {
    return "; the range is too narrow to tell more: k could be half or twice as large";
  }
  return fmt::format("; a k wrong by a factor {}{}{} would have been noticed",
                     no_low ? "" : fmt::format("below {:.2f}", low),
                     no_low || no_high ? "" : " or ",
                     no_high ? "" : fmt::format("above {:.2f}", high));
}

IndexCheck checked(const IndexTable& table, const EnergyIndex& index) {
  IndexCheck check{"causality", Verdict::kGood, "", {}};
  const KramersKronigFit fit = kramers_kronig_fit(index);
  const Largest largest = largest_difference(index, fit);
  // Without absorption n is smooth, and shipped glasses leave less than 0.0002.
  const bool transparent = *std::max_element(index.k.begin(), index.k.end()) < kTransparent;
  const double strictness = transparent ? 0.1 : 1.0;
  check.verdict = fit.rms < strictness * kConsistent     ? Verdict::kGood
                  : fit.rms < strictness * kInconsistent ? Verdict::kDoubtful
                                                         : Verdict::kBad;
  check.figures = {{"rms_share", fit.rms},
                   {"largest_difference", largest.difference},
                   {"largest_difference_at_nm", largest.nm}};
  check.text = fmt::format(
      "{} differs from the n that {} implies (Kramers-Kronig, any passive absorption outside the "
      "range) by {:.2g} % of |1 + n + ik| rms, most at {:.6g} nm: {:.4g} against {:.4g}",
      "n", table.has_k() ? "k" : "k = 0", 100.0 * fit.rms, largest.nm, largest.measured,
      largest.implied);
  if (!table.has_k()) return check;
  if (transparent) {
    check.text += "; k is too small to be tested";
    return check;
  }
  const double step = std::pow(2.0, 1.0 / kOctaveSteps);
  const double limit = std::max(kConsistent, 1.5 * fit.rms);
  const double low = unnoticed(index, 1.0 / step, limit), high = unnoticed(index, step, limit);
  check.figures["k_factor_low"] = low;
  check.figures["k_factor_high"] = high;
  check.text += resolution_text(low, high, check.verdict == Verdict::kGood);
  if (check.verdict == Verdict::kGood && low < 0.51 && high > 1.95) {
    check.verdict = Verdict::kUnknown;
  }
  return check;
}

}  // namespace

IndexCheck check_causality(const IndexTable& table) {
  constexpr std::size_t kFewest = 8;
  IndexCheck check{"causality", Verdict::kUnknown, "", {}};
  const WavelengthRange range = table.range();
  if (!(range.min_nm > 0.0 && range.width_nm() > 0.0 && range.max_nm < 1e15)) {
    check.text = "one wavelength alone, or a constant";
    return check;
  }
  try {
    const EnergyIndex index = energy_index(table);
    if (index.n.size() < kFewest) {
      check.text = fmt::format("{} rows; at least {} are needed", index.n.size(), kFewest);
      return check;
    }
    return checked(table, index);
  } catch (const InputError& error) {
    check.text = error.what();
    return check;
  }
}

}  // namespace karat
