#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/ensembles/archive.hpp>
#include <kanexpr/ensembles/study.hpp>
#include <kanexpr/ensembles/study_columns.hpp>
#include <kanexpr/ensembles/study_interface.hpp>
#include <kanexpr/ensembles/values_of_runs.hpp>
#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/simulations/tables/table.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// Performs a part of a run; the run fails if the part throws an exception.
template <class Part>
void attempt(finished_run& done, const Part& part) {
  if (auto thrown = exception_in(part)) done.fail(*std::move(thrown));
}

/// A study in the form that its runner uses.
template <class Kind>
struct study_context {
  study_of<Kind> study;
  values_of_runs<Kind> values{study};
  study_layout layout = study_columns<Kind>::layout_of(study);

  run_values varied(const finished_run& one) const { return run_values(study.runs, one.run); }

  typename Kind::setup setup(const run_values& varied) const {
    typename Kind::setup one{values.in(varied)};
    if constexpr (requires { one.options; }) one.options = study.simulation;
    if (auto change = study.for_each_run) change(varied, one);
    return one;
  }

  /// Returns the outputs of a run, in its row.
  std::span<double> outputs(finished_run& done) const {
    return std::span(done.values).subspan(3 + layout.varied);
  }
  /// Keeps an output; returns false if the run fails because the output is NaN.
  bool keep(finished_run& done, std::size_t i, double value, bool may_be_missing = false) const {
    outputs(done)[i] = value;
    if (may_be_missing || !numeric::elementary::detail::is_nan(value)) return true;
    done.fail(study.keep[i].what.name + " is not a number");
    return false;
  }
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

  /// Returns a message that describes a mistake in the study; empty if there is none.
  const std::string& mistake() const { return mistake_; }

  const study_layout& layout() const override { return context_.layout; }
  /// Functions cannot be compared; only their presence is part of the identity.
  std::string identity() const override {
    saver all;
    all(context_.study.runs.identity(), static_cast<bool>(context_.study.for_each_run));
    runner_.write_identity(context_, all);
    return all.bytes();
  }
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
    if (std::string mistake = context_.values.mistake(context_.study); !mistake.empty()) return mistake;
    table names;
    for (const column_label& each : context_.layout.columns)
      if (const outcome added = names.add(each.name, {}); !added)
        return "in the outputs of the study, " + added.cause();
    if (context_.study.keep_events && context_.layout.events.empty())
      return "the study has no events to keep";
    std::string mistake = runner_.find_mistake(context_);
    if (mistake.empty() && context_.study.for_each_run)
      mistake = mistake_in_call([&] { context_.setup(run_values(context_.study.runs, 0)); });
    return mistake;
  }

  void begin(std::size_t run, finished_run& done) const {
    done.run = run;
    done.values.assign(context_.layout.columns.size(), std::numeric_limits<double>::quiet_NaN());
    done.values[0] = static_cast<double>(run);
    attempt(done, [&] { std::ranges::copy(context_.varied(done).all(), done.values.begin() + 3); });
  }

  void complete(finished_run& done) const {
    done.values[1] = static_cast<double>(done.end), done.values[2] = done.time;
    const std::span<double> outputs = context_.outputs(done);
    if (done.has_failed()) {
      std::ranges::fill(outputs, std::numeric_limits<double>::quiet_NaN());
      return;
    }
    if (context_.study.keep_end_state)
      std::ranges::copy(done.state, outputs.subspan(context_.study.keep.size()).begin());
    done.state.clear();
  }

  study_context<kind> context_;
  Runner runner_;
  std::string mistake_{};
};

} // namespace kanexpr::ensembles
