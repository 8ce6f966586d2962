#include "materials/index_colour.h"

#include <fmt/format.h>

#include "materials/fresnel.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

// What a surface of the table reflects; negative n or k, which some tables have, describe none.
double exact_reflectance(const IndexTable& table, double nm, double cos_theta) {
  static const FresnelModel& exact = *Registry<FresnelModel>::instance().find("exact");
  const ComplexIndex index = table.at(nm);
  if (index.n < 0.0 || index.k < 0.0) {
    throw InputError(
        fmt::format("index table \"{}\" gives n = {:.6g}, k = {:.6g} at {:.7g} nm: a "
                    "colour needs n >= 0 and k >= 0",
                    table.provenance().name, index.n, index.k, nm));
  }
  return exact.evaluate(index, cos_theta).unpolarised;
}

}  // namespace

double normal_reflectance(ComplexIndex index) {
  const double k2 = index.k * index.k;
  const double minus = index.n - 1.0, plus = index.n + 1.0;
  return (minus * minus + k2) / (plus * plus + k2);
}

std::optional<Xyz> normal_colour(const IndexTable& table) {
  if (!table.range().covers(kVisible)) return std::nullopt;
  const auto reflectance = [&](double nm) { return normal_reflectance(table.at(nm)); };
  return xyz_of_reflectance(reflectance, *illuminant("D65"), observer(), table.range());
}

IndexColour index_colour(const IndexTable& table, const ColourConditions& conditions) {
  const bool held = !require_coverage(table, kVisible, conditions.range).empty();
  return reflectance_colour(
      [&](double nm) { return exact_reflectance(table, nm, conditions.cos_theta); }, conditions,
      held ? kWholeObserver : table.range());
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
