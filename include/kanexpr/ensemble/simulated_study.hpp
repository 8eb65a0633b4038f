#pragma once

#include <kanexpr/ensemble/given_to_runs.hpp>
#include <kanexpr/ensemble/job.hpp>
#include <kanexpr/ensemble/study.hpp>
#include <kanexpr/ensemble/study_columns.hpp>
#include <kanexpr/simulate/check_options.hpp>
#include <kanexpr/simulate/output_schedule.hpp>
#include <kanexpr/simulate/simulate.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
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
  /// By what it is known from others, beside its layout. Of functions it is known whether there are any.
  std::string text() const {
    const simulation_options<System>& o = told_.simulation;
    bytes_writer all;
    all.put(simulated::compiled_system<System, by>::digest());
    for (double each :
         {told_.span.from, told_.span.to, o.relative_tolerance, o.absolute_tolerance.value_or(-1),
          o.output_every, o.first_step, o.least_step, o.greatest_step})
      all.put(each);
    all.put(static_cast<int>(by)), all.put(o.most_steps), all.put(o.output_times);
    for (bool each : {o.guesses_dependent, o.analytic_jacobian, o.dense, o.keep, o.inputs.depends_on_state(),
                      static_cast<bool>(o.each_sample), static_cast<bool>(told_.for_each_run)})
      all.put(each);
    all.put(o.absolute_tolerances.size());
    for (const named_value& each : o.absolute_tolerances) all.put(each.what.name()), all.put(each.value);
    all.put(o.events.size());
    for (const event<System>& each : o.events) {
      all.put(each.name), all.put(each.text), all.put(static_cast<int>(each.direction));
      all.put(static_cast<bool>(each.handler)), all.put(each.handler.always().has_value());
      if (const auto& always = each.handler.always()) all.put(static_cast<int>(*always));
    }
    all.put(o.inputs.constants().has_value());
    if (const auto& inputs = o.inputs.constants())
      for (Eigen::Index i = 0; i < inputs->values.size(); ++i) all.put(inputs->values(i));
    for (const kept<System>& each : told_.keep) all.put(each.event), all.put(each.text);
    return given_.text(told_) + all.bytes();
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
    if (told_.keep_events && layout_.events.empty()) return "the study has no events that it could keep";
    if (told_.for_each_run) return mistake_in_function();
    simulation_options<System> options = told_.simulation;
    options.keep = true;
    if (given_.gives_inputs)
      options.inputs = given_inputs<System>(given_.inputs.in(run_values(told_.runs, 0)));
    if (std::string mistake = simulated::check_options(simulated::settings_of(options), told_.span);
        !mistake.empty())
      return mistake;
    return mistake_in_events(told_.simulation);
  }

  std::string mistake_in_events(const simulation_options<System>& options) const {
    for (const kept<System>& each : told_.keep)
      if (!each.event.empty() &&
          std::ranges::find(options.events, each.event, &event<System>::name) == options.events.end())
        return "the simulations of the study have no event " + each.event;
    return {};
  }

  /// A name that the function asks for, of the first run as of all.
  std::string mistake_in_function() const {
    return mistake_in_call([&] { setup(run_values(told_.runs, 0)); });
  }

  simulation_setup<System> setup(const run_values& given) const {
    simulation_setup<System> one{given_.in(given), told_.simulation};
    const input_values<System> before = one.r;
    if (auto change = told_.for_each_run) change(given, one);
    const bool changes_inputs =
        !std::equal(before.begin(), before.end(), one.r.begin(), [](double a, double b) {
          return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
        });
    if (given_.gives_inputs || changes_inputs) one.options.inputs = given_inputs<System>(one.r);
    return one;
  }

  finished_run run_one(std::size_t run) const {
    finished_run done;
    done.run = run;
    done.values = study_columns::row_of(layout_, run);
    try {
      const run_values given(told_.runs, run);
      study_columns::begin(done, given);
      simulate_one(given, done);
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
    if (std::string mistake = mistake_in_events(options); !mistake.empty())
      return done.fail(std::move(mistake));
    if (!needs_motion_ && !needs_samples_ && !told_.keep_trajectories && !options.each_sample)
      options.output_every = 0, options.output_times = {told_.span.to}, options.keep = true;
    const std::vector<double> times = options.output_times;
    const simulated::output_schedule asked(told_.span, options.output_every, times);
    const auto each_sample = options.each_sample;
    const bool shows_others = needs_motion_ && !asked.takes_each_step();
    if (needs_motion_) {
      if (std::string mistake = simulated::check_options(simulated::settings_of(options), told_.span);
          !mistake.empty())
        return done.fail(std::move(mistake));
      options.output_every = 0, options.output_times.clear(), options.keep = options.dense = true;
      if (shows_others) options.each_sample = {};
    }
    const simulation<System> ended =
        simulate<System, by>(start_of(one.x), given_parameters<System>(p), told_.span, options);
    done.stand_at(ended.time, ended.state);
    done.end = !ended                   ? run_end::failed
               : ended.stopped_by_event ? run_end::stopped_by_event
                                        : run_end::reached_end;
    if (!ended) done.failure = ended.cause();
    input_values<System> r;
    if (ended) options.inputs.give(ended.time, ended.state, r);
    if (shows_others) {
      const simulation<System> shown = sampled(ended, p, options.inputs, asked, each_sample);
      keep_all({given, shown, p, r, ended.trajectory, options.inputs}, done);
    } else {
      keep_all({given, ended, p, r, ended.trajectory, options.inputs}, done);
    }
  }

  /// Without the dependent coordinates and speeds that neither the study nor its function told.
  given_state<System> start_of(const state<System>& x) const {
    given_state<System> start(x);
    for (std::size_t i = 0; i < start.is_left_out.size(); ++i) start.is_left_out[i] = !given_.tells(x, i);
    return start;
  }

  /// The same simulation with the samples that it was asked for, of one with every step.
  static simulation<System> sampled(const simulation<System>& of, const parameter_values<System>& p,
                                    const input_source<System>& inputs, simulated::output_schedule asked,
                                    const std::function<void(const sample<System>&)>& each_sample) {
    simulation<System> shown;
    shown.trajectory = trajectory<System>(p);
    shown.events = of.events, shown.statistics = of.statistics, shown.time = of.time, shown.state = of.state;
    shown.stopped_by_event = of.stopped_by_event, shown.failure = of.failure;
    for (; !asked.is_over() && asked.next() <= of.time; asked.pass())
      if (auto found = of.trajectory.at(asked.next())) {
        inputs.give(found->t, found->x, found->r);
        shown.trajectory.add(*found);
        if (each_sample) each_sample(*found);
      }
    return shown;
  }

  void keep_all(const ended_run<System>& ended, finished_run& done) const {
    keep_lists(ended.run, done);
    if (done.end != run_end::failed) keep_numbers(ended, done);
  }

  void keep_numbers(const ended_run<System>& ended, finished_run& done) const {
    double* to = study_columns::kept_in(layout_, done);
    for (const kept<System>& each : told_.keep) {
      *to = each.of(ended);
      if (elementary::detail::is_nan(*to++) && !each.may_be_missing)
        return done.fail(each.what.name + " is not a number");
    }
  }

  void keep_lists(const simulation<System>& ended, finished_run& done) const {
    if (told_.keep_trajectories)
      for (const sample<System>& each : ended.trajectory) keep_sample(each, done);
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
