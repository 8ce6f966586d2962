// Why a uniform grid in cos(theta): of cos, sqrt(cos) and two rational maps it needs the fewest
// intervals for films of 0.2 um and more, where fringes over angle set the number, and no more than
// 64 for thin ones and bare metals. A cubic, because linear interpolation needs 8 times as many.
#include "materials/fresnel_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace karat {
namespace {

constexpr int kFewestIntervals = 32, kMostIntervals = 1024;

// Weights of the nodes first, first + 1, ... first + 3; at both ends the first and last four.
struct Cubic {
  int first;
  std::array<float, 4> weights;
};

Cubic cubic_at(float cos_theta, int intervals) {
  const float place = cos_theta * static_cast<float>(intervals);
  const int first = std::clamp(static_cast<int>(place) - 1, 0, intervals - 3);
  const float x = place - static_cast<float>(first);
  const float x1 = x - 1.0f, x2 = x - 2.0f, x3 = x - 3.0f;
  return {first,
          {-x1 * x2 * x3 / 6.0f, x * x2 * x3 / 2.0f, -x * x1 * x3 / 2.0f, x * x1 * x2 / 6.0f}};
}

LatticeSpectrum plane(const ReflectanceOfAngle& reflectance, double cos_theta) {
  LatticeSpectrum values;
  tbb::parallel_for(0, kPhases, [&](int phase) {
    for (int lane = 0; lane < kLanes; ++lane) {
      values[phase][lane] = static_cast<float>(reflectance(lane, phase, cos_theta));
    }
  });
  return values;
}

double largest_difference(const LatticeSpectrum& a, const FresnelTables& tables, float cos_theta) {
  float largest = 0.0f;
  for (int phase = 0; phase < kPhases; ++phase) {
    const SampledSpectrum b = tabulated_fresnel().reflectance(tables, phase, cos_theta);
    for (int i = 0; i < kLanes; ++i) largest = std::max(largest, std::abs(a[phase][i] - b[i]));
  }
  return largest;
}

class TabulatedFresnel final : public FresnelModel {
 public:
  std::string description() const override { return "reflectance tabulated over angle"; }
  std::string source() const override { return exact_.source(); }

  FresnelTables prepare(const LatticeIndex& index) const override {
    return tabulated_reflectance([&](int lane, int phase, double cos_theta) {
             return evaluate({index.n[phase][lane], index.k[phase][lane]}, cos_theta).unpolarised;
           })
        .tables;
  }

  SampledSpectrum reflectance(const FresnelTables& tables, int phase,
                              float cos_theta) const override {
    const Cubic cubic = cubic_at(cos_theta, static_cast<int>(tables.planes.size()) - 1);
    const float wa = cubic.weights[0], wb = cubic.weights[1];
    const float wc = cubic.weights[2], wd = cubic.weights[3];
    const LatticeSpectrum* planes = tables.planes.data() + cubic.first;
    const SampledSpectrum &a = planes[0][phase], &b = planes[1][phase];
    const SampledSpectrum &c = planes[2][phase], &d = planes[3][phase];
    SampledSpectrum r;
#pragma omp simd
    for (int i = 0; i < kLanes; ++i) {
      const float value = wa * a[i] + wb * b[i] + wc * c[i] + wd * d[i];
      r[i] = std::min(std::max(value, 0.0f), 1.0f);
    }
    return r;
  }

  Scalar evaluate(ComplexIndex index, double cos_theta) const override {
    return exact_.evaluate(index, cos_theta);
  }

 private:
  const FresnelModel& exact_ = *Registry<FresnelModel>::instance().find("exact");
};

// `coarse` and the planes half-way between its own, in order.
FresnelTables merged(FresnelTables coarse, std::vector<LatticeSpectrum> between) {
  FresnelTables fine;
  for (std::size_t i = 0; i < between.size(); ++i) {
    fine.planes.push_back(coarse.planes[i]);
    fine.planes.push_back(between[i]);
  }
  fine.planes.push_back(coarse.planes.back());
  return fine;
}

}  // namespace

TabulatedReflectance tabulated_reflectance(const ReflectanceOfAngle& reflectance) {
  TabulatedReflectance result{{}, kFewestIntervals, 0.0};
  for (int i = 0; i <= result.intervals; ++i) {
    result.tables.planes.push_back(plane(reflectance, static_cast<double>(i) / result.intervals));
  }
  for (;;) {
    std::vector<LatticeSpectrum> between;
    result.error = 0.0;
    for (int i = 0; i < result.intervals; ++i) {
      const double cos_theta = (i + 0.5) / result.intervals;
      between.push_back(plane(reflectance, cos_theta));
      if (cos_theta < kGrazingCosine) continue;
      result.error = std::max(result.error, largest_difference(between.back(), result.tables,
                                                               static_cast<float>(cos_theta)));
    }
    if (result.error <= kTabulatedError || result.intervals == kMostIntervals) return result;
    result.tables = merged(std::move(result.tables), std::move(between));
    result.intervals *= 2;
  }
}

const FresnelModel& tabulated_fresnel() {
  static const TabulatedFresnel instance;
  return instance;
}

}  // namespace karat
