#include "materials/index/index_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "materials/index/index_coverage.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

// The one kind of table there is: a spectrum of n, perhaps one of k, and the range of both.
class SpectralIndex final : public IndexTable {
 public:
  SpectralIndex(SpectrumPtr n, SpectrumPtr k, WavelengthRange range, Provenance provenance,
                std::vector<std::string> warnings)
      : n_(std::move(n)),
        k_(std::move(k)),
        range_(range),
        provenance_(std::move(provenance)),
        warnings_(std::move(warnings)) {}

  ComplexIndex at(double wavelength_nm) const override {
    const double nm = std::clamp(wavelength_nm, range_.min_nm, range_.max_nm);
    return {(*n_)(nm), k_ ? (*k_)(nm) : 0.0};
  }
  WavelengthRange range() const override { return range_; }
  bool has_k() const override { return k_ != nullptr; }
  std::vector<SpectrumSample> n_samples() const override { return n_->samples(); }
  std::vector<SpectrumSample> k_samples() const override {
    return k_ ? k_->samples() : std::vector<SpectrumSample>();
  }
  const Provenance& provenance() const override { return provenance_; }
  const std::vector<std::string>& warnings() const override { return warnings_; }

 private:
  SpectrumPtr n_;
  SpectrumPtr k_;
  WavelengthRange range_;
  Provenance provenance_;
  std::vector<std::string> warnings_;
};

std::string text_of(WavelengthRange range) {
  return fmt::format("{:.7g} to {:.7g} nm", range.min_nm, range.max_nm);
}

// A hundredth of a nanometre, less for X-rays; at least the rounding of 0.5876 um to nanometres.
double end_tolerance_nm(double nm) { return std::max(std::min(0.01, 1e-4 * nm), 1e-12 * nm); }

// A negative k would amplify light, a negative n bend it backwards: no reflection model here holds
// for either, and replacing the value would hide that the data are wrong.
void require_physical(const IndexTable& table, ComplexIndex index, double wavelength_nm) {
  if (std::isfinite(index.n) && std::isfinite(index.k) && index.n >= 0.0 && index.k >= 0.0) return;
  throw InputError(fmt::format(
      "index table \"{}\" gives n = {:.6g}, k = {:.6g} at {:.7g} nm; rendering needs n >= 0 and "
      "k >= 0 at every wavelength of the scene: choose another table or other wavelengths",
      table.provenance().name, index.n, index.k, wavelength_nm));
}

}  // namespace

IndexTablePtr constant_index(ComplexIndex index) {
  Provenance provenance;
  provenance.name = index.k == 0.0 ? fmt::format("n = {:.6g}", index.n)
                                   : fmt::format("n = {:.6g}, k = {:.6g}", index.n, index.k);
  return index_from_spectra(constant_spectrum(index.n), constant_spectrum(index.k),
                            std::move(provenance));
}

IndexTablePtr index_from_spectra(SpectrumPtr n, SpectrumPtr k, Provenance provenance,
                                 std::vector<std::string> warnings) {
  WavelengthRange range = n->range();
  if (k) {
    range.min_nm = std::max(range.min_nm, k->range().min_nm);
    range.max_nm = std::min(range.max_nm, k->range().max_nm);
    if (range.min_nm > range.max_nm) {
      throw InputError(fmt::format("index \"{}\": n covers {}, k covers {}: no wavelength has both",
                                   provenance.name, text_of(n->range()), text_of(k->range())));
    }
  }
  return std::make_shared<SpectralIndex>(std::move(n), std::move(k), range, std::move(provenance),
                                         std::move(warnings));
}

LatticeIndex on_lattice(const IndexTable& table, const WavelengthLattice& lattice) {
  LatticeIndex result;
  result.lattice = lattice;
  for (int phase = 0; phase < kPhases; ++phase) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const double nm = lattice.wavelength_nm(lane, phase);
      const ComplexIndex index = table.at(nm);
      require_physical(table, index, nm);
      result.n[phase][lane] = static_cast<float>(index.n);
      result.k[phase][lane] = static_cast<float>(index.k);
    }
  }
  return result;
}

bool is_covered(WavelengthRange measured, WavelengthRange needed) {
  return measured.covers({needed.min_nm + end_tolerance_nm(needed.min_nm),
                          needed.max_nm - end_tolerance_nm(needed.max_nm)});
}

std::string require_coverage(const IndexTable& table, WavelengthRange needed, RangePolicy policy) {
  if (is_covered(table.range(), needed)) return "";
  const std::string gap =
      fmt::format("index table \"{}\" covers {}, but {} are asked for", table.provenance().name,
                  text_of(table.range()), text_of(needed));
  if (policy == RangePolicy::kClamp) {
    return gap + ": its end values are held (\"extrapolate\": \"clamp\")";
  }
  throw InputError(gap);
}

}  // namespace karat
