// Densities and atomic masses: what turns parts by mass or by atoms into parts by volume.
#pragma once

#include <optional>
#include <string>

namespace karat {

struct Element {
  std::string symbol;
  double density_g_cm3;  // solid (mercury: liquid), near 25 degrees Celsius
  double atomic_mass;    // g/mol
};

// Nothing where data/elements/elements.json does not list the symbol.
std::optional<Element> find_element(const std::string& symbol);

// Of a table's name "main/Au/Johnson" or "main/Au/nk/Johnson.yml": Au; nothing where the book is
// not an element.
std::optional<Element> element_of_table(const std::string& name);

// Where the numbers come from.
std::string elements_source();

}  // namespace karat
