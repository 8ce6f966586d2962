// Can an index table be trusted? What its own numbers say about that.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "materials/index/index_table.h"

namespace karat {

enum class Verdict {
  kGood,      // nothing speaks against the table
  kDoubtful,  // look at it before relying on it
  kBad,       // the numbers contradict physics, or are too few
  kUnknown,   // the table does not allow this check
};
std::string name_of(Verdict verdict);  // "good", "doubtful", "bad", "not checked"

struct IndexCheck {
  std::string name;  // "passivity"
  Verdict verdict = Verdict::kUnknown;
  std::string text;                       // one or two sentences with figures and wavelengths
  std::map<std::string, double> figures;  // the same figures, units in their names
};

// n >= 0 and k >= 0 at every row, an index wherever the range says so.
IndexCheck check_passivity(const IndexTable& table);

// How much of 380 to 780 nm is covered, with how many rows.
IndexCheck check_visible_rows(const IndexTable& table);

// What the choice of interpolation changes in the visible: the greatest difference of F0, and of
// the colour under D65 (CIEDE2000), between linear and monotone cubic; small where the samples are
// close enough. The lattice of a scene samples every (780 - 380) / 512 = 0.78 nm.
IndexCheck check_sampling(const IndexTablePtr& table);

// Rows that stand out from their neighbours: the distance of each from the cubic through the two
// rows on either side, against the median distance nearby; and jumps at repeated wavelengths. A
// true edge that the rows barely resolve stands out like a slip of typing: it is worth a look too.
IndexCheck check_smoothness(const IndexTable& table);

// Kramers-Kronig: whether n can be what k implies, with any passive absorption outside the measured
// range (materials/index/kramers_kronig.h). A narrow range allows much, and the text says how much:
// by what factor k could be wrong without being noticed.
IndexCheck check_causality(const IndexTable& table);

// All of the above, in this order.
std::vector<IndexCheck> check_index_table(const IndexTablePtr& table);

}  // namespace karat
