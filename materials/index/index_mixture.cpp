#include "materials/index/index_mixture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "materials/permittivity.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

WavelengthRange common_range(const std::vector<MixturePart>& parts) {
  WavelengthRange range = parts.front().table->range();
  for (const MixturePart& part : parts) {
    const WavelengthRange known = part.table->range();
    if (known.min_nm > range.max_nm || known.max_nm < range.min_nm) {
      throw InputError(fmt::format(
          "\"{}\" covers {:.7g} to {:.7g} nm, the others {:.7g} to {:.7g} nm: no "
          "wavelength has all of them",
          part.table->provenance().name, known.min_nm, known.max_nm, range.min_nm, range.max_nm));
    }
    range.min_nm = std::max(range.min_nm, known.min_nm);
    range.max_nm = std::min(range.max_nm, known.max_nm);
  }
  return range;
}

class MixedIndex final : public IndexTable {
 public:
  MixedIndex(std::vector<MixturePart> parts, const MixingRule& rule, std::size_t host,
             Provenance provenance)
      : parts_(std::move(parts)),
        rule_(rule),
        host_(host),
        provenance_(std::move(provenance)),
        range_(common_range(parts_)) {}

  ComplexIndex at(double wavelength_nm) const override {
    const double nm = std::clamp(wavelength_nm, range_.min_nm, range_.max_nm);
    std::vector<MixingPart> at_nm;
    for (const MixturePart& part : parts_) {
      const ComplexIndex index = part.table->at(nm);
      if (!(index.n >= 0.0 && index.k >= 0.0)) {
        throw InputError(
            fmt::format("\"{}\" gives n = {:.6g}, k = {:.6g} at {:.7g} nm; a part of "
                        "a mixture needs n >= 0 and k >= 0",
                        part.table->provenance().name, index.n, index.k, nm));
      }
      at_nm.push_back({part.volume_fraction, permittivity_of(index)});
    }
    const Permittivity mixed = rule_.mixed(at_nm, host_);
    if (!std::isfinite(mixed.real()) || !std::isfinite(mixed.imag())) {
      throw InputError(
          fmt::format("\"{}\" has no index at {:.7g} nm: the mixture resonates there "
                      "and nothing in it absorbs",
                      provenance_.name, nm));
    }
    return index_of(mixed);
  }

  WavelengthRange range() const override { return range_; }
  bool has_k() const override {
    return std::any_of(parts_.begin(), parts_.end(),
                       [](const MixturePart& part) { return part.table->has_k(); });
  }
  const Provenance& provenance() const override { return provenance_; }
  const std::vector<std::string>& warnings() const override { return warnings_; }

 private:
  std::vector<MixturePart> parts_;
  const MixingRule& rule_;
  std::size_t host_;
  Provenance provenance_;
  WavelengthRange range_;
  std::vector<std::string> warnings_;  // none of its own
};

}  // namespace

IndexTablePtr mixed_index(std::vector<MixturePart> parts, const MixingRule& rule, std::size_t host,
                          Provenance provenance) {
  if (parts.empty() || host >= parts.size()) {
    throw std::invalid_argument("a mixture needs parts, and its host among them");
  }
  double sum = 0.0;
  for (const MixturePart& part : parts) sum += part.volume_fraction;
  if (!(std::abs(sum - 1.0) <= 1e-9)) throw std::invalid_argument("volume fractions sum to 1");
  return std::make_shared<MixedIndex>(std::move(parts), rule, host, std::move(provenance));
}

IndexTablePtr index_between(const std::vector<IndexAtValue>& tables, double at,
                            Provenance provenance) {
  const auto increasing = [](const IndexAtValue& a, const IndexAtValue& b) {
    return !(a.value < b.value);
  };
  const bool sorted = std::adjacent_find(tables.begin(), tables.end(), increasing) == tables.end();
  if (tables.size() < 2 || !sorted || !(at >= tables.front().value && at <= tables.back().value)) {
    throw std::invalid_argument("at least two tables of increasing value, about the one wanted");
  }
  const auto above = std::find_if(tables.begin() + 1, tables.end(),
                                  [&](const IndexAtValue& table) { return table.value >= at; });
  const IndexAtValue& below = *std::prev(above);
  const double share = (at - below.value) / (above->value - below.value);
  const MixingRule& linear = *Registry<MixingRule>::instance().find("linear");
  return mixed_index({{below.table, 1.0 - share}, {above->table, share}}, linear, 0,
                     std::move(provenance));
}

}  // namespace karat
