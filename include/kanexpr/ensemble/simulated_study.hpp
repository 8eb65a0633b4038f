#pragma once

#include <kanexpr/ensemble/given_to_runs.hpp>
#include <kanexpr/ensemble/job.hpp>
#include <kanexpr/ensemble/study.hpp>
#include <kanexpr/ensemble/study_columns.hpp>
#include <kanexpr/simulate/output_schedule.hpp>
#include <kanexpr/simulate/simulate.hpp>

#include <algorithm>
#include <exception>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// The runs of a study, each a simulation.
template <class System, integrator by>
class simulated_study final : public job {
  static constexpr const deriving::survey& known = compiled::survey_of<System>;
  static constexpr compiled::symbol_range range(compiled::symbols_of which) {
    return compiled::range_of(which, known);
  }

public:
  explicit simulated_study(study<System> told)
      : told_(std::move(told)), state_(known, range(compiled::symbols_of::state), told_.runs, told_.state),
        parameters_(known, range(compiled::symbols_of::parameters), told_.runs, told_.parameters),
        inputs_(known, range(compiled::symbols_of::inputs), told_.runs, told_.inputs),
        gives_inputs_(inputs_.is_varied() || !told_.inputs.empty()) {
    lay_out();
    mistake_ = find_mistake();
  }

  /// What was told wrongly, as a sentence.
  const std::string& mistake() const { return mistake_; }
  /// By what it is known from others, beside its layout.
  std::string text() const {
    std::string all = told_.runs.text();
    for (const auto* list : {&told_.state, &told_.parameters, &told_.inputs})
      for (const named_value& each : *list)
        all += ' ' + each.what.name() + ' ' + simulated::digits(each.value);
    for (double number : {told_.span.from, told_.span.to, told_.simulation.relative_tolerance})
      all += ' ' + simulated::digits(number);
    return all;
  }

  const study_layout& layout() const override { return layout_; }
  std::size_t side_by_side() const override { return 1; }
  std::vector<finished_run> run(std::size_t first, std::size_t count) const override {
    std::vector<finished_run> all(count);
    for (std::size_t i = 0; i < count; ++i) all[i] = run_one(first + i);
    return all;
  }

private:
  void lay_out() {
    std::vector<column_label> kept;
    for (const auto& each : told_.keep) {
      kept.push_back(each.what);
      needs_motion_ |= each.needs_motion, needs_samples_ |= each.needs_samples;
    }
    const study_columns columns(known, told_.units);
    layout_.study = told_.name.empty() ? std::string(type_name<System>()) : told_.name;
    layout_.runs = told_.runs.size();
    layout_.columns = columns.of_runs(told_.runs, kept);
    layout_.varied = told_.runs.varied().size();
    layout_.state = columns.of_state();
    if (told_.keep_trajectories) layout_.samples = columns.of_samples();
    if (told_.keep_events)
      for (const event<System>& each : told_.simulation.events)
        if (std::ranges::find(layout_.events, each.name) == layout_.events.end())
          layout_.events.push_back(each.name);
  }

  std::string find_mistake() const {
    if (!told_.runs.mistake().empty()) return told_.runs.mistake();
    for (const varied_name& each : told_.runs.varied())
      if (!each.is_factor() && !is_symbol(each.name()))
        return layout_.study + " has no " + each.name() +
               " that could differ from run to run; if it is none of "
               "its symbols, it is a factor, factor{\"" +
               each.name() + "\"}";
    if (!state_.mistake().empty()) return state_.mistake();
    if (!parameters_.mistake().empty()) return parameters_.mistake();
    if (gives_inputs_) {
      if (!inputs_.mistake().empty()) return inputs_.mistake();
      if (told_.simulation.inputs.mistake().view().empty())
        return "the inputs are told twice, by the study and by the options of its simulations";
    }
    table names; // takes none twice, and none that is empty
    for (const column_label& each : layout_.columns)
      if (const outcome added = names.add(each.name, {}); !added)
        return "of what the study keeps, " + added.cause();
    for (const kept<System>& each : told_.keep)
      if (!each.event.empty() && !told_.for_each_run &&
          std::ranges::find(told_.simulation.events, each.event, &event<System>::name) ==
              told_.simulation.events.end())
        return "the simulations of the study have no event " + each.event;
    return {};
  }
  static bool is_symbol(const std::string& name) {
    for (int i = 0; i < known.symbols(); ++i)
      if (known.names[i].view() == name) return true;
    return false;
  }

