#include "spectral/spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace karat {
namespace {

class ConstantSpectrum final : public Spectrum {
 public:
  explicit ConstantSpectrum(double value) : value_(value) {}
  double operator()(double) const override { return value_; }
  double mean(WavelengthRange) const override { return value_; }
  std::string description() const override { return fmt::format("constant {:g}", value_); }

 private:
  double value_;
};

class TableSpectrum final : public Spectrum {
 public:
  TableSpectrum(std::vector<double> wavelengths_nm, std::vector<double> values,
                std::string description)
      : nm_(std::move(wavelengths_nm)),
        values_(std::move(values)),
        description_(std::move(description)) {
    if (nm_.empty() || nm_.size() != values_.size()) {
      throw std::invalid_argument("a table needs as many values as wavelengths, at least one");
    }
    for (std::size_t i = 0; i < nm_.size(); ++i) {
      if (!std::isfinite(nm_[i]) || !std::isfinite(values_[i])) {
        throw std::invalid_argument("a table's wavelengths and values must be finite");
      }
      if (i > 0 && !(nm_[i] > nm_[i - 1])) throw std::invalid_argument("wavelengths must increase");
    }
  }

  double operator()(double nm) const override {
    if (nm <= nm_.front()) return values_.front();
    if (nm >= nm_.back()) return values_.back();
    const auto above = std::upper_bound(nm_.begin(), nm_.end(), nm) - nm_.begin();
    const auto i = static_cast<std::size_t>(above - 1);
    const double t = (nm - nm_[i]) / (nm_[i + 1] - nm_[i]);
    return values_[i] + t * (values_[i + 1] - values_[i]);
  }

  // The trapezoidal rule over the interval's own ends and the samples inside it is exact here.
  double mean(WavelengthRange interval) const override {
    if (!(interval.width_nm() > 0.0)) return (*this)(interval.min_nm);
    double integral = 0.0;
    double nm = interval.min_nm, value = (*this)(nm);
    const auto step_to = [&](double next_nm, double next_value) {
      integral += 0.5 * (value + next_value) * (next_nm - nm);
      nm = next_nm, value = next_value;
    };
    for (auto it = std::upper_bound(nm_.begin(), nm_.end(), interval.min_nm);
         it != nm_.end() && *it < interval.max_nm; ++it) {
      step_to(*it, values_[static_cast<std::size_t>(it - nm_.begin())]);
    }
    step_to(interval.max_nm, (*this)(interval.max_nm));
    return integral / interval.width_nm();
  }

  WavelengthRange range() const override { return {nm_.front(), nm_.back()}; }
  std::string description() const override { return description_; }
  std::vector<SpectrumSample> samples() const override {
    std::vector<SpectrumSample> rows;
    for (std::size_t i = 0; i < nm_.size(); ++i) rows.push_back({nm_[i], values_[i]});
    return rows;
  }

 private:
  std::vector<double> nm_, values_;
  std::string description_;
};

class BlackbodySpectrum final : public Spectrum {
 public:
  explicit BlackbodySpectrum(double kelvin) : kelvin_(kelvin) {
    if (!(kelvin > 0.0 && std::isfinite(kelvin)))
      throw std::invalid_argument("a blackbody needs a finite temperature above 0 K");
  }

  // Planck 1901: L = 2 h c^2 / lambda^5 / (exp(h c / (lambda k T)) - 1), per metre; times 1e-9 per
  // nm.
  double operator()(double nm) const override {
    constexpr double kPlanck = 6.62607015e-34, kLight = 299792458.0, kBoltzmann = 1.380649e-23;
    const double m = nm * 1e-9;
    const double exponent = kPlanck * kLight / (m * kBoltzmann * kelvin_);
    return 2.0 * kPlanck * kLight * kLight / (m * m * m * m * m) / std::expm1(exponent) * 1e-9;
  }
  std::string description() const override { return fmt::format("blackbody {:g} K", kelvin_); }

 private:
  double kelvin_;
};

class ScaledSpectrum final : public Spectrum {
 public:
  ScaledSpectrum(SpectrumPtr spectrum, double factor)
      : spectrum_(std::move(spectrum)), factor_(factor) {}
  double operator()(double nm) const override { return factor_ * (*spectrum_)(nm); }
  double mean(WavelengthRange interval) const override {
    return factor_ * spectrum_->mean(interval);
  }
  WavelengthRange range() const override { return spectrum_->range(); }
  std::string description() const override {
    return fmt::format("{:g} x {}", factor_, spectrum_->description());
  }
  std::vector<SpectrumSample> samples() const override {
    std::vector<SpectrumSample> rows = spectrum_->samples();
    for (SpectrumSample& row : rows) row.value *= factor_;
    return rows;
  }

 private:
  SpectrumPtr spectrum_;
  double factor_;
};

template <typename F>
LatticeSpectrum tabulated(F&& value) {
  LatticeSpectrum lattice_spectrum;
  for (int phase = 0; phase < kPhases; ++phase) {
    // No for_each_lane: virtual calls are not vectorised, of which Clang would warn.
    for (int lane = 0; lane < kLanes; ++lane) {
      lattice_spectrum[phase][lane] = static_cast<float>(value(lane, phase));
    }
  }
  return lattice_spectrum;
}

}  // namespace

// Three-point Gauss-Legendre quadrature: bins are narrow against any smooth formula.
double Spectrum::mean(WavelengthRange interval) const {
  const double centre = 0.5 * (interval.min_nm + interval.max_nm);
  const double offset = 0.5 * interval.width_nm() * std::sqrt(0.6);
  return (5.0 * (*this)(centre - offset) + 8.0 * (*this)(centre) + 5.0 * (*this)(centre + offset)) /
         18.0;
}

SpectrumPtr constant_spectrum(double value) { return std::make_shared<ConstantSpectrum>(value); }

SpectrumPtr table_spectrum(std::vector<double> wavelengths_nm, std::vector<double> values,
                           std::string description) {
  return std::make_shared<TableSpectrum>(std::move(wavelengths_nm), std::move(values),
                                         std::move(description));
}

SpectrumPtr blackbody_spectrum(double temperature_kelvin) {
  return std::make_shared<BlackbodySpectrum>(temperature_kelvin);
}

SpectrumPtr scaled_spectrum(SpectrumPtr spectrum, double factor) {
  return std::make_shared<ScaledSpectrum>(std::move(spectrum), factor);
}

LatticeSpectrum bin_means(const Spectrum& spectrum, const WavelengthLattice& lattice) {
  return tabulated([&](int lane, int phase) { return spectrum.mean(lattice.bin(lane, phase)); });
}

LatticeSpectrum point_samples(const Spectrum& spectrum, const WavelengthLattice& lattice) {
  return tabulated(
      [&](int lane, int phase) { return spectrum(lattice.wavelength_nm(lane, phase)); });
}

}  // namespace karat
