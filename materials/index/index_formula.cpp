// Formulas: refractiveindex.info, "Dispersion formulas" (M. N. Polyanskiy, Sci. Data 11, 94
// (2024)). L is the wavelength in micrometres; C1 is coefficient 0 below.
#include "materials/index/index_formula.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "spectral/support/error.h"

namespace karat {
namespace {

// Reads C1, C2, ... by their number in the formula.
class Coefficients {
 public:
  explicit Coefficients(const std::vector<double>& values) : values_(values) {}
  double operator()(std::size_t i) const { return i <= values_.size() ? values_[i - 1] : 0.0; }
  std::size_t count() const { return values_.size(); }

 private:
  const std::vector<double>& values_;
};

// A term of zero strength is absent, whatever its denominator: files fill unused places with zeros.
double ratio(double numerator, double denominator) {
  return numerator == 0.0 ? 0.0 : numerator / denominator;
}

template <typename Term>
double sum_of_pairs(const Coefficients& c, std::size_t first, Term&& term) {
  double sum = 0.0;
  for (std::size_t i = first; i <= c.count(); i += 2) sum += term(c(i), c(i + 1));
  return sum;
}

// Formula 1, Sellmeier (preferred): n^2 - 1 = C1 + sum Ci L^2 / (L^2 - C(i+1)^2).
double sellmeier(const Coefficients& c, double l) {
  return 1.0 + c(1) + sum_of_pairs(c, 2, [l](double strength, double pole) {
           return ratio(strength * l * l, l * l - pole * pole);
         });
}

// Formula 2, Sellmeier-2: the same with C(i+1) for its square.
double sellmeier_2(const Coefficients& c, double l) {
  return 1.0 + c(1) + sum_of_pairs(c, 2, [l](double strength, double pole) {
           return ratio(strength * l * l, l * l - pole);
         });
}

// Formulas 3, polynomial, and 5, Cauchy: n^2 and n = C1 + sum Ci L^C(i+1).
double powers(const Coefficients& c, double l, std::size_t first) {
  return sum_of_pairs(c, first, [l](double factor, double exponent) {
    return factor == 0.0 ? 0.0 : factor * std::pow(l, exponent);
  });
}

// Formula 4, RefractiveIndex.INFO: n^2 = C1 + C2 L^C3 / (L^2 - C4^C5) + C6 L^C7 / (L^2 - C8^C9)
// + sum Ci L^C(i+1) from i = 10.
double refractiveindex_info(const Coefficients& c, double l) {
  const auto resonance = [&](std::size_t i) {
    if (c(i) == 0.0) return 0.0;
    return ratio(c(i) * std::pow(l, c(i + 1)), l * l - std::pow(c(i + 2), c(i + 3)));
  };
  return c(1) + resonance(2) + resonance(6) + powers(c, l, 10);
}

// Formula 6, gases: n - 1 = C1 + sum Ci / (C(i+1) - L^-2).
double gases(const Coefficients& c, double l) {
  return 1.0 + c(1) + sum_of_pairs(c, 2, [l](double strength, double pole) {
           return ratio(strength, pole - 1.0 / (l * l));
         });
}

// Formula 7, Herzberger: n = C1 + C2 H + C3 H^2 + C4 L^2 + C5 L^4 + C6 L^6, H = 1 / (L^2 - 0.028).
double herzberger(const Coefficients& c, double l) {
  const double h = 1.0 / (l * l - 0.028), l2 = l * l;
  return c(1) + c(2) * h + c(3) * h * h + l2 * (c(4) + l2 * (c(5) + l2 * c(6)));
}

// Formula 8, retro: (n^2 - 1) / (n^2 + 2) = C1 + C2 L^2 / (L^2 - C3) + C4 L^2, solved for n^2.
double retro(const Coefficients& c, double l) {
  const double x = c(1) + ratio(c(2) * l * l, l * l - c(3)) + c(4) * l * l;
  return (1.0 + 2.0 * x) / (1.0 - x);
}

// Formula 9, exotic: n^2 = C1 + C2 / (L^2 - C3) + C4 (L - C5) / ((L - C5)^2 + C6).
double exotic(const Coefficients& c, double l) {
  const double d = l - c(5);
  return c(1) + ratio(c(2), l * l - c(3)) + ratio(c(4) * d, d * d + c(6));
}

std::optional<double> plausible(double n) {
  if (!(std::abs(n) <= kLargestIndex)) return std::nullopt;
  return n;
}

std::optional<double> root(double n_squared) {
  if (!(n_squared >= 0.0)) return std::nullopt;
  return plausible(std::sqrt(n_squared));
}

class FormulaSpectrum final : public Spectrum {
 public:
  FormulaSpectrum(DispersionFormula formula, WavelengthRange range, std::string origin)
      : formula_(std::move(formula)), range_(range), origin_(std::move(origin)) {}

