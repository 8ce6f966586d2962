// A spectrum is a function of wavelength. It exists at load time only; rendering reads its
// LatticeSpectrum.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "spectral/sampled_spectrum.h"
#include "spectral/wavelengths.h"

namespace karat {

// A row of a table, as its source lists it.
struct SpectrumSample {
  double nm = 0.0;
  double value = 0.0;
};

class Spectrum {
 public:
  virtual ~Spectrum() = default;

  // The value at a wavelength in nm, in the unit of whatever the spectrum stands for. Outside
  // `range()` a table holds its end value: whoever needs the range to hold asks first.
  virtual double operator()(double wavelength_nm) const = 0;

  // Where the spectrum is known: unbounded for formulas, the first and last sample for tables.
  virtual WavelengthRange range() const { return {0.0, std::numeric_limits<double>::infinity()}; }

  // What the spectrum is, for logs and metadata: "blackbody 3000 K", "illuminant D65".
  virtual std::string description() const = 0;

  // The mean over an interval. Tables override this with the exact integral of their segments.
  virtual double mean(WavelengthRange interval) const;

  // The rows behind the spectrum: wavelengths do not decrease, and where one is repeated the value
  // jumps. None for what is not a table.
  virtual std::vector<SpectrumSample> samples() const { return {}; }
};

using SpectrumPtr = std::shared_ptr<const Spectrum>;

SpectrumPtr constant_spectrum(double value);

// Piecewise linear between samples. `wavelengths_nm` strictly increases and is as long as `values`,
// and all numbers are finite; throws std::invalid_argument otherwise.
SpectrumPtr table_spectrum(std::vector<double> wavelengths_nm, std::vector<double> values,
                           std::string description);

// Planck's law, spectral radiance in W m^-2 sr^-1 nm^-1 at `temperature_kelvin` > 0 (CODATA 2018).
SpectrumPtr blackbody_spectrum(double temperature_kelvin);

SpectrumPtr scaled_spectrum(SpectrumPtr spectrum, double factor);

// The run-time form of a spectrum: its values on the lattice, phase by phase.
class LatticeSpectrum {
 public:
  LatticeSpectrum() = default;
  explicit LatticeSpectrum(float value) { phases_.fill(SampledSpectrum(value)); }

  const SampledSpectrum& operator[](int phase) const {
    return phases_[static_cast<std::size_t>(phase)];
  }
  SampledSpectrum& operator[](int phase) { return phases_[static_cast<std::size_t>(phase)]; }

 private:
  std::array<SampledSpectrum, kPhases> phases_;
};

// Means over the lattice's bins: right for what is integrated (emission, reflectance, observers).
LatticeSpectrum bin_means(const Spectrum& spectrum, const WavelengthLattice& lattice);

// Values at the lattice wavelengths: right for what enters a formula (n, k).
LatticeSpectrum point_samples(const Spectrum& spectrum, const WavelengthLattice& lattice);

}  // namespace karat
