#include "materials/fresnel_study/fresnel_cost.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <numeric>
#include <random>

#include "materials/fresnel_study/fresnel_cost_empty.h"

namespace karat {
namespace {

// Time that this thread ran: what other programs take does not count.
double thread_ns() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

// Results go to different places: calls wait for each other no more than those of different paths.
CostKernel kernel_of(const FresnelModel& model, const LatticeIndex& index) {
  return [&model, tables = model.prepare(index)](const std::vector<float>& cosines) {
    std::array<SampledSpectrum, kPhases> results;
    results.fill(SampledSpectrum(0.0f));
    for (std::size_t i = 0; i < cosines.size(); ++i) {
      const std::size_t phase = i % kPhases;
      results[phase] = model.reflectance(tables, static_cast<int>(phase), cosines[i]);
    }
    SampledSpectrum sum(0.0f);
    for (const SampledSpectrum& result : results) sum += result;
    return mean(sum);
  };
}

constexpr std::size_t kSingleWavelengths = 32;

CostKernel single_kernel_of(const FresnelModel& model, const IndexTable& table) {
  struct Prepared {
    ComplexIndex index;
    std::vector<double> values;
  };
  std::vector<Prepared> prepared;
  for (std::size_t i = 0; i < kSingleWavelengths; ++i) {
    const double t = static_cast<double>(i) / (kSingleWavelengths - 1);
    const ComplexIndex index = table.at(kVisible.min_nm + t * kVisible.width_nm());
    prepared.push_back({index, model.chosen(index)});
  }
  return [&model, prepared](const std::vector<float>& cosines) {
    double sum = 0.0;
    for (std::size_t i = 0; i < cosines.size(); ++i) {
      const auto& [index, values] = prepared[i % kSingleWavelengths];
      sum += values.empty() ? model.evaluate(index, double{cosines[i]}).unpolarised
                            : model.evaluate_with(index, double{cosines[i]}, values);
    }
    return static_cast<float>(sum);
  };
}

std::vector<std::string> with_exact(std::vector<std::string> models) {
  if (std::find(models.begin(), models.end(), "exact") == models.end()) models.push_back("exact");
  return models;
}

std::vector<float> random_cosines(int count) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  std::vector<float> cosines(static_cast<std::size_t>(count));
  for (float& c : cosines) c = uniform(generator);
  return cosines;
}

}  // namespace

CostSpread cost_spread(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double quantile) {
    const double place = quantile * static_cast<double>(values.size() - 1);
    const auto i = static_cast<std::size_t>(place);
    const double t = place - static_cast<double>(i);
    return values[i] + t * (values[std::min(i + 1, values.size() - 1)] - values[i]);
  };
  return {at(0.5), at(0.25), at(0.75)};
}

std::vector<FresnelCost> measure_costs(const std::vector<NamedCostKernel>& kernels,
                                       const FresnelCostOptions& options) {
  const std::vector<float> cosines = random_cosines(options.calls);
  std::vector<std::vector<double>> ns(kernels.size()), relative(kernels.size());
  std::vector<std::size_t> order(kernels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 generator(1);
  const auto exact =
      static_cast<std::size_t>(std::find_if(kernels.begin(), kernels.end(),
                                            [](const auto& k) { return k.model == "exact"; }) -
                               kernels.begin());
  volatile float sink = 0.0f;
  for (int round = -1; round < options.rounds; ++round) {  // the first one warms up
    std::shuffle(order.begin(), order.end(), generator);
    std::vector<double> times(kernels.size());
    for (const std::size_t i : order) {
      const double start = thread_ns();
      sink = kernels[i].run(cosines);
      times[i] = (thread_ns() - start) / options.calls;
    }
    if (options.after_round) options.after_round(round + 1, options.rounds);
    if (round < 0) continue;
    for (std::size_t i = 0; i < kernels.size(); ++i) {
      ns[i].push_back(times[i]);
      relative[i].push_back(times[i] / times[exact]);
    }
  }
  static_cast<void>(sink);
  std::vector<FresnelCost> costs;
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    costs.push_back({kernels[i].model, cost_spread(ns[i]), cost_spread(relative[i])});
  }
  return costs;
}

std::vector<FresnelCost> fresnel_costs(const std::vector<std::string>& models,
                                       const IndexTable& table, const FresnelCostOptions& options) {
  const LatticeIndex index = on_lattice(table, WavelengthLattice());
  std::vector<NamedCostKernel> kernels;
  for (const std::string& name : with_exact(models)) {
    kernels.push_back({name, kernel_of(fresnel_model(name), index)});
  }
  kernels.push_back({"", kernel_of(empty_fresnel_model(), index)});
  return measure_costs(kernels, options);
}

std::vector<FresnelCost> fresnel_single_costs(const std::vector<std::string>& models,
                                              const IndexTable& table,
                                              const FresnelCostOptions& options) {
  std::vector<NamedCostKernel> kernels;
  for (const std::string& name : with_exact(models)) {
    kernels.push_back({name, single_kernel_of(fresnel_model(name), table)});
  }
  return measure_costs(kernels, options);
}

}  // namespace karat
