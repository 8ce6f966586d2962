#include "materials/index/import/header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "materials/index/import/text_lines.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

struct KnownName {
  std::string_view name;  // in lower case, letters, digits and apostrophes alone
  Quantity quantity;
  AxisKind axis = AxisKind::kUnknown;
};
constexpr Quantity kAxis = Quantity::kAxis, kN = Quantity::kN, kK = Quantity::kK,
                   kEps1 = Quantity::kEps1, kEps2 = Quantity::kEps2;
constexpr AxisKind kLength = AxisKind::kWavelength, kEnergy = AxisKind::kEnergy,
                   kNumber = AxisKind::kWavenumber;
constexpr std::array<KnownName, 88> kNames{{
    {"wavelength", kAxis, kLength},
    {"wavelengths", kAxis, kLength},
    {"vacuumwavelength", kAxis, kLength},
    {"wave", kAxis, kLength},
    {"wavelen", kAxis, kLength},
    {"wlen", kAxis, kLength},
    {"wvl", kAxis, kLength},
    {"wl", kAxis, kLength},
    {"lambda", kAxis, kLength},
    {"lam", kAxis, kLength},
    {"\u03bb", kAxis, kLength},
    {"wellenl\u00e4nge", kAxis, kLength},
    {"wellenlaenge", kAxis, kLength},
    {"longueurd'onde", kAxis, kLength},
    {"longituddeonda", kAxis, kLength},
    {"energy", kAxis, kEnergy},
    {"photonenergy", kAxis, kEnergy},
    {"e", kAxis, kEnergy},
    {"h\u03bd", kAxis, kEnergy},
    {"hv", kAxis, kEnergy},
    {"hnu", kAxis, kEnergy},
    {"wavenumber", kAxis, kNumber},
    {"wavenumbers", kAxis, kNumber},
    {"wn", kAxis, kNumber},
    {"n", kN},
    {"nr", kN},
    {"nreal", kN},
    {"realn", kN},
    {"ren", kN},
    {"refractiveindex", kN},
    {"refractiveindexn", kN},
    {"nrefractiveindex", kN},
    {"indexofrefraction", kN},
    {"realindex", kN},
    {"indexn", kN},
    {"ior", kN},
    {"brechungsindex", kN},
    {"brechzahl", kN},
    {"eta", kN},
    {"\u03b7", kN},
    {"k", kK},
    {"kappa", kK},
    {"\u03ba", kK},
    {"ki", kK},
    {"ni", kK},
    {"nimag", kK},
    {"imagn", kK},
    {"imn", kK},
    {"imagindex", kK},
    {"extinction", kK},
    {"extinctionk", kK},
    {"extinctioncoefficient", kK},
    {"extinctioncoefficientk", kK},
    {"kextinctioncoefficient", kK},
    {"extcoeff", kK},
    {"extinktionskoeffizient", kK},
    {"eps1", kEps1},
    {"epsilon1", kEps1},
    {"e1", kEps1},
    {"\u03b51", kEps1},
    {"eps'", kEps1},
    {"epsilon'", kEps1},
    {"\u03b5'", kEps1},
    {"epsr", kEps1},
    {"er", kEps1},
    {"epsre", kEps1},
    {"reeps", kEps1},
    {"epsreal", kEps1},
    {"realeps", kEps1},
    {"reepsilon", kEps1},
    {"epsilonr", kEps1},
    {"epsilonreal", kEps1},
    {"eps2", kEps2},
    {"epsilon2", kEps2},
    {"e2", kEps2},
    {"\u03b52", kEps2},
    {"eps''", kEps2},
    {"epsilon''", kEps2},
    {"\u03b5''", kEps2},
    {"epsi", kEps2},
    {"ei", kEps2},
    {"epsim", kEps2},
    {"imeps", kEps2},
    {"epsimag", kEps2},
    {"imageps", kEps2},
    {"imepsilon", kEps2},
    {"epsiloni", kEps2},
    {"epsilonimag", kEps2},
}};

std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) || byte >= 0x80 || c == '\'') {
      plain += static_cast<char>(std::tolower(byte));
    }
  }
  return plain;
}

