#pragma once

#include <kanexpr/ensemble/given_to_runs.hpp>
#include <kanexpr/ensemble/job.hpp>
#include <kanexpr/ensemble/study.hpp>
#include <kanexpr/ensemble/study_columns.hpp>
#include <kanexpr/simulate/check_options.hpp>
#include <kanexpr/simulate/output_schedule.hpp>
#include <kanexpr/simulate/simulate.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// The runs of a study, each a simulation.
template <class System, integrator by>
class simulated_study final : public job {
  static constexpr const deriving::survey& known = compiled::survey_of<System>;

public:
  explicit simulated_study(study<System> told) : told_(std::move(told)), given_(told_) {
    for (const kept<System>& each : told_.keep)
      needs_motion_ |= each.needs_motion, needs_samples_ |= each.needs_samples;
    if (told_.keep_events)
      for (const event<System>& each : told_.simulation.events)
        if (std::ranges::find(layout_.events, each.name) == layout_.events.end())
          layout_.events.push_back(each.name);
    mistake_ = find_mistake();
  }

  /// What was told wrongly, as a sentence.
  const std::string& mistake() const { return mistake_; }
  /// By what it is known from others, beside its layout.
  std::string text() const {
    bytes_writer numbers;
    for (double each : {told_.span.from, told_.span.to, told_.simulation.relative_tolerance})
      numbers.put(each);
    return given_.text(told_) + numbers.bytes();
  }

  const study_layout& layout() const override { return layout_; }
  std::size_t side_by_side() const override { return 1; }
  std::vector<finished_run> run(std::size_t first, std::size_t count) const override {
    std::vector<finished_run> all(count);
    for (std::size_t i = 0; i < count; ++i) all[i] = run_one(first + i);
    return all;
  }

private:
  std::string find_mistake() const {
    if (!given_.mistake.empty()) return given_.mistake;
    if (given_.gives_inputs && told_.simulation.inputs.mistake().view().empty())
      return "the inputs are told twice, by the study and by the options of its simulations";
    if (std::string mistake = mistake_in(layout_.columns); !mistake.empty()) return mistake;
    if (told_.for_each_run) return mistake_in_function();
    simulation_options<System> options = told_.simulation;
    options.keep = true;
    if (given_.gives_inputs)
      options.inputs = given_inputs<System>(given_.inputs.in(run_values(told_.runs, 0)));
    if (std::string mistake = simulated::check_options(simulated::settings_of(options), told_.span);
        !mistake.empty())
      return mistake;
    for (const kept<System>& each : told_.keep)
      if (!each.event.empty() && std::ranges::find(told_.simulation.events, each.event,
                                                   &event<System>::name) == told_.simulation.events.end())
        return "the simulations of the study have no event " + each.event;
    return {};
  }

  /// A name that the function asks for, of the first run as of all.
  std::string mistake_in_function() const {
    try {
      setup(run_values(told_.runs, 0));
    } catch (const no_such_value& asked) {
      return asked.what();
    } catch (...) { // that is the run's own
    }
    return {};
  }

  simulation_setup<System> setup(const run_values& given) const {
    simulation_setup<System> one{given_.in(given), told_.simulation};
    const input_values<System> before = one.r;
    if (told_.for_each_run) told_.for_each_run(given, one);
    const bool changes_inputs = std::memcmp(before.data(), one.r.data(),
                                            static_cast<std::size_t>(before.size()) * sizeof(double)) != 0;
    if (given_.gives_inputs || changes_inputs) one.options.inputs = given_inputs<System>(one.r);
    return one;
  }

  finished_run run_one(std::size_t run) const {
    finished_run done;
    done.run = run;
    done.values = study_columns::row_of(layout_, run, told_.runs);
    try {
      simulate_one(run_values(told_.runs, run), done);
    } catch (const std::exception& thrown) {
      done.fail(thrown.what());
    } catch (...) {
      done.fail("something was thrown that is no std::exception");
    }
    study_columns::complete(told_, layout_, done);
    return done;
  }

  void simulate_one(const run_values& given, finished_run& done) const {
    simulation_setup<System> one = setup(given);
    simulation_options<System>& options = one.options;
    const parameter_values<System>& p = one.p;
    done.stand_at(told_.span.from, one.x);
    const std::vector<double> times = options.output_times;
    const simulated::output_schedule asked(told_.span, options.output_every, times);
    if (needs_motion_)
      options.output_every = 0, options.output_times.clear(), options.keep = options.dense = true;
    else if (!needs_samples_ && !told_.keep_trajectories && !options.each_sample)
      options.output_every = 0, options.output_times = {told_.span.to}, options.keep = true;
    const simulation<System> ended =
        simulate<System, by>(given_state<System>(one.x), given_parameters<System>(p), told_.span, options);
    done.stand_at(ended.time, ended.state);
    done.end = !ended                   ? run_end::failed
               : ended.stopped_by_event ? run_end::stopped_by_event
                                        : run_end::reached_end;
    keep_lists(ended, asked, done);
    if (!ended) {
      done.failure = ended.cause();
      return;
    }
    input_values<System> r;
    options.inputs.give(ended.time, ended.state, r);
    keep_numbers({given, ended, p, r}, done);
  }

  void keep_numbers(const ended_run<System>& ended, finished_run& done) const {
    double* to = study_columns::kept_in(layout_, done);
    for (const kept<System>& each : told_.keep) {
      *to = each.of(ended);
      if (std::isnan(*to++) && !each.may_be_missing) return done.fail(each.what.name + " is not a number");
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
    if (!told_.keep_events) return;
    for (const occurrence& each : ended.events) {
      const auto found = std::ranges::find(layout_.events, each.name);
      if (found == layout_.events.end())
        return done.fail("the event " + each.name + " is none of those that the study was told");
      done.events.emplace_back(static_cast<std::uint32_t>(found - layout_.events.begin()), each.t);
    }
  }

  static void keep_sample(const sample<System>& one, finished_run& done) {
    done.samples.push_back(one.t);
    done.samples.insert(done.samples.end(), one.x.data(), one.x.data() + one.x.size());
    done.samples.insert(done.samples.end(), one.r.data(), one.r.data() + one.r.size());
  }

  const study<System> told_;
  const given_to_systems<System> given_;
  bool needs_motion_ = false, needs_samples_ = false;
  study_layout layout_ = study_columns::layout_of(told_, known, type_name<System>());
  std::string mistake_{};
};

} // namespace kanexpr::ensembles
