#include "spectral/monotone_cubic.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace karat {
namespace {

using Samples = std::vector<SpectrumSample>;

double step(const Samples& s, std::size_t i) { return s[i + 1].nm - s[i].nm; }
double slope(const Samples& s, std::size_t i) { return (s[i + 1].value - s[i].value) / step(s, i); }

// Steffen 1990, equation 11: the slope of the parabola through three samples, limited.
double inner_slope(const Samples& s, std::size_t i) {
  const double h0 = step(s, i - 1), h1 = step(s, i);
  const double s0 = slope(s, i - 1), s1 = slope(s, i);
  if (!(s0 * s1 > 0.0)) return 0.0;  // an extremum, or level on one side
  const double parabola = (s0 * h1 + s1 * h0) / (h0 + h1);
  const double limit = 2.0 * std::min(std::abs(s0), std::abs(s1));
  return std::copysign(std::min(std::abs(parabola), limit), s0);
}

// Steffen 1990, for the two ends: the parabola's slope at an end, limited. `h0`, `s0` belong to the
// interval at the end, `h1`, `s1` to the next.
double end_slope(double h0, double h1, double s0, double s1) {
  const double parabola = s0 * (1.0 + h0 / (h0 + h1)) - s1 * h0 / (h0 + h1);
  if (!(parabola * s0 > 0.0)) return 0.0;
  return std::copysign(std::min(std::abs(parabola), 2.0 * std::abs(s0)), s0);
}

// The slopes at samples `first` to `last`, whose wavelengths increase strictly.
void set_slopes(const Samples& s, std::size_t first, std::size_t last,
                std::vector<double>& slopes) {
  if (first == last) return;
  if (last == first + 1) {
    slopes[first] = slopes[last] = slope(s, first);
    return;
  }
  slopes[first] =
      end_slope(step(s, first), step(s, first + 1), slope(s, first), slope(s, first + 1));
  for (std::size_t i = first + 1; i < last; ++i) slopes[i] = inner_slope(s, i);
  slopes[last] =
      end_slope(step(s, last - 1), step(s, last - 2), slope(s, last - 1), slope(s, last - 2));
}

class MonotoneCubic final : public Spectrum {
 public:
  MonotoneCubic(SpectrumPtr table, Samples samples)
      : table_(std::move(table)), samples_(std::move(samples)), slopes_(samples_.size(), 0.0) {
    // Between jumps each run of samples is a curve of its own.
    for (std::size_t first = 0, last = 0; first < samples_.size(); first = last + 1) {
      for (last = first; last + 1 < samples_.size() && step(samples_, last) > 0.0;) ++last;
      set_slopes(samples_, first, last, slopes_);
    }
  }

  double operator()(double nm) const override {
    const auto above =
        std::upper_bound(samples_.begin(), samples_.end(), nm,
                         [](double at, const SpectrumSample& sample) { return at < sample.nm; });
    // Beyond the samples the table itself says which value holds.
    if (above == samples_.begin() || above == samples_.end()) return (*table_)(nm);
    const auto i = static_cast<std::size_t>(above - samples_.begin()) - 1;
    const SpectrumSample &a = samples_[i], &b = samples_[i + 1];
    const double h = b.nm - a.nm, t = (nm - a.nm) / h, u = 1.0 - t;
    return u * u * ((1.0 + 2.0 * t) * a.value + t * h * slopes_[i]) +
           t * t * ((1.0 + 2.0 * u) * b.value - u * h * slopes_[i + 1]);
  }

  WavelengthRange range() const override { return table_->range(); }
  std::string description() const override {
    return table_->description() + ", monotone cubic between";
  }
  Samples samples() const override { return samples_; }

 private:
  SpectrumPtr table_;
  Samples samples_;
  std::vector<double> slopes_;  // at the samples, per nm
};

}  // namespace

SpectrumPtr monotone_cubic(SpectrumPtr table) {
  Samples samples = table->samples();
  if (samples.empty()) return table;
  return std::make_shared<MonotoneCubic>(std::move(table), std::move(samples));
}

}  // namespace karat
