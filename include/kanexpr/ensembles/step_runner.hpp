#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/batches/batch_stepper.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/ensembles/study_runs.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/constraints/contradiction.hpp>
#include <kanexpr/simulations/inputs/prescribed_rates.hpp>
#include <kanexpr/steps/assemble.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// Represents inputs given by name instead of by a function (t, x).
struct constant_inputs {};

/// Performs runs with steps of a fixed length, one run in each lane of a SIMD vector.
template <class Step, class Law, class Number>
class step_runner {
public:
  using kind = step_kind<Step, Number>;
  using context = study_context<kind>;
  static constexpr std::size_t lanes = batch<batches::default_lanes<Number>, Number>::lanes;

private:
  using System = typename kind::System;
  using vectors = batch<batches::default_lanes<Number>, Number>;
  using number = typename vectors::number;
  using runs_span = std::span<finished_run>;
  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  static constexpr bool has_law = !std::is_same_v<Law, constant_inputs>;
  using parameters = many<parameter_values<System, Number>>;
  using inputs = many<input_values<System, Number>>;
  using stepper = batches::batch_stepper<Step, vectors, parameters, std::conditional_t<has_law, Law, inputs>>;

public:
  explicit step_runner(Law law = {}) : law_(std::move(law)) {}

  std::string find_mistake(const context& of) const {
    const auto& [study, values, layout] = of;
    if (has_law && values.specifies_inputs)
      return "the inputs are specified twice, by the study and by a function";
    if (!has_law && !values.inputs.mistake().empty()) return values.inputs.mistake();
    if (!(numeric::is_finite(study.span.step) && numeric::is_finite(study.span.start)))
      return "the step and the start of a study must be finite";
    if (study.span.steps < 0) return "the number of steps must be at least 0";
    if (study.simulation.look_every < 1) return "look_every must be at least 1";
    return {};
  }

  static void write_identity(const context& of, saver& all) {
    const step_span& span = of.study.span;
    const step_options& how = of.study.simulation;
    all(std::string(type_name<Step>()), compiled::digest_of_model<System>, sizeof(Number), has_law, span.step,
        span.steps, span.start, how.guesses_dependent, how.look_every);
    for (const auto& each : of.study.keep) all(each.identity);
  }

  void perform(const context& of, runs_span runs) const {
    values_of_lanes at;
    for (std::size_t lane = 0; lane < runs.size(); ++lane)
      if (!runs[lane].has_failed()) attempt(runs[lane], [&] { begin(of, lane, at, runs[lane]); });
    const auto sound = std::ranges::find(runs, false, &finished_run::has_failed);
    if (sound == runs.end()) return;
    // Lanes without a valid run repeat a valid one.
    for (std::size_t lane = 0; lane < lanes; ++lane)
      if (lane >= runs.size() || runs[lane].has_failed())
        at.copy(static_cast<std::size_t>(sound - runs.begin()), lane);
    stepper all(at.x, 0, static_cast<Eigen::Index>(lanes), at.p, inputs_of(at), of.study.span.start);
    finished_run together; // an exception in the input function affects all lanes
    attempt(together, [&] { move(of, all, at, runs); });
    for (finished_run& each : runs)
      if (together.has_failed() && !each.has_failed()) each.fail(together.failure);
  }

private:
  struct values_of_lanes {
    many<state<System, Number>> x{static_cast<Eigen::Index>(lanes)};
    parameters p{static_cast<Eigen::Index>(lanes)};
    inputs r{static_cast<Eigen::Index>(lanes)};
    std::vector<number> outputs{};

    void copy(std::size_t from, std::size_t to) {
      const auto source = static_cast<Eigen::Index>(from), target = static_cast<Eigen::Index>(to);
      x.set(target, x.get(source)), p.set(target, p.get(source)), r.set(target, r.get(source));
    }
  };

  template <class Vector, class Given>
  static Vector rounded(const Given& given) {
    return Vector(given.template cast<Number>());
  }
  input_values<System> inputs_at(double t, const state<System>& x) const {
    return law_(t, rounded<state<System, Number>>(x)).template cast<double>();
  }

  void begin(const context& of, std::size_t lane, values_of_lanes& at, finished_run& done) const {
    const double start = of.study.span.start;
    auto [x, p, r] = of.setup(of.varied(done));
    if constexpr (has_law) r = inputs_at(start, x);
    done.set_end(start, x);
    if (const auto mistake = given_parameters<System>(p).mistake)
      return done.fail(std::string(mistake.view()));
    if constexpr (known.constraints + known.configuration_constraints + known.quaternions > 0) {
      const state<System> given = x;
      if (const assembly built = assemble<System>(x, p, r, start); !built) return done.fail(built.cause());
      std::string mistake = of.study.simulation.guesses_dependent
                                ? std::string()
                                : simulations::contradiction_at_start(known, given, x, [&](std::size_t i) {
                                    return of.values.sets(given, i);
                                  });
      if (!mistake.empty()) return done.fail(std::move(mistake));
    }
    if (std::string mistake = mistake_in_rates(of.study.span, x, r); !mistake.empty())
      return done.fail(std::move(mistake));
    const auto place = static_cast<Eigen::Index>(lane);
    at.x.set(place, rounded<state<System, Number>>(x));
    at.p.set(place, rounded<parameter_values<System, Number>>(p));
    at.r.set(place, rounded<input_values<System, Number>>(r));
  }

