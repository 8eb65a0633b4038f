// 256 states at once: one after another, side by side in the vectors of the processor, and on two threads.
#include "models/iiwa.hpp"
#include "models/puma.hpp"
#include "side_by_side.hpp"
#include "two_threads.hpp"

#include <kanexpr/batch.hpp>

#include <memory>

namespace {

using namespace kanexpr;

constexpr int systems = 256;

/// Registers what `begin()` gives, which is made when it is measured.
template <class Begin>
void add(const std::string& name, const Begin& begin) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [begin](benchmark::State& state) {
                                 const auto call = begin();
                                 for (auto _ : state) {
                                   call();
                                   benchmark::ClobberMemory();
                                 }
                               })
      ->Repetitions(7)
      ->ReportAggregatesOnly();
}

template <class System, class Number>
auto states() {
  many<state<System, Number>> x(systems);
  for (int i = 0; i < x.rows; ++i)
    for (int k = 0; k < systems; ++k) x(i)(k) = static_cast<Number>(0.3 + 0.001 * k);
  return x;
}

template <class System, class Function>
void add_function(const std::string& name, const Function& f) {
  static const auto x = states<System, double>();
  static const auto x_float = states<System, float>();
  static const parameter_values<System> p = parameter_values<System>::Constant(1.1);
  static const input_values<System> r = input_values<System>::Constant(0.2);
  static many_results results(f, systems);
  static many_results<Function, float> results_float(systems);
  add(name + "/compiled", [f] {
    return [f] {
      for (int k = 0; k < systems; ++k) benchmark::DoNotOptimize(f(x.get(k), p, r));
    };
  });
  add(name + "/side by side", [] { return [] { benchmark::DoNotOptimize(results.evaluate(x, p, r)); }; });
  add(name + "/side by side, float",
      [] { return [] { benchmark::DoNotOptimize(results_float.evaluate(x_float, p, r)); }; });
  add(name + "/side by side, 2 threads", [] {
    return [both = std::make_shared<bench::two_threads>()] {
      benchmark::DoNotOptimize(results.evaluate(*both, x, p, r));
    };
  });
}

template <class System>
void add_system(const std::string& name) {
  add_function<System>(name + "/udot", equations_of_motion<System>::udot);
  add_function<System>(name + "/jacobian", linearization<System>::jacobian);
}

} // namespace

int main(int argc, char** argv) {
  add_system<puma::System>("puma");
  add_system<iiwa::System>("iiwa");
  return side_by_side::run(argc, argv);
}
