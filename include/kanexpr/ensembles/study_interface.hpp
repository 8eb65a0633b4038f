#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr {

/// The name of a column and the unit of its numbers; the unit is empty if unknown.
struct column_label {
  std::string name;
  std::string unit{};
  bool operator==(const column_label&) const = default;
  static void fields(auto& self, auto& archive) { archive(self.name, self.unit); }
};

/// A value that is the same in all runs.
struct constant_of_runs {
  column_label what;
  double value;
  bool operator==(const constant_of_runs&) const = default;
  static void fields(auto& self, auto& archive) { archive(self.what, self.value); }
};

/// The quantities that a study keeps for each run.
struct study_layout {
  std::string study{};                       ///< its name
  std::size_t runs = 0;                      ///< their number
  std::size_t varied = 0;                    ///< the number of columns with varied values
  std::vector<constant_of_runs> constants{}; ///< states, parameters and inputs that do not vary
  std::vector<column_label> columns{};       ///< columns of the table of runs, which has a row per run
  std::vector<column_label> state{};         ///< state at the end of a failed run
  std::vector<column_label> samples{}; ///< columns of the trajectories, time first; empty: none are kept
  std::vector<std::string> events{};   ///< the events whose times are kept

  /// Whether a unit other than that of the time is known. Only then tables and CSV files contain units.
  bool has_units() const {
    const auto is_known = [](const column_label& each) { return !each.unit.empty(); };
    return std::ranges::any_of(state, is_known) || std::ranges::count_if(columns, is_known) > 1 ||
           std::ranges::any_of(constants, is_known, &constant_of_runs::what);
  }
};

/// How a run ended.
enum class run_end : std::uint8_t { reached_end, stopped_by_event, failed };

/// The results of a run; `study_layout` describes their columns.
struct finished_run {
  std::size_t run = 0; ///< its number, from 0
  run_end end = run_end::reached_end;
  double time = 0;                                        ///< time at which the run ended
  std::vector<double> values{};                           ///< its row in the table of runs
  std::vector<double> state{};                            ///< state at the end, if the run failed
  std::vector<double> samples{};                          ///< samples of the trajectory, row by row
  std::vector<std::pair<std::uint32_t, double>> events{}; ///< index and time, in chronological order
  std::string failure{};                                  ///< why the run failed, as a sentence

  bool has_failed() const { return end == run_end::failed; }
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

namespace ensembles {

/// The interface of a study, which does not depend on the type of its system.
class study_interface {
public:
  study_interface() = default;
  study_interface(const study_interface&) = delete;
  study_interface& operator=(const study_interface&) = delete;
  virtual ~study_interface() = default;

  virtual const study_layout& layout() const = 0;
  /// Distinguishes the study from others with the same layout.
  virtual std::string identity() const = 0;
  /// Returns the number of runs that share a vector; shares of runs start at multiples of it.
  virtual std::size_t lanes() const = 0;
  /// Performs the runs [first, first + count) on the calling thread. The result of a run depends only on its
  /// number.
  virtual std::vector<finished_run> run(std::size_t first, std::size_t count) const = 0;
};

/// Calls a function, and returns the text of the exception that it throws, if any.
template <class Function>
std::optional<std::string> exception_in(const Function& call) {
  try {
    call();
  } catch (const std::exception& thrown) {
    return thrown.what();
  } catch (...) {
    return "something other than a std::exception was thrown";
  }
  return std::nullopt;
}

} // namespace ensembles

} // namespace kanexpr