  /// Returns a mistake in the rates of prescribed quantities.
  std::string mistake_in_rates(const step_span& span, const state<System>& x,
                               const input_values<System>& r) const {
    if constexpr (!simulations::has_prescribed_rates(known)) {
      return {};
    } else if constexpr (!has_law) {
      return simulations::contradiction_in_constants(known, r.data());
    } else {
      return simulations::contradiction_in_function(
          known, time_span{span.start, span.start + span.step * span.steps}, x.data(),
          [this](double t, const double* at, double* into) {
            const input_values<System> given = inputs_at(t, state<System>(at));
            std::copy_n(given.data(), given.size(), into);
          });
    }
  }

  const auto& inputs_of(const values_of_lanes& at) const {
    if constexpr (has_law)
      return law_;
    else
      return at.r;
  }
  /// Returns the inputs of all lanes; `held` contains them if they are constant.
  template <class State, class Inputs>
  decltype(auto) inputs_of(double t, const State& x, const Inputs& held) const {
    if constexpr (!has_law)
      return (held);
    else if constexpr (batches::accepts_batch<Law, State>())
      return law_(t, x);
    else
      return batches::per_lane_inputs<vectors, input_values<System, Number>, Law>{law_}(t, x);
  }

  static double time(stepper& all) {
    return all.evaluate_now([](double t, const auto&, const auto&, const auto&) { return t; });
  }

  void move(const context& of, stepper& all, values_of_lanes& at, runs_span runs) const {
    const auto fail_lane = [&](std::size_t lane, const status& why) {
      if (lane >= runs.size() || runs[lane].has_failed()) return;
      runs[lane].set_end(time(all), all.state_in(lane));
      runs[lane].fail(why.cause());
    };
    const int steps = of.study.span.steps;
    update_outputs(of, all, at, runs, 0);
    for (int made = 0; made < steps && all.active_count() > 0;) {
      if (!all.step(of.study.span.step, fail_lane)) continue;
      ++made;
      if (made % of.study.simulation.look_every == 0 || made == steps)
        update_outputs(of, all, at, runs, made);
    }
    for (std::size_t lane = 0; lane < runs.size(); ++lane)
      if (!runs[lane].has_failed()) end(of, all, at, lane, runs[lane]);
  }

  /// Updates the outputs of all lanes, and takes samples.
  void update_outputs(const context& of, stepper& all, values_of_lanes& at, runs_span runs, int made) const {
    const bool is_first = at.outputs.empty();
    at.outputs.resize(of.study.keep.size());
    for (std::size_t i = 0; i < of.study.keep.size(); ++i) {
      const auto& output = of.study.keep[i];
      if (output.when == aggregate::at_end && made < of.study.span.steps) continue;
      const number values = all.evaluate_now([&](double t, const auto& x, const auto& p, const auto& r) {
        return output.of(t, x, p, inputs_of(t, x, r));
      });
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const Number now = batches::lane_of(values, lane), before = batches::lane_of(at.outputs[i], lane);
        if (is_first || replaces(output.when, now, before)) batches::set_lane(at.outputs[i], lane, now);
      }
    }
    for (std::size_t lane = 0; of.study.keep_trajectories && lane < runs.size(); ++lane)
      if (!runs[lane].has_failed())
        all.evaluate_now([&](double t, const auto& x, const auto&, const auto& r) {
          runs[lane].add_sample(t, all.state_in(lane), vectors::get(inputs_of(t, x, r), lane));
        });
  }
  /// A NaN is never replaced.
  static bool replaces(aggregate when, Number now, Number before) {
    if (numeric::elementary::detail::is_nan(before) || numeric::elementary::detail::is_nan(now) ||
        when == aggregate::at_end)
      return !numeric::elementary::detail::is_nan(before);
    return when == aggregate::greatest ? now > before : now < before;
  }

  static void end(const context& of, stepper& all, const values_of_lanes& at, std::size_t lane,
                  finished_run& done) {
    done.set_end(time(all), all.state_in(lane));
    for (std::size_t i = 0; i < of.study.keep.size(); ++i)
      if (!of.keep(done, i, batches::lane_of(at.outputs[i], lane))) return;
  }

  Law law_;
};

} // namespace kanexpr::ensembles
