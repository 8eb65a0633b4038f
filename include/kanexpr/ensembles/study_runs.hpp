#pragma once

#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/ensembles/study.hpp>
#include <kanexpr/ensembles/study_interface.hpp>
#include <kanexpr/ensembles/values_of_runs.hpp>

#include <algorithm>
#include <exception>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// Performs a part of a run; the run fails if it throws.
template <class Part>
void attempt(finished_run& done, const Part& part) {
  try {
    part();
  } catch (const std::exception& thrown) {
    done.fail(thrown.what());
  } catch (...) {
    done.fail("something other than a std::exception was thrown");
  }
}

/// A study, as its runner uses it.
template <class Kind>
struct study_context {
  study_of<Kind> study;
  values_of_runs<typename Kind::System> values{study};
  study_layout layout = study_columns::layout_of(study, compiled::survey_of<typename Kind::System>,
                                                 type_name<typename Kind::System>());

  run_values varied(const finished_run& one) const { return run_values(study.runs, one.run); }
  /// The outputs of a run, in its row.
  double* outputs(finished_run& done) const { return done.values.data() + 3 + layout.varied; }
};

/// The runs of a study, performed by its runner.
template <class Runner>
class study_runs final : public study_interface {
  using kind = typename Runner::kind;

public:
  study_runs(study_of<kind> what, Runner runner) : context_{std::move(what)}, runner_(std::move(runner)) {
    if constexpr (requires { context_.study.simulation.events; })
      if (context_.study.keep_events)
        for (const auto& each : context_.study.simulation.events)
          if (std::ranges::find(context_.layout.events, each.name) == context_.layout.events.end())
            context_.layout.events.push_back(each.name);
    mistake_ = find_mistake();
  }

  /// A mistake in the study, as a sentence; empty if there is none.
  const std::string& mistake() const { return mistake_; }
  /// The content of the study beyond its layout. Functions cannot be compared, only their presence.
  std::string identity() const {
    saver all;
    all(context_.values.identity(context_.study), static_cast<bool>(context_.study.for_each_run));
    runner_.write_identity(context_, all);
    return all.bytes();
  }

  const study_layout& layout() const override { return context_.layout; }
  std::size_t lanes() const override { return Runner::lanes; }
  std::vector<finished_run> run(std::size_t first, std::size_t count) const override {
    std::vector<finished_run> all(count);
    for (finished_run& each : all) begin(first++, each);
    for (std::size_t i = 0; i < count; i += Runner::lanes)
      runner_.perform(context_, std::span(all).subspan(i, (std::min)(Runner::lanes, count - i)));
    for (finished_run& each : all) complete(each);
    return all;
  }

private:
  std::string find_mistake() const {
    if (!context_.values.mistake.empty()) return context_.values.mistake;
    if (std::string mistake = mistake_in(context_.layout.columns); !mistake.empty()) return mistake;
    if (context_.study.keep_events && context_.layout.events.empty())
      return "the study has no events to keep";
    return runner_.find_mistake(context_);
  }

  void begin(std::size_t run, finished_run& done) const {
    done.run = run;
    done.values.assign(context_.layout.columns.size(), std::numeric_limits<double>::quiet_NaN());
    done.values[0] = static_cast<double>(run);
    attempt(done, [&] { std::ranges::copy(context_.varied(done).all(), done.values.begin() + 3); });
  }

  void complete(finished_run& done) const {
    done.values[1] = static_cast<double>(done.end), done.values[2] = done.time;
    double* outputs = context_.outputs(done);
    if (done.end == run_end::failed) {
      std::fill(outputs, done.values.data() + done.values.size(), std::numeric_limits<double>::quiet_NaN());
    } else {
      if (context_.study.keep_end_state)
        std::copy(done.state.begin(), done.state.end(), outputs + context_.study.keep.size());
      done.state.clear();
    }
  }

  study_context<kind> context_;
  Runner runner_;
  std::string mistake_{};
};

} // namespace kanexpr::ensembles
