// Fresnel reflectance at chosen wavelengths and angles, in the renderer's kernel or exactly.
#pragma once

#include <vector>

#include "materials/fresnel.h"

namespace karat {

// A model prepared for a material, evaluated at wavelengths of one's own. At most kLatticeSize of
// them: they take the places of the lattice's.
class FresnelOnGrid {
 public:
  // Throws InputError where the table does not cover the wavelengths, has a negative n or k there,
  // or where there are too many of them.
  FresnelOnGrid(const FresnelModel& model, const IndexTable& table,
                const std::vector<double>& wavelengths_nm);

  // One value per wavelength, in [0, 1].
  void reflectance(double cos_theta, double* values) const;
  // False, and nothing written, where the model knows only the unpolarised value.
  bool polarised(double cos_theta, double* s, double* p) const;

 private:
  const FresnelModel& model_;
  FresnelTables tables_;
  std::size_t count_;
};

// n and k at the wavelengths, from vacuum. The same errors.
std::vector<ComplexIndex> indices_at(const IndexTable& table,
                                     const std::vector<double>& wavelengths_nm);

}  // namespace karat
