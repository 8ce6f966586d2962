#include "spectral/illuminant.h"

#include <fmt/format.h>

#include <cmath>

#include "spectral/colour.h"
#include "spectral/spectrum_file.h"
#include "spectral/support/data_path.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

// S = value_560 * (560/l)^5 (exp(c2 / (T 560)) - 1) / (exp(c2 / (T l)) - 1), with the file's own
// second radiation constant c2: illuminant A is defined by T = 2848 K and c2 = 1.435e7 nm K.
class RelativePlanckSpectrum final : public Spectrum {
 public:
  RelativePlanckSpectrum(double exponent_nm, double value_560, std::string description)
      : exponent_nm_(exponent_nm),
        scale_(value_560 * std::pow(560.0, 5) * std::expm1(exponent_nm / 560.0)),
        description_(std::move(description)) {}

  double operator()(double nm) const override {
    return scale_ / (nm * nm * nm * nm * nm) / std::expm1(exponent_nm_ / nm);
  }
  std::string description() const override { return description_; }

 private:
  double exponent_nm_, scale_;
  std::string description_;
};

class EqualEnergySpectrum final : public Spectrum {
 public:
  EqualEnergySpectrum(double value, std::string description)
      : value_(value), description_(std::move(description)) {}
  double operator()(double) const override { return value_; }
  double mean(WavelengthRange) const override { return value_; }
  std::string description() const override { return description_; }

 private:
  double value_;
  std::string description_;
};

double positive(const SpectrumFile& file, const std::string& path, const std::string& key) {
  const double value = file.number(key);
  if (!(value > 0.0)) throw InputError(path, key, "must be above 0");
  return value;
}

}  // namespace

SpectrumPtr illuminant(const std::string& name) {
  const std::string path = named_data_file("illuminants", "illuminant", name);
  const SpectrumFile file(path);
  const std::string description = file.text("description");
  if (file.has("constant")) {
    return std::make_shared<EqualEnergySpectrum>(positive(file, path, "constant"), description);
  }
  if (file.has("planck")) {
    const double exponent_nm = positive(file, path, "planck/c2_nm_kelvin") /
                               positive(file, path, "planck/temperature_kelvin");
    return std::make_shared<RelativePlanckSpectrum>(
        exponent_nm, positive(file, path, "value_at_560_nm"), description);
  }
  return file.table("values", description);
}

std::vector<std::string> illuminant_names() { return data_names("illuminants"); }

SpectrumPtr normalised(SpectrumPtr spectrum) {
  const double y = xyz_of_emission(*spectrum, observer("cie1931"))[1];
  if (!(y > 0.0) || !std::isfinite(1.0 / y)) {
    throw InputError(spectrum->description() + " has no visible power to be normalised by");
  }
  return scaled_spectrum(std::move(spectrum), 1.0 / y);
}

SpectrumPtr daylight_spectrum(double temperature_kelvin) {
  const double t = temperature_kelvin;
  if (!(t >= 4000.0 && t <= 25000.0)) {
    throw InputError(fmt::format("daylight is defined from 4000 to 25000 K, not at {:g} K", t));
  }
  const double r = 1000.0 / t;
  const double x = t <= 7000.0 ? 0.244063 + r * (0.09911 + r * (2.9678 - r * 4.6070))
                               : 0.237040 + r * (0.24748 + r * (1.9018 - r * 2.0064));
  const double y = -3.000 * x * x + 2.870 * x - 0.275;
  const double m = 0.0241 + 0.2562 * x - 0.7341 * y;
  const double m1 = (-1.3515 - 1.7703 * x + 5.9114 * y) / m;
  const double m2 = (0.0300 - 31.4424 * x + 30.0717 * y) / m;
  const SpectrumFile file(data_path("cie/daylight/basis.json"));
  const SpectrumPtr s0 = file.table("S0", "S0"), s1 = file.table("S1", "S1"),
                    s2 = file.table("S2", "S2");
  const double step = file.number("wavelength_nm/step");
  const WavelengthRange range = s0->range();
  std::vector<double> nm, values;
  for (double l = range.min_nm; l <= range.max_nm; l += step) {
    nm.push_back(l);
    values.push_back((*s0)(l) + m1 * (*s1)(l) + m2 * (*s2)(l));
  }
  return zero_outside_range(
      table_spectrum(std::move(nm), std::move(values), fmt::format("daylight {:g} K", t)));
}

}  // namespace karat
