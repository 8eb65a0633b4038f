// 256 states at once: one after another, side by side in the vectors of the processor, and on two threads.
#include "models/iiwa.hpp"
#include "models/puma.hpp"
#include "side_by_side.hpp"

#include <kanexpr/batch.hpp>

#include <atomic>
#include <memory>
#include <thread>

namespace {

using namespace kanexpr;

constexpr int systems = 256;

/// A second thread that waits for its half of the chunks.
class pair_of_threads {
public:
  pair_of_threads() : other_([this](const std::stop_token& stop) { run(stop); }) {}
  pair_of_threads(const pair_of_threads&) = delete;
  pair_of_threads& operator=(const pair_of_threads&) = delete;
  ~pair_of_threads() {
    other_.request_stop();
    hand(this);
  }

  template <class Chunk>
  void operator()(int count, const Chunk& chunk) {
    const auto from = [&](int first) {
      for (int i = first; i < count; i += 2) chunk(i);
    };
    call_ = [](const void* of, int first) { (*static_cast<const decltype(from)*>(of))(first); };
    hand(&from);
    from(0);
    work_.wait(&from);
  }

private:
  void hand(const void* work) {
    work_ = work;
    work_.notify_all();
  }
  void run(const std::stop_token& stop) {
    for (;;) {
      work_.wait(nullptr);
      if (stop.stop_requested()) return;
      call_(work_, 1);
      hand(nullptr);
    }
  }

  void (*call_)(const void*, int) = nullptr;
  std::atomic<const void*> work_ = nullptr;
  std::jthread other_;
};

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
    return [both = std::make_shared<pair_of_threads>()] {
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