ColumnMeaning known_meaning(std::string_view name) {
  const std::string plain = plain_name(name);
  for (const KnownName& known : kNames) {
    if (known.name == plain) return {known.quantity, known.axis, std::nullopt};
  }
  return {};
}

// An axis with a unit: "Wavelength" and "nm". A unit behind anything else says nothing.
ColumnMeaning axis_meaning(std::string_view name, std::string_view unit) {
  const auto known = axis_unit(unit);
  if (!known) return {};
  ColumnMeaning meaning = known_meaning(name);
  if (meaning.quantity != Quantity::kAxis) return {};
  meaning.unit = known;
  return meaning;
}

}  // namespace

std::string quantity_name(Quantity quantity) {
  switch (quantity) {
    case Quantity::kAxis:
      return "wavelength";
    case Quantity::kN:
      return "n";
    case Quantity::kK:
      return "k";
    case Quantity::kEps1:
      return "eps1";
    case Quantity::kEps2:
      return "eps2";
  }
  return "";
}

ColumnMeaning column_meaning(std::string_view name) {
  name = trimmed(name);
  if (const ColumnMeaning meaning = known_meaning(name); meaning.quantity) return meaning;
  // A unit alone: "nm". ("A" alone could be anything, absorbance most likely.)
  if (const auto unit = axis_unit(name); unit && name.size() > 1) {
    return {Quantity::kAxis,
            unit == AxisUnit::kEv      ? kEnergy
            : unit == AxisUnit::kPerCm ? kNumber
                                       : kLength,
            unit};
  }
  const std::size_t open = name.find_first_of("([{");
  if (open != std::string_view::npos) {
    const std::size_t close = name.find_first_of(")]}", open);
    const std::string_view inside = name.substr(open + 1, std::min(close, name.size()) - open - 1);
    const ColumnMeaning meaning = axis_meaning(name.substr(0, open), inside);
    if (meaning.quantity) return meaning;
    // "n (-)", "n [1]": a unit of something without one.
    if (plain_name(inside).empty() || inside == "1") return known_meaning(name.substr(0, open));
  }
  for (const char before_unit : {'/', '_', ' ', ',', '.'}) {  // "1/cm" has a slash of its own
    for (std::size_t at = name.find(before_unit); at != std::string_view::npos;
         at = name.find(before_unit, at + 1)) {
      const ColumnMeaning meaning = axis_meaning(name.substr(0, at), name.substr(at + 1));
      if (meaning.quantity) return meaning;
    }
  }
  return {};
}

std::vector<std::string> header_names(std::string_view line, char separator, std::size_t count) {
  const IndexSource nowhere{"", line};
  std::vector<std::string> names;
  try {
    for (const std::string_view cell : cells_of(line, separator, nowhere, 0)) {
      const bool continues = separator == kBlanks && !names.empty() &&
                             std::string_view("([{/").find(cell.empty() ? 'x' : cell.front()) !=
                                 std::string_view::npos;
      if (continues) {
        names.back().append(" ").append(cell);
      } else {
        names.emplace_back(cell);
      }
    }
  } catch (const InputError&) {
    return {};  // a long sentence is no header
  }
  // "Photon energy [eV] n k" has a name of two words.
  while (separator == kBlanks && names.size() > count && !column_meaning(names[0]).quantity &&
         column_meaning(names[0] + " " + names[1]).quantity) {
    names[0] += " " + names[1];
    names.erase(names.begin() + 1);
  }
  if (names.size() < count) return {};
  return names;
}

ColumnNames column_names(const std::vector<std::string>& names) {
  ColumnNames columns;
  for (const std::string& name : names) {
    const ColumnMeaning meaning = column_meaning(name);
    if (name != "-" && !meaning.quantity) {
      throw InputError("--columns", quoted_cell(name),
                       "unknown; allowed are wavelength (or energy, wavenumber), n, k, eps1, eps2, "
                       "and - for a column to skip");
    }
    columns.push_back(meaning.quantity);
  }
  return columns;
}

}  // namespace karat
