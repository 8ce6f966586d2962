// Fresnel reflectance at chosen wavelengths and angles, in the renderer's kernel or exactly.
#pragma once

#include <vector>

#include "materials/fresnel.h"

namespace karat {

// A model prepared for a material, evaluated at wavelengths of one's own.
//
// Where the model looks at one wavelength at a time these take the places of the lattice's; at most
// kLatticeSize are allowed. A model that looks at a material as a whole is prepared on the lattice
// that a render has, of the visible range and whatever is asked for beyond it, and read linearly
// between the lattice's wavelengths.
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
  struct Place {  // (1 - t) of the slot and t of the next one; slots count through phases of lanes
    std::size_t slot = 0, next = 0;
    double t = 0.0;
  };
  LatticeIndex packed(const IndexTable& table, const std::vector<double>& wavelengths_nm);
  LatticeIndex spread(const IndexTable& table, const std::vector<double>& wavelengths_nm);
  void read(const std::vector<float>& slots, double* values) const;

  const FresnelModel& model_;
  std::vector<Place> places_;
  std::size_t phases_ = 0;  // that hold places
  FresnelTables tables_;
};

// n and k at the wavelengths, from vacuum. The same errors.
std::vector<ComplexIndex> indices_at(const IndexTable& table,
                                     const std::vector<double>& wavelengths_nm);

}  // namespace karat
