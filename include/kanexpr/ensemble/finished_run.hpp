#pragma once

#include <kanexpr/base/bytes.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr {

/// How a run ended.
enum class run_end : std::uint8_t { reached_end, stopped_by_event, failed };

/// What a run of a study leaves; of which columns, `study_layout` tells.
struct finished_run {
  std::size_t run = 0; ///< its number, from 0
  run_end end = run_end::reached_end;
  double time = 0;               ///< where it ended
  std::vector<double> values{};  ///< what it was given, and what is kept of it: not numbers if it failed
  std::vector<double> state{};   ///< where it ended, if it failed
  std::vector<double> samples{}; ///< of its trajectory, row by row
  std::vector<std::pair<std::uint32_t, double>> events{}; ///< which, and when, in the order of time
  std::string failure{};                                  ///< why it failed, as a sentence

  void fail(std::string why) {
    end = run_end::failed;
    failure = std::move(why);
  }
  template <class State>
  void stand_at(double t, const State& x) {
    time = t;
    state.assign(x.data(), x.data() + x.size());
  }

  void write(bytes_writer& out) const {
    out.put(run), out.put(static_cast<std::uint8_t>(end)), out.put(time);
    out.put(values), out.put(state), out.put(samples);
    out.put(events.size());
    for (const auto& [which, when] : events) out.put(which), out.put(when);
    out.put(failure);
  }
  static finished_run read(bytes_reader& in) {
    finished_run one;
    one.run = in.get<std::size_t>();
    one.end = static_cast<run_end>(in.get<std::uint8_t>());
    one.time = in.get<double>();
    one.values = in.get_all<double>(), one.state = in.get_all<double>(), one.samples = in.get_all<double>();
    for (auto left = in.get<std::size_t>(); left > 0 && in; --left) {
      const auto which = in.get<std::uint32_t>();
      one.events.emplace_back(which, in.get<double>());
    }
    one.failure = in.get_text();
    return one;
  }
};

} // namespace kanexpr
