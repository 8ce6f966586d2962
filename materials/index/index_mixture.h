// Index tables made from other tables: mixtures of grains, and values between measured ones.
#pragma once

#include <vector>

#include "materials/index/index_table.h"
#include "materials/mixing_rule.h"

namespace karat {

struct MixturePart {
  IndexTablePtr table;
  double volume_fraction;  // in [0, 1]; they sum to 1
};

// The permittivity at every wavelength is `rule` of those of the parts, whose own interpolation
// comes first. Known where all parts are. `host` is an index of `parts`. Throws InputError where no
// wavelength has all parts; at() does where a part has n < 0 or k < 0, or the rule diverges.
IndexTablePtr mixed_index(std::vector<MixturePart> parts, const MixingRule& rule, std::size_t host,
                          Provenance provenance);

// One of several tables of a material that differ in a number: a composition, a temperature.
struct IndexAtValue {
  IndexTablePtr table;
  double value;
};

// The permittivity is linear in `value` between the two neighbours of `at` (for Rioux's gold-silver
// alloys a third nearer to the measurement than n and k linear). `tables` has at least two, of
// strictly increasing value, and `at` lies within; throws std::invalid_argument otherwise. Known
// where both neighbours are; throws InputError where no wavelength has both.
IndexTablePtr index_between(const std::vector<IndexAtValue>& tables, double at,
                            Provenance provenance);

}  // namespace karat
