// Measured complex refractive indices: n + ik as a function of wavelength (k >= 0 absorbs).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "spectral/spectrum.h"

namespace karat {

struct ComplexIndex {
  double n = 1.0;
  double k = 0.0;
};

// Where a table comes from; written into every image that used it.
struct Provenance {
  std::string name;       // catalogue id "main/Au/Johnson", or what an inline value is
  std::string file;       // path of the file, empty for inline values
  std::string reference;  // the citation as the file gives it, markup removed
  std::string comments;
  std::string conditions;
};

class IndexTable {
 public:
  virtual ~IndexTable() = default;

  // n and k at a wavelength in nm, finite. Outside `range()` the end values are held; whoever needs
  // the range to hold asks first (see require_coverage). Throws InputError where a dispersion
  // formula gives no index although its range says so (n^2 < 0, a pole).
  virtual ComplexIndex at(double wavelength_nm) const = 0;

  // Where n (and k, where the table has any) were measured: the joint range.
  virtual WavelengthRange range() const = 0;

  // False where the source lists n alone; k is 0 then.
  virtual bool has_k() const = 0;

  // What was measured: the rows of n and those of k, which may reach beyond the joint range and
  // differ in their wavelengths. None where a formula, a constant or a mixture gives the values.
  virtual std::vector<SpectrumSample> n_samples() const { return {}; }
  virtual std::vector<SpectrumSample> k_samples() const { return {}; }

  virtual const Provenance& provenance() const = 0;

  // Problems of the data that do not prevent its use ("duplicate wavelength 0.45 um at row 7").
  virtual const std::vector<std::string>& warnings() const = 0;
};

using IndexTablePtr = std::shared_ptr<const IndexTable>;

// A table of one value at every wavelength: "n = 1.5".
IndexTablePtr constant_index(ComplexIndex index);

// A table from spectra of n and k (inline values of a scene, .spd file pairs); k may be null.
// Throws InputError where no wavelength has both.
IndexTablePtr index_from_spectra(SpectrumPtr n, SpectrumPtr k, Provenance provenance,
                                 std::vector<std::string> warnings = {});

// n and k at the lattice wavelengths, relative to a real exterior index per wavelength. Which
// wavelengths these are matters to those who weight them by an observer.
struct LatticeIndex {
  LatticeSpectrum n;
  LatticeSpectrum k;
  WavelengthLattice lattice = WavelengthLattice();
};
// Throws InputError where n or k is negative at a lattice wavelength (some measured tables are).
LatticeIndex on_lattice(const IndexTable& table, const WavelengthLattice& lattice);

enum class RangePolicy { kError, kClamp };

// Throws InputError naming the table, its range and the wavelengths asked for when `table` does not
// cover `needed`; under kClamp returns that sentence as a warning instead ("" when covered).
std::string require_coverage(const IndexTable& table, WavelengthRange needed, RangePolicy policy);

}  // namespace karat
