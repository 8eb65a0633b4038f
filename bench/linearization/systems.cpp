// How long it takes to derive a system and to linearize it about an operating point that gives everything a
// number, while a program runs, and how much memory.
#include "systems.hpp"

#include <benchmark/benchmark.h>

#include <sys/resource.h>

namespace {

/// The most that this process has had so far, in MB.
double peak_memory() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024;
}

template <class Case>
void linearize(benchmark::State& state) {
  const kanexpr::linearization_point at = Case::point();
  for (auto _ : state) benchmark::DoNotOptimize(linearized::from_the_start<Case>(at).A.data());
  state.counters["peak_MB"] = peak_memory();
}

BENCHMARK(linearize<linearized::bicycle>)->Name("linearize/bicycle")->Unit(benchmark::kMillisecond);
BENCHMARK(linearize<linearized::cart>)->Name("linearize/cart")->Unit(benchmark::kMillisecond);
BENCHMARK(linearize<linearized::arm>)->Name("linearize/arm")->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
