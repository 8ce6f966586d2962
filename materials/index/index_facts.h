// What a search needs to know of one index table.
#pragma once

#include <cstddef>
#include <string>

#include "materials/index/index_table.h"

namespace karat {

struct IndexFacts {
  std::string kind;         // "nk", "n", "k" (no material: n is missing), "" for an unreadable file
  std::string form;         // "tabulated", "formula 2", "formula 2, tabulated k"
  std::size_t samples = 0;  // rows of n (of k where there is no n), 0 for a formula
  WavelengthRange range;    // of n and k jointly
  bool metal = false;       // see looks_metallic
  std::string reference, comments, conditions;
  std::string problem;  // why the file gives no table; "" mostly
};

// Reads a file of the database; never throws for what is in it.
IndexFacts index_facts(const std::string& file, const std::string& name);

// A metal by its optics: k > n/2 at nine of ten wavelengths from 380 to 780 nm and a mean F0 of at
// least 0.4 there; at least half of these wavelengths must be measured. Of the 749 tabulated n, k
// in the database that allow the question it accepts all elemental metals (W, Mo, V and Be too,
// whose k is below n) except implausible Zn/Querry, films of Zr and one axis of Os, and refuses
// graphite; it also accepts semimetals (PtSe2, crystalline GeSbTe) and evaporated Ge.
bool looks_metallic(const IndexTable& table);

}  // namespace karat
