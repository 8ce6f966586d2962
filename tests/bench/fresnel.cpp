// What one Fresnel term costs: every registered model, for kLanes wavelengths of gold, angles as a
// rough surface asks for them. Each model's prepare() is timed too: it runs once per material.
//
//   bench_fresnel --benchmark_filter=fresnel/ --benchmark_repetitions=9
//     --benchmark_enable_random_interleaving=true --benchmark_report_aggregates_only=true
#include "materials/fresnel.h"

#include <benchmark/benchmark.h>

#include <array>

#include "materials/index/index_catalogue.h"

namespace {

using namespace karat;

constexpr std::size_t kAngles = 1024;

const std::array<float, kAngles>& cosines() {
  static const std::array<float, kAngles> values = [] {
    std::array<float, kAngles> c;
    for (std::size_t i = 0; i < kAngles; ++i) {
      c[i] = (static_cast<float>(i * 389 % kAngles) + 0.5f) / kAngles;
    }
    return c;
  }();
  return values;
}

void reflectance(benchmark::State& state, const FresnelModel* model) {
  const LatticeIndex index = on_lattice(*find_index_table("main/Au/Johnson"), WavelengthLattice());
  const FresnelTables tables = model->prepare(index);
  std::size_t i = 0;
  for (auto _ : state) {
    const SampledSpectrum r =
        model->reflectance(tables, static_cast<int>(i % kPhases), cosines()[i % kAngles]);
    benchmark::DoNotOptimize(r);
    ++i;
  }
  state.SetItemsProcessed(state.iterations() * kLanes);
}

void preparation(benchmark::State& state, const FresnelModel* model) {
  const LatticeIndex index = on_lattice(*find_index_table("main/Au/Johnson"), WavelengthLattice());
  benchmark::DoNotOptimize(model->prepare(index));  // what is computed once per program
  for (auto _ : state) benchmark::DoNotOptimize(model->prepare(index));
  state.SetItemsProcessed(state.iterations());
}

}  // namespace

int main(int argc, char** argv) {
  for (const std::string& name : Registry<FresnelModel>::instance().names()) {
    const FresnelModel* model = Registry<FresnelModel>::instance().find(name);
    benchmark::RegisterBenchmark(("fresnel/" + name).c_str(), reflectance, model);
    benchmark::RegisterBenchmark(("fresnel_prepare/" + name).c_str(), preparation, model)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
