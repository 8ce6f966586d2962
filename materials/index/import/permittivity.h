// The complex index of a complex permittivity.
#pragma once

#include "materials/index/index_table.h"

namespace karat {

// n + ik with (n + ik)^2 = eps1 + i eps2, on the branch n >= 0, where k has the sign of eps2: the
// one of a wave that decays in an absorbing medium (Born and Wolf, Principles of Optics, 7th
// edition, section 14.1, eqs. 15 and 16). Accurate to a few units in the last place for either sign
// of eps1; finite for finite arguments whose index is.
ComplexIndex index_of_permittivity(double eps1, double eps2);

}  // namespace karat
