#include "materials/index/index_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "materials/index/index_coverage.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

struct Negative {
  std::size_t count = 0;
  double first_nm = 0.0, least = 0.0;
};

Negative negative_rows(const std::vector<SpectrumSample>& rows) {
  Negative found;
  for (const SpectrumSample& row : rows) {
    if (!(row.value < 0.0)) continue;
    if (found.count++ == 0) found.first_nm = row.nm;
    found.least = std::min(found.least, row.value);
  }
  return found;
}

std::string sentence(const Negative& found, const char* quantity, const char* meaning) {
  if (found.count == 0) return "";
  return fmt::format("{} is negative in {} row{}, first at {:.6g} nm, down to {:.4g}: {}. ",
                     quantity, found.count, found.count == 1 ? "" : "s", found.first_nm,
                     found.least, meaning);
}

// The first wavelength of a formula's range at which it gives no index; 0 where there is none.
double first_gap_nm(const IndexTable& table) {
  constexpr int kProbes = 400;
  const WavelengthRange range = table.range();
  for (int i = 0; i <= kProbes && range.width_nm() < 1e12; ++i) {
    const double nm = range.min_nm + range.width_nm() * i / kProbes;
    try {
      table.at(nm);
    } catch (const InputError&) {
      return nm;
    }
  }
  return 0.0;
}

std::size_t rows_within(const std::vector<SpectrumSample>& rows, WavelengthRange range) {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [&](const SpectrumSample& row) {
        return range.covers({row.nm, row.nm});
      }));
}

}  // namespace

std::string name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kGood:
      return "good";
    case Verdict::kDoubtful:
      return "doubtful";
    case Verdict::kBad:
      return "bad";
    case Verdict::kUnknown:
      return "not checked";
  }
  return "not checked";
}

IndexCheck check_passivity(const IndexTable& table) {
  IndexCheck check{"passivity", Verdict::kGood, "", {}};
  const Negative n = negative_rows(table.n_samples()), k = negative_rows(table.k_samples());
  const double gap = first_gap_nm(table);
  check.figures = {{"negative_n_rows", static_cast<double>(n.count)},
                   {"negative_k_rows", static_cast<double>(k.count)}};
  check.text = sentence(n, "n", "only metamaterials have that") +
               sentence(k, "k", "the material would amplify light");
  if (gap > 0.0) check.text += fmt::format("The formula gives no index at {:.6g} nm. ", gap);
  if (check.text.empty()) {
    check.text = table.has_k() ? "n and k are nowhere negative" : "n is nowhere negative";
  } else {
    check.verdict = Verdict::kBad;
    check.text += "Rendering refuses these wavelengths";
  }
  return check;
}

IndexCheck check_visible_rows(const IndexTable& table) {
  IndexCheck check{"visible", Verdict::kGood, "", {}};
  // Fewer do not show the edge of a colour: copper's takes 40 nm.
  constexpr std::size_t kFewRows = 10;
  const WavelengthRange range = table.range();
  const std::size_t rows =
      std::max(rows_within(table.n_samples(), kVisible), rows_within(table.k_samples(), kVisible));
  const bool tabulated = !table.n_samples().empty() || !table.k_samples().empty();
  const std::string what =
      tabulated ? fmt::format("{} rows in 380 to 780 nm", rows) : "a formula, without rows";
  if (tabulated) check.figures["rows"] = static_cast<double>(rows);
  if (is_covered(range, kVisible)) {
    check.text = what + ", covered whole";
  } else {
    check.verdict = Verdict::kDoubtful;
    check.text = fmt::format(
        "{}; measured from {:.6g} to {:.6g} nm alone: a scene needs other "
        "wavelengths, or \"extrapolate\": \"clamp\"",
        what, range.min_nm, range.max_nm);
  }
  if (tabulated && rows < kFewRows) {
    check.verdict = rows < 2 ? Verdict::kBad : Verdict::kDoubtful;
    check.text += "; too few to show how the colour turns";
  }
  return check;
}

std::vector<IndexCheck> check_index_table(const IndexTablePtr& table) {
  return {check_passivity(*table), check_visible_rows(*table), check_sampling(table),
          check_smoothness(*table), check_causality(*table)};
}

}  // namespace karat
