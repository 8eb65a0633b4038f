#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr {

/// How a run ended.
enum class run_end : std::uint8_t { reached_end, stopped_by_event, failed };

/// The results of a run; `study_layout` describes their columns.
struct finished_run {
  std::size_t run = 0; ///< its number, from 0
  run_end end = run_end::reached_end;
  double time = 0;                                        ///< at the end
  std::vector<double> values{};                           ///< its row in the table of runs
  std::vector<double> state{};                            ///< at the end, if the run failed
  std::vector<double> samples{};                          ///< of its trajectory, row by row
  std::vector<std::pair<std::uint32_t, double>> events{}; ///< index and time, in the order of time
  std::string failure{};                                  ///< why the run failed, as a sentence

  void fail(std::string why) {
    end = run_end::failed;
    failure = std::move(why);
  }
  template <class State>
  void set_end(double t, const State& x) {
    time = t;
    state.assign(x.data(), x.data() + x.size());
  }
  template <class State, class Inputs>
  void add_sample(double t, const State& x, const Inputs& r) {
    samples.push_back(t);
    samples.insert(samples.end(), x.data(), x.data() + x.size());
    samples.insert(samples.end(), r.data(), r.data() + r.size());
  }

  static void fields(auto& self, auto& archive) {
    archive(self.run, self.end, self.time, self.values, self.state, self.samples, self.events, self.failure);
  }
};

} // namespace kanexpr
