// How long the derivation of M, f and the bias of the dependent rates takes while a program runs.
#include <models/andrews.hpp>
#include <models/bicycle.hpp>
#include <models/four_bar.hpp>
#include <models/iiwa.hpp>
#include <models/rolling_disc.hpp>

#include <kanexpr/derivation/derived_system.hpp>

#include <benchmark/benchmark.h>

namespace {

using kanexpr::mechanics::quantity;

template <class System>
void derive(benchmark::State& state) {
  int nodes = 0;
  for (auto _ : state) {
    kanexpr::derivation::derived_system system(System::record);
    system.derive();
    for (const quantity each : {quantity::mass_matrix, quantity::forcing, quantity::acceleration_bias})
      benchmark::DoNotOptimize(system.equations().get(each).entries.begin());
    nodes = system.graph().size();
  }
  state.counters["nodes"] = nodes;
}

BENCHMARK(derive<rolling_disc::System>)->Name("derive/rolling_disc")->Unit(benchmark::kMicrosecond);
BENCHMARK(derive<four_bar::System>)->Name("derive/four_bar")->Unit(benchmark::kMicrosecond);
BENCHMARK(derive<andrews::System>)->Name("derive/andrews")->Unit(benchmark::kMicrosecond);
BENCHMARK(derive<bicycle::System>)->Name("derive/bicycle")->Unit(benchmark::kMicrosecond);
BENCHMARK(derive<bicycle::BoundSystem>)->Name("derive/bicycle_bound")->Unit(benchmark::kMicrosecond);
BENCHMARK(derive<iiwa::System>)->Name("derive/iiwa")->Unit(benchmark::kMicrosecond);

} // namespace

BENCHMARK_MAIN();
