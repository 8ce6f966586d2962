#include "materials/index/index_interpolation.h"

#include <utility>

#include "spectral/monotone_cubic.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

// n or k of a table as a spectrum, with the table's samples of it.
class Part final : public Spectrum {
 public:
  Part(IndexTablePtr table, double ComplexIndex::*part, std::vector<SpectrumSample> samples)
      : table_(std::move(table)), part_(part), samples_(std::move(samples)) {}

  double operator()(double nm) const override { return table_->at(nm).*part_; }
  WavelengthRange range() const override { return table_->range(); }
  std::string description() const override { return table_->provenance().name; }
  std::vector<SpectrumSample> samples() const override { return samples_; }

 private:
  IndexTablePtr table_;
  double ComplexIndex::*part_;
  std::vector<SpectrumSample> samples_;
};

SpectrumPtr cubic_part(const IndexTablePtr& table, double ComplexIndex::*part,
                       std::vector<SpectrumSample> samples) {
  return monotone_cubic(std::make_shared<Part>(table, part, std::move(samples)));
}

}  // namespace

const std::vector<std::string>& interpolation_names() {
  static const std::vector<std::string> names{"linear", "monotone-cubic"};
  return names;
}

Interpolation interpolation_named(const std::string& name) {
  if (name == "linear") return Interpolation::kLinear;
  if (name == "monotone-cubic") return Interpolation::kMonotoneCubic;
  throw InputError(unknown_name_message("interpolation", name, interpolation_names()));
}

std::string name_of(Interpolation interpolation) {
  return interpolation_names()[interpolation == Interpolation::kLinear ? 0 : 1];
}

std::string description_of(Interpolation interpolation) {
  return interpolation == Interpolation::kLinear
             ? "linear in wavelength on n and k"
             : "monotone cubic in wavelength on n and k (Steffen 1990)";
}

IndexTablePtr interpolated(const IndexTablePtr& table, Interpolation interpolation) {
  if (interpolation == Interpolation::kLinear) return table;
  if (table->n_samples().empty() && table->k_samples().empty()) return table;
  return index_from_spectra(
      cubic_part(table, &ComplexIndex::n, table->n_samples()),
      table->has_k() ? cubic_part(table, &ComplexIndex::k, table->k_samples()) : nullptr,
      table->provenance(), table->warnings());
}

}  // namespace karat
