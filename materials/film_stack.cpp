#include "materials/film_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "spectral/support/error.h"

namespace karat {
namespace {

// Change of the phase of light that has gone through all layers and back, in radians, that one
// sample of a bin may stand for: the mean of a fringe over it differs by 0.3 % of its amplitude.
constexpr double kPhasePerSample = 0.25;

class LayeredIndex final : public IndexTable {
 public:
  LayeredIndex(FilmStack stack, Provenance provenance)
      : stack_(std::move(stack)),
        provenance_(std::move(provenance)),
        range_(stack_.substrate->range()) {
    double thickness_nm = 0.0;
    for (const FilmStack::Layer& layer : stack_.layers) {
      range_.min_nm = std::max(range_.min_nm, layer.index->range().min_nm);
      range_.max_nm = std::min(range_.max_nm, layer.index->range().max_nm);
      thickness_nm += layer.thickness_nm;
    }
    if (range_.min_nm > range_.max_nm) {
      throw InputError("no wavelength is covered by the substrate and all layers");
    }
    if (thickness_nm > kThickestFilmsNm) {
      throw InputError(
          fmt::format("the layers are {:g} nm thick together, allowed: {:g}; thicker "
                      "coats are no thin films",
                      thickness_nm, kThickestFilmsNm));
    }
  }

  ComplexIndex at(double) const override {
    throw InputError("\"" + provenance_.name +
                     "\" is a stack of films and has no index of its own; only the \"nk\" of a "
                     "conductor takes one");
  }
  WavelengthRange range() const override { return range_; }
  bool has_k() const override { return true; }
  const Provenance& provenance() const override { return provenance_; }
  const std::vector<std::string>& warnings() const override { return warnings_; }
  const FilmStack& stack() const { return stack_; }

 private:
  FilmStack stack_;
  Provenance provenance_;
  WavelengthRange range_;
  std::vector<std::string> warnings_;
};

// A stack at one wavelength, relative to what is outside.
struct Films {
  std::vector<FilmLayer> layers;
  std::complex<double> substrate;
};

std::complex<double> relative(const IndexTable& table, double outer_n, double nm) {
  const ComplexIndex index = table.at(nm);
  if (!(index.n >= 0.0 && index.k >= 0.0 && index.n + index.k > 0.0)) {
    throw InputError(
        fmt::format("\"{}\" gives n = {:.6g}, k = {:.6g} at {:.7g} nm; films need "
                    "n >= 0 and k >= 0, not both 0",
                    table.provenance().name, index.n, index.k, nm));
  }
  return {index.n / outer_n, index.k / outer_n};
}

Films films_at(const FilmStack& stack, double outer_n, double nm) {
  Films films;
  for (const FilmStack::Layer& layer : stack.layers) {
    films.layers.push_back(
        {relative(*layer.index, outer_n, nm), layer.thickness_nm * outer_n / nm});
  }
  films.substrate = relative(*stack.substrate, outer_n, nm);
  return films;
}

double outer_index(const IndexTable& exterior, double nm) {
  const double n = exterior.at(nm).n;
  if (!(n > 0.0)) {
    throw InputError(fmt::format("exterior: its n is {:g} at {:g} nm; it must be above 0", n, nm));
  }
  return n;
}

// Wavelengths, evenly within a bin, that stand for it.
std::vector<Films> films_of_bin(const FilmStack& stack, const IndexTable& exterior,
                                WavelengthRange bin) {
  double path_nm = 0.0;
  const double centre_nm = 0.5 * (bin.min_nm + bin.max_nm);
  for (const FilmStack::Layer& layer : stack.layers) {
    path_nm += 2.0 * layer.thickness_nm * layer.index->at(centre_nm).n;
  }
  const double change =
      2.0 * std::numbers::pi * path_nm * bin.width_nm() / (bin.min_nm * bin.max_nm);
  const int samples = std::clamp(static_cast<int>(std::ceil(change / kPhasePerSample)), 1, 256);
  std::vector<Films> films;
  for (int i = 0; i < samples; ++i) {
    const double nm = bin.min_nm + bin.width_nm() * (i + 0.5) / samples;
    films.push_back(films_at(stack, outer_index(exterior, nm), nm));
  }
  return films;
}

}  // namespace

IndexTablePtr layered_index(FilmStack stack, Provenance provenance) {
  return std::make_shared<LayeredIndex>(std::move(stack), std::move(provenance));
}

const FilmStack* film_stack_of(const IndexTable& table) {
  const auto* layered = dynamic_cast<const LayeredIndex*>(&table);
  return layered ? &layered->stack() : nullptr;
}

FilmResponse film_response(const FilmStack& stack, double outer_n, double wavelength_nm,
                           double cos_theta) {
  const Films films = films_at(stack, outer_n, wavelength_nm);
  return film_response(films.layers, films.substrate, cos_theta);
}

TabulatedReflectance tabulated_films(const FilmStack& stack, const IndexTable& exterior,
                                     const WavelengthLattice& lattice) {
  std::vector<std::vector<Films>> bins(kLatticeSize);
  const auto bin_of = [&](int lane, int phase) -> std::vector<Films>& {
    return bins[static_cast<std::size_t>(lane * kPhases + phase)];
  };
  for (int lane = 0; lane < kLanes; ++lane) {
    for (int phase = 0; phase < kPhases; ++phase) {
      bin_of(lane, phase) = films_of_bin(stack, exterior, lattice.bin(lane, phase));
    }
  }
  return tabulated_reflectance([&](int lane, int phase, double cos_theta) {
    double sum = 0.0;
    for (const Films& films : bin_of(lane, phase)) {
      sum += film_response(films.layers, films.substrate, cos_theta).reflected();
    }
    return sum / static_cast<double>(bin_of(lane, phase).size());
  });
}

}  // namespace karat
