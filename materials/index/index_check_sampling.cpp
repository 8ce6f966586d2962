// Are the samples of a table close enough? Where they are, it does not matter how they are joined.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "materials/index/index_check.h"
#include "materials/index/index_colour.h"
#include "materials/index/index_interpolation.h"
#include "spectral/illuminant.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

// Under 0.5 two colours side by side look the same to nearly everybody; 2 is seen at a glance.
constexpr double kUnseen = 0.5, kSeen = 2.0;
// The same for reflectances where no colour can be made: steps of an 8-bit image are 1/255.
constexpr double kUnseenReflectance = 0.002, kSeenReflectance = 0.01;

struct Gap {
  double width_nm = 0.0, from_nm = 0.0;
};

Gap largest_gap(const std::vector<SpectrumSample>& rows, WavelengthRange within) {
  Gap gap;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double low = std::max(rows[i - 1].nm, within.min_nm);
    const double high = std::min(rows[i].nm, within.max_nm);
    if (high > low && rows[i].nm - rows[i - 1].nm > gap.width_nm) {
      gap = {rows[i].nm - rows[i - 1].nm, rows[i - 1].nm};
    }
  }
  return gap;
}

struct Difference {
  double reflectance = 0.0, at_nm = 0.0;
};

Difference largest_difference(const IndexTable& a, const IndexTable& b, WavelengthRange range) {
  Difference largest;
  for (int i = 0; i <= kLatticeSize; ++i) {
    const double nm = range.min_nm + range.width_nm() * i / kLatticeSize;
    const double difference = std::abs(normal_reflectance(a.at(nm)) - normal_reflectance(b.at(nm)));
    if (difference > largest.reflectance) largest = {difference, nm};
  }
  return largest;
}

// CIEDE2000 between the colours at normal incidence; negative where there are none.
double colour_difference(const IndexTable& a, const IndexTable& b) {
  const auto xyz_a = normal_colour(a), xyz_b = normal_colour(b);
  if (!xyz_a || !xyz_b) return -1.0;
  const Xyz white = white_xyz("D65");
  return delta_e_2000(lab_of_xyz(*xyz_a, white), lab_of_xyz(*xyz_b, white));
}

Verdict verdict_of(double value, double good, double bad) {
  return value < good ? Verdict::kGood : value < bad ? Verdict::kDoubtful : Verdict::kBad;
}

}  // namespace

IndexCheck check_sampling(const IndexTablePtr& table) {
  IndexCheck check{"sampling", Verdict::kUnknown, "", {}};
  const WavelengthRange range{std::max(kVisible.min_nm, table->range().min_nm),
                              std::min(kVisible.max_nm, table->range().max_nm)};
  if (table->n_samples().empty() && table->k_samples().empty()) {
    check.text = "a formula: known at every wavelength";
    check.verdict = Verdict::kGood;
    return check;
  }
  if (!(range.width_nm() > 0.0)) {
    check.text = "no two wavelengths of 380 to 780 nm are covered";
    return check;
  }
  const auto n_gap = largest_gap(table->n_samples(), range);
  const auto k_gap = largest_gap(table->k_samples(), range);
  const Gap gap = n_gap.width_nm > k_gap.width_nm ? n_gap : k_gap;
  try {
    const IndexTablePtr cubic = interpolated(table, Interpolation::kMonotoneCubic);
    const Difference difference = largest_difference(*table, *cubic, range);
    const double delta_e = colour_difference(*table, *cubic);
    check.verdict = delta_e >= 0.0
                        ? verdict_of(delta_e, kUnseen, kSeen)
                        : verdict_of(difference.reflectance, kUnseenReflectance, kSeenReflectance);
    check.text = fmt::format(
        "rows up to {:.3g} nm apart (above {:.6g} nm; the lattice: {:.2g} nm); linear and "
        "monotone cubic differ by up to {:.2g} in F0 (at {:.0f} nm)",
        gap.width_nm, gap.from_nm, kVisible.width_nm() / kLatticeSize, difference.reflectance,
        difference.at_nm);
    if (delta_e >= 0.0) check.text += fmt::format(", by {:.2g} CIEDE2000 in colour", delta_e);
    check.figures = {{"largest_gap_nm", gap.width_nm},
                     {"gap_from_nm", gap.from_nm},
                     {"f0_difference", difference.reflectance},
                     {"f0_difference_at_nm", difference.at_nm}};
    if (delta_e >= 0.0) check.figures["delta_e_2000"] = delta_e;
  } catch (const InputError& error) {
    check.text = error.what();
  }
  return check;
}

}  // namespace karat
