#include "apps/karat/nk/index_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "materials/fresnel.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

std::vector<double> wavelengths_of(const std::vector<SpectrumSample>& rows, WavelengthRange range) {
  std::vector<double> nm;
  for (const SpectrumSample& row : rows) {
    if (!range.covers({row.nm, row.nm})) continue;
    // Where the value jumps, its end below the jump is a point too.
    if (!nm.empty() && nm.back() == row.nm) {
      nm.back() = std::nextafter(row.nm, 0.0);
    }
    nm.push_back(row.nm);
  }
  return nm;
}

std::vector<std::size_t> places_of(const std::vector<double>& rows, const std::vector<double>& nm) {
  std::vector<std::size_t> places;
  for (const double row : rows) {
    const auto at = std::lower_bound(nm.begin(), nm.end(), row);
    places.push_back(static_cast<std::size_t>(at - nm.begin()));
  }
  return places;
}

void add_values(IndexCurves& curves, const IndexTable& table, const FresnelModel& exact, double nm,
                double cos_theta) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  curves.nm.push_back(nm);
  ComplexIndex index{kNone, kNone};
  FresnelModel::Scalar reflected{kNone, kNone, kNone};
  try {
    index = table.at(nm);
    // Of gain and of negative indices the formula makes no reflectance.
    if (index.n >= 0.0 && index.k >= 0.0) reflected = exact.evaluate(index, cos_theta);
  } catch (const InputError&) {  // a formula's gap
  }
  curves.n.push_back(index.n);
  curves.k.push_back(table.has_k() ? index.k : kNone);
  curves.r.push_back(reflected.unpolarised);
  curves.rs.push_back(reflected.s.value_or(kNone));
  curves.rp.push_back(reflected.p.value_or(kNone));
}

}  // namespace

IndexCurves index_curves(const IndexTable& table, WavelengthRange range, double angle_deg,
                         int count, bool log) {
  IndexCurves curves;
  const double low = std::max(range.min_nm, table.range().min_nm);
  const double high = std::min(range.max_nm, table.range().max_nm);
  if (!(low <= high)) return curves;
  const std::vector<double> n_nm = wavelengths_of(table.n_samples(), {low, high});
  const std::vector<double> k_nm = wavelengths_of(table.k_samples(), {low, high});
  std::vector<double> nm = n_nm;
  nm.insert(nm.end(), k_nm.begin(), k_nm.end());
  for (int i = 0; i <= count; ++i) {
    const double share = static_cast<double>(i) / count;
    nm.push_back(i == count ? high
                 : log      ? low * std::pow(high / low, share)
                            : low + (high - low) * share);
  }
  std::sort(nm.begin(), nm.end());
  nm.erase(std::unique(nm.begin(), nm.end()), nm.end());
  const FresnelModel& exact = *Registry<FresnelModel>::instance().find("exact");
  const double cos_theta = std::cos(angle_deg * std::numbers::pi / 180.0);
  for (const double at : nm) add_values(curves, table, exact, at, cos_theta);
  std::vector<double> both = n_nm;
  if (table.has_k()) {
    both.clear();
    std::set_intersection(n_nm.begin(), n_nm.end(), k_nm.begin(), k_nm.end(),
                          std::back_inserter(both));
  }
  curves.n_rows = places_of(n_nm, nm);
  curves.k_rows = places_of(k_nm, nm);
  curves.r_rows = places_of(both, nm);
  return curves;
}

}  // namespace karat
