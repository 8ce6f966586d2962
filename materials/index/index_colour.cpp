#include "materials/index/index_colour.h"

#include <fmt/format.h>

#include <algorithm>

#include "materials/fresnel.h"
#include "materials/index/index_coverage.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

// Negative n or k, which some tables have, describe no surface.
ComplexIndex physical_index(const IndexTable& table, double nm) {
  const ComplexIndex index = table.at(nm);
  if (index.n >= 0.0 && index.k >= 0.0) return index;
  throw InputError(
      fmt::format("index table \"{}\" gives n = {:.6g}, k = {:.6g} at {:.7g} nm: a "
                  "colour needs n >= 0 and k >= 0",
                  table.provenance().name, index.n, index.k, nm));
}

// All of the visible, although a table that is_covered may lack a hundredth of a nanometre of it.
WavelengthRange summed(WavelengthRange range) {
  return {std::min(range.min_nm, kVisible.min_nm), std::max(range.max_nm, kVisible.max_nm)};
}

}  // namespace

double normal_reflectance(ComplexIndex index) {
  const double k2 = index.k * index.k;
  const double minus = index.n - 1.0, plus = index.n + 1.0;
  return (minus * minus + k2) / (plus * plus + k2);
}

std::optional<Xyz> normal_colour(const IndexTable& table) {
  if (!is_covered(table.range(), kVisible)) return std::nullopt;
  const auto reflectance = [&](double nm) { return normal_reflectance(table.at(nm)); };
  return xyz_of_reflectance(reflectance, *illuminant("D65"), observer(), summed(table.range()));
}

IndexColour index_colour(const IndexTable& table, const ColourConditions& conditions) {
  const bool held = !require_coverage(table, kVisible, RangePolicy::kClamp).empty();
  if (held && conditions.range == RangePolicy::kError) {
    throw InputError(
        fmt::format("index table \"{}\" covers {:.7g} to {:.7g} nm, but a colour needs "
                    "{:g} to {:g} nm",
                    table.provenance().name, table.range().min_nm, table.range().max_nm,
                    kVisible.min_nm, kVisible.max_nm));
  }
  const FresnelModel& model = fresnel_model(conditions.fresnel);
  const auto reflectance = [&](double nm) {
    return model.evaluate(physical_index(table, nm), conditions.cos_theta).unpolarised;
  };
  return reflectance_colour(reflectance, conditions, held ? kWholeObserver : summed(table.range()));
}

IndexColour reflectance_colour(const WavelengthFunction& reflectance,
                               const ColourConditions& conditions, WavelengthRange range) {
  const Observer& eye = observer(conditions.observer);
  const SpectrumPtr light = illuminant(conditions.illuminant);
  const Xyz xyz = xyz_of_reflectance(reflectance, *light, eye, range);
  const Xyz white = xyz_of_reflectance([](double) { return 1.0; }, *light, eye, range);
  const Matrix3 to_d65 = adaptation_to_d65(conditions.illuminant, eye);
  return {xyz, lab_of_xyz(xyz, white), linear_srgb_of_xyz(transformed(to_d65, xyz))};
}

}  // namespace karat
