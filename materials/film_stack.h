// Thin films on a substrate, each from an index table: oxides on titanium, tarnish on silver.
#pragma once

#include <vector>

#include "materials/fresnel_table.h"
#include "materials/index/index_table.h"
#include "materials/thin_film.h"

namespace karat {

struct FilmStack {
  struct Layer {
    IndexTablePtr index;
    double thickness_nm;  // at least 0
  };
  std::vector<Layer> layers;  // in the order in which light meets them
  IndexTablePtr substrate;    // without end behind them
};

// All layers together. Fringes of thicker coats are finer than lamps and eyes resolve: they are not
// thin films.
inline constexpr double kThickestFilmsNm = 20000.0;

// The stack where a table is expected: it says where it is known, and film_stack_of() finds the
// stack in it. It has no n and k of its own: at() throws InputError. Throws InputError where no
// wavelength has all parts, or the layers exceed kThickestFilmsNm.
IndexTablePtr layered_index(FilmStack stack, Provenance provenance);

// The stack of a layered_index; nullptr for every other table.
const FilmStack* film_stack_of(const IndexTable& table);

// At one wavelength (in vacuum), from a medium of index outer_n > 0. Throws InputError where an
// index is 0 or has n < 0 or k < 0.
FilmResponse film_response(const FilmStack& stack, double outer_n, double wavelength_nm,
                           double cos_theta);

// The unpolarised reflectance at every lattice wavelength, for tabulated_fresnel(): the mean over
// the wavelength's bin where fringes of thick films change within it. Of `exterior` only n counts.
TabulatedReflectance tabulated_films(const FilmStack& stack, const IndexTable& exterior,
                                     const WavelengthLattice& lattice);

}  // namespace karat
