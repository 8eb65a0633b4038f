#pragma once

#include <kanexpr/symbolic.hpp>

#include <benchmark/benchmark.h>

#include <iostream>
#include <map>
#include <string>

namespace side_by_side {

/// Prints, after the usual table, how many times longer each way takes than the compiled one of the same
/// function. Names are system/function/way.
class ratios : public benchmark::ConsoleReporter {
public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
      if (run.aggregate_name == "median") {
        const std::string name = run.run_name.function_name;
        const auto way = name.rfind('/');
        times_[name.substr(0, way)][name.substr(way + 1)] = run.GetAdjustedRealTime();
      }
  }
  void Finalize() override {
    for (const auto& [function, ways] : times_)
      for (const auto& [way, time] : ways)
        if (way != "compiled")
          std::cout << function << '\t' << way << " / compiled\t" << time / ways.at("compiled") << '\n';
  }

private:
  std::map<std::string, std::map<std::string, double>> times_;
};

/// Registers a call that takes a state, under system/function/way. The state moves a little with each call,
/// and each result is used, so that no call can be left out.
template <class State, class Call>
void add(const std::string& name, State x, Call call) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [x, call](benchmark::State& state) mutable {
                                 for (auto _ : state) {
                                   x(0) += 1e-9;
                                   benchmark::DoNotOptimize(call(x));
                                 }
                               })
      ->Repetitions(7)
      ->ReportAggregatesOnly();
}

/// Compiled and interpreted evaluation of u̇ and of mass matrix with forcing, for one system.
template <class System>
void add_system(const std::string& name) {
  using eom = kanexpr::equations_of_motion<System>;
  typename eom::state x = eom::state::Constant(0.3);
  const typename eom::parameters p = eom::parameters::Constant(1.1);
  const typename eom::inputs r = eom::inputs::Constant(0.2);

  add(name + "/udot/compiled", x, [p, r](const auto& at) { return eom::udot(at, p, r); });
  add(name + "/mass_matrix+forcing/compiled", x,
      [p, r](const auto& at) { return eom::together(eom::mass_matrix, eom::forcing)(at, p, r); });

  static auto derived = kanexpr::derive<System>();
  static auto udot = derived.function(derived.udot());
  static auto mass_and_forcing = [] {
    auto entries = derived.mass_matrix();
    for (const auto& e : derived.forcing().entries) entries.entries.push(e);
    entries.rows = entries.entries.size();
    entries.columns = 1;
    return derived.function(entries);
  }();
  add(name + "/udot/interpreted", x, [p, r](const auto& at) { return udot(at, p, r)(0); });
  add(name + "/mass_matrix+forcing/interpreted", x,
      [p, r](const auto& at) { return mass_and_forcing(at, p, r)(0); });
}

inline int run(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  ratios reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  return 0;
}

} // namespace side_by_side
