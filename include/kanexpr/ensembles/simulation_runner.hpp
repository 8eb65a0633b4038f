#pragma once

#include <kanexpr/ensembles/study_runs.hpp>
#include <kanexpr/simulations/check_options.hpp>
#include <kanexpr/simulations/output_schedule.hpp>
#include <kanexpr/simulations/simulate.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// Performs runs with `simulate`.
template <class System, integrator by>
class simulation_runner {
public:
  using kind = simulation_kind<System>;
  using context = study_context<kind>;
  using options = simulation_options<System>;
  static constexpr std::size_t lanes = 1;

  static std::string find_mistake(const context& of) {
    if (of.values.specifies_inputs && of.study.simulation.inputs.mistake().view().empty())
      return "the inputs are specified twice, by the study and by the options of its simulations";
    if (of.study.for_each_run) return {}; // which may change the options
    options checked = of.study.simulation;
    checked.keep = true;
    if (of.values.specifies_inputs)
      checked.inputs = given_inputs<System>(of.values.inputs.in(run_values(of.study.runs, 0)));
    std::string mistake = simulations::check_options(simulations::settings_of(checked), of.study.span);
    return mistake.empty() ? mistake_in_events(of, of.study.simulation) : mistake;
  }

  static void write_identity(const context& of, saver& all) {
    const options& o = of.study.simulation;
    all(simulations::compiled_system<System, by>::digest(), by, of.study.span.from, of.study.span.to,
        o.relative_tolerance, o.absolute_tolerance, o.output_every, o.output_times, o.first_step,
        o.least_step, o.greatest_step, o.most_steps, o.guesses_dependent, o.analytic_jacobian, o.dense,
        o.keep, o.inputs.depends_on_state(), static_cast<bool>(o.each_sample));
    all(o.absolute_tolerances.size());
    for (const named_value& each : o.absolute_tolerances) all(each.what.name(), each.value);
    all(o.events.size());
    for (const event<System>& each : o.events)
      all(each.name, each.text, each.direction, static_cast<bool>(each.handler), each.handler.always());
    all(o.inputs.constants().has_value());
    if (const auto& inputs = o.inputs.constants()) all(inputs->values);
    for (const run_output<System>& each : of.study.keep) all(each.event, each.identity);
  }

  static void perform(const context& of, std::span<finished_run> runs) {
    for (finished_run& each : runs)
      if (!each.has_failed()) attempt(each, [&] { perform(of, each); });
  }

private:
  static std::string mistake_in_events(const context& of, const options& simulation) {
    for (const run_output<System>& each : of.study.keep)
      if (!each.event.empty() &&
          std::ranges::find(simulation.events, each.event, &event<System>::name) == simulation.events.end())
        return "the simulations of the study have no event " + each.event;
    return {};
  }

  static simulation_setup<System> setup(const context& of, const run_values& varied) {
    simulation_setup<System> one = of.setup(varied);
    const input_values<System> before = of.values.inputs.in(varied);
    const bool changes_inputs =
        !std::equal(before.begin(), before.end(), one.r.begin(), [](double a, double b) {
          return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
        });
    if (of.values.specifies_inputs || changes_inputs) one.options.inputs = given_inputs<System>(one.r);
    return one;
  }

  static void perform(const context& of, finished_run& done) {
    const auto any = [&](auto needed) { return std::ranges::any_of(of.study.keep, needed); };
    const bool needs_motion = any(&run_output<System>::needs_motion);
    const run_values varied = of.varied(done);
    simulation_setup<System> one = setup(of, varied);
    options& how = one.options;
    done.set_end(of.study.span.from, one.x);
    if (std::string mistake = mistake_in_events(of, how); !mistake.empty())
      return done.fail(std::move(mistake));
    if (!needs_motion && !any(&run_output<System>::needs_samples) && !of.study.keep_trajectories &&
        !how.each_sample)
      how.output_every = 0, how.output_times = {of.study.span.to}, how.keep = true;
    const std::vector<double> times = how.output_times;
    const simulations::output_schedule requested(of.study.span, how.output_every, times);
    const auto each_sample = how.each_sample;
    const bool is_resampled = needs_motion && !requested.takes_each_step();
    if (needs_motion) {
      if (std::string mistake = simulations::check_options(simulations::settings_of(how), of.study.span);
          !mistake.empty())
        return done.fail(std::move(mistake));
      how.output_every = 0, how.output_times.clear(), how.keep = how.dense = true;
      if (is_resampled) how.each_sample = {};
    }
    const simulation<System> ended =
        simulate<System, by>(start_of(of, one.x), given_parameters<System>(one.p), of.study.span, how);
    done.set_end(ended.time, ended.state);
    if (ended.stopped_by_event) done.end = run_end::stopped_by_event;
    if (!ended) done.fail(ended.cause());
    input_values<System> r;
    if (ended) how.inputs.give(ended.time, ended.state, r);
    simulation<System> resampled;
    if (is_resampled) resampled = sampled(ended, one.p, how.inputs, requested, each_sample);
    const simulation<System>& reported = is_resampled ? resampled : ended;
    keep_samples(of, reported, done);
    if (!done.has_failed())
      keep_outputs(of, {varied, reported, one.p, r, ended.trajectory, how.inputs}, done);
  }

  /// Returns the initial state without the dependent coordinates and speeds that neither the study nor its
  /// function sets.
  static given_state<System> start_of(const context& of, const state<System>& x) {
    given_state<System> start(x);
    for (std::size_t i = 0; i < start.is_left_out.size(); ++i) start.is_left_out[i] = !of.values.sets(x, i);
    return start;
  }

  /// Reduces a simulation with all of its steps to the requested samples.
  static simulation<System> sampled(const simulation<System>& of, const parameter_values<System>& p,
                                    const input_source<System>& inputs,
                                    simulations::output_schedule requested,
                                    const std::function<void(const sample<System>&)>& each_sample) {
    simulation<System> reported;
    reported.trajectory = trajectory<System>(p);
    reported.events = of.events, reported.statistics = of.statistics, reported.time = of.time,
    reported.state = of.state;
    reported.stopped_by_event = of.stopped_by_event, reported.failure = of.failure;
    for (; !requested.is_over() && requested.next() <= of.time; requested.advance())
      if (auto found = of.trajectory.at(requested.next())) {
        inputs.give(found->t, found->x, found->r);
        reported.trajectory.add(*found);
        if (each_sample) each_sample(*found);
      }
    return reported;
  }

  static void keep_outputs(const context& of, const ended_run<System>& ended, finished_run& done) {
    for (std::size_t i = 0; i < of.study.keep.size(); ++i)
      if (const run_output<System>& each = of.study.keep[i];
          !of.keep(done, i, each.of(ended), each.may_be_missing))
        return;
  }

  static void keep_samples(const context& of, const simulation<System>& ended, finished_run& done) {
    if (of.study.keep_trajectories)
      for (const sample<System>& each : ended.trajectory) done.add_sample(each.t, each.x, each.r);
    if (!of.study.keep_events) return;
    for (const occurrence& each : ended.events) {
      const auto found = std::ranges::find(of.layout.events, each.name);
      if (found == of.layout.events.end())
        return done.fail("the event " + each.name + " is not an event of the study");
      done.events.emplace_back(static_cast<std::uint32_t>(found - of.layout.events.begin()), each.t);
    }
  }
};

} // namespace kanexpr::ensembles