  double operator()(double wavelength_nm) const override {
    const double nm = std::min(std::max(wavelength_nm, range_.min_nm), range_.max_nm);
    if (const auto n = formula_.index(nm / 1000.0)) return *n;
    throw InputError(fmt::format("{}: formula {} gives no index at {:.7g} nm (n^2 < 0 or a pole)",
                                 origin_, formula_.number, nm));
  }
  WavelengthRange range() const override { return range_; }
  std::string description() const override {
    return fmt::format("dispersion formula {}", formula_.number);
  }

 private:
  DispersionFormula formula_;
  WavelengthRange range_;
  std::string origin_;
};

// Wavelengths sampled over a range, evenly in their logarithm: formulas reach from the ultraviolet
// to terahertz, and their gaps lie between.
constexpr int kSamples = 401;
double sampled_nm(WavelengthRange range, int i) {
  if (i == kSamples - 1) return range.max_nm;
  return range.min_nm * std::pow(range.max_nm / range.min_nm, double(i) / (kSamples - 1));
}

}  // namespace

std::optional<double> DispersionFormula::index(double wavelength_um) const {
  const Coefficients c(coefficients);
  const double l = wavelength_um;
  switch (number) {
    case 1:
      return root(sellmeier(c, l));
    case 2:
      return root(sellmeier_2(c, l));
    case 3:
      return root(c(1) + powers(c, l, 2));
    case 4:
      return root(refractiveindex_info(c, l));
    case 5:
      return plausible(c(1) + powers(c, l, 2));
    case 6:
      return plausible(gases(c, l));
    case 7:
      return plausible(herzberger(c, l));
    case 8:
      return root(retro(c, l));
    case 9:
      return root(exotic(c, l));
    default:
      return std::nullopt;
  }
}

std::vector<double> DispersionFormula::resonances_um() const {
  std::vector<double> found;
  if (number != 1 && number != 2) return found;
  const Coefficients c(coefficients);
  for (std::size_t i = 2; i <= c.count(); i += 2) {
    const double pole = c(i + 1);
    if (c(i) == 0.0 || pole == 0.0) continue;
    if (number == 1) found.push_back(std::abs(pole));
    if (number == 2 && pole > 0.0) found.push_back(std::sqrt(pole));
  }
  return found;
}

FormulaCurve formula_curve(DispersionFormula formula, WavelengthRange range, std::string origin) {
  std::string gaps;
  int missing = 0;
  for (int i = 0; i < kSamples; ++i) {
    const int first = i;
    while (i < kSamples && !formula.index(sampled_nm(range, i) / 1000.0)) ++i;
    if (i == first) continue;
    missing += i - first;
    gaps += fmt::format("{}{:.5g} to {:.5g} nm", gaps.empty() ? "" : ", ", sampled_nm(range, first),
                        sampled_nm(range, i - 1));
  }
  if (missing == kSamples) {
    throw InputError(fmt::format("{}: formula {} gives no index anywhere in {:.7g} to {:.7g} nm",
                                 origin, formula.number, range.min_nm, range.max_nm));
  }
  return {std::make_shared<FormulaSpectrum>(std::move(formula), range, std::move(origin)), gaps};
}

}  // namespace karat
