#include "materials/index_colour.h"

#include "spectral/illuminant.h"
#include "spectral/observer.h"

namespace karat {

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

}  // namespace karat