  finished_run run_one(std::size_t run) const {
    finished_run done;
    done.run = run;
    done.values.assign(layout_.columns.size(), std::numeric_limits<double>::quiet_NaN());
    done.values[0] = static_cast<double>(run);
    try {
      const run_values given(told_.runs, run);
      std::ranges::copy(given.all(), done.values.begin() + 3);
      simulate_one(given, done);
    } catch (const std::exception& thrown) {
      fail(done, thrown.what());
    } catch (...) {
      fail(done, "something was thrown that is no std::exception");
    }
    done.values[1] = static_cast<double>(done.end), done.values[2] = done.time;
    return done;
  }

  static void fail(finished_run& done, std::string why) {
    done.end = run_end::failed;
    done.failure = std::move(why);
  }

  void simulate_one(const run_values& given, finished_run& done) const {
    simulation_options<System> options = told_.simulation;
    const parameter_values<System> p = parameters_.in(given);
    if (gives_inputs_) options.inputs = given_inputs<System>(inputs_.in(given));
    if (told_.for_each_run) told_.for_each_run(given, options);
    const std::vector<double> times = options.output_times;
    const simulated::output_schedule asked(told_.span, options.output_every, times);
    if (needs_motion_)
      options.output_every = 0, options.output_times.clear(), options.keep = options.dense = true;
    else if (!needs_samples_ && !told_.keep_trajectories && !options.each_sample)
      options.output_every = 0, options.output_times = {told_.span.to}, options.keep = true;
    const simulation<System> ended = simulate<System, by>(given_state<System>(state_.in(given)),
                                                          given_parameters<System>(p), told_.span, options);
    done.time = ended.time;
    done.end = !ended                   ? run_end::failed
               : ended.stopped_by_event ? run_end::stopped_by_event
                                        : run_end::reached_end;
    keep_lists(ended, asked, done);
    if (!ended) {
      done.failure = ended.cause();
      done.state.assign(ended.state.data(), ended.state.data() + ended.state.size());
      return;
    }
    input_values<System> r;
    options.inputs.give(ended.time, ended.state, r);
    keep_numbers({ended, p, r}, done);
  }

  void keep_numbers(const ended_run<System>& ended, finished_run& done) const {
    const std::size_t before = layout_.columns.size() - told_.keep.size();
    for (std::size_t i = 0; i < told_.keep.size(); ++i) {
      const kept<System>& each = told_.keep[i];
      const double number = each.of(ended);
      if (std::isnan(number) && !each.may_be_missing) {
        fail(done, each.what.name + " is not a number");
        done.state.assign(ended.run.state.data(), ended.run.state.data() + ended.run.state.size());
        std::fill(done.values.begin() + static_cast<std::ptrdiff_t>(before), done.values.end(), number);
        return;
      }
      done.values[before + i] = number;
    }
  }

  void keep_lists(const simulation<System>& ended, simulated::output_schedule asked,
                  finished_run& done) const {
    if (told_.keep_trajectories && needs_motion_ && !asked.takes_each_step()) {
      for (; !asked.is_over() && asked.next() <= ended.time; asked.pass())
        if (const auto found = ended.trajectory.at(asked.next())) keep_sample(*found, done);
    } else if (told_.keep_trajectories) {
      for (const sample<System>& each : ended.trajectory) keep_sample(each, done);
    }
    for (const occurrence& each : ended.events)
      if (const auto found = std::ranges::find(layout_.events, each.name); found != layout_.events.end())
        done.events.emplace_back(static_cast<std::uint32_t>(found - layout_.events.begin()), each.t);
  }

  static void keep_sample(const sample<System>& one, finished_run& done) {
    done.samples.push_back(one.t);
    done.samples.insert(done.samples.end(), one.x.data(), one.x.data() + one.x.size());
    done.samples.insert(done.samples.end(), one.r.data(), one.r.data() + one.r.size());
  }

  const study<System> told_;
  const given_to_runs<given_state<System>, state<System>> state_;
  const given_to_runs<given_parameters<System>, parameter_values<System>> parameters_;
  const given_to_runs<given_inputs<System>, input_values<System>> inputs_;
  const bool gives_inputs_;
  bool needs_motion_ = false, needs_samples_ = false;
  study_layout layout_{};
  std::string mistake_{};
};

} // namespace kanexpr::ensembles
