// What a reader of measured tables is: one file format, one .cpp in this folder, ending in
//   KARAT_REGISTER(IndexFormat, "sopra", Sopra);
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "materials/index/import/axis.h"
#include "spectral/support/registry.h"

namespace karat {

// A file's text, whole, and what it is called in messages.
struct IndexSource {
  std::string file;
  std::string_view text;
};

// What a number of a row means.
enum class Quantity { kAxis, kN, kK, kEps1, kEps2 };
std::string quantity_name(Quantity quantity);

// How the axis was called: a wavelength cannot be in eV.
enum class AxisKind { kUnknown, kWavelength, kEnergy, kWavenumber };

struct RawRow {
  std::size_t line = 0;  // of the file, from 1
  std::array<WrittenNumber, 3> numbers;
};

// Rows in the file's own order and unit; the axis first, then one or two quantities.
struct RawBlock {
  std::vector<Quantity> quantities;
  std::vector<RawRow> rows;
};

// What the file says, before it is judged.
struct RawTable {
  std::string description;  // "comma-separated text; column 1 wavelength, 2 n, 3 k"
  AxisKind axis = AxisKind::kUnknown;
  std::optional<AxisUnit> unit;
  std::string unit_source;  // "line 1", "the SOPRA header"
  std::vector<RawBlock> blocks;
  std::vector<std::string> comments;  // the file's own, without their markers
  std::vector<std::string> warnings;
};

// A column that the caller names: nothing for one that is to be skipped.
using ColumnNames = std::vector<std::optional<Quantity>>;

inline constexpr std::size_t kMostImportRows = 1'000'000;

class IndexFormat {
 public:
  virtual ~IndexFormat() = default;
  // How sure the format is that the file is its own: 0 is not, 1 takes any text; the highest reads.
  virtual int likeness(const IndexSource& source) const = 0;
  // For people: "SOPRA .nk".
  virtual std::string title() const = 0;
  // Throws InputError naming file, line and column, what was found and what is allowed.
  virtual RawTable read(const IndexSource& source, const ColumnNames& columns) const = 0;
  // The text itself is a table of the database and is taken over as it stands; read() is not used.
  virtual bool is_database() const { return false; }
};

}  // namespace karat
