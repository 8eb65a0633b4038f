#pragma once

#include <kanexpr/ensemble/given_to_runs.hpp>
#include <kanexpr/ensemble/job.hpp>
#include <kanexpr/ensemble/study_in_steps.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulate/contradiction.hpp>
#include <kanexpr/simulate/prescribed_rates.hpp>
#include <kanexpr/steps/assemble.hpp>

#include <algorithm>
#include <exception>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// Where the inputs of a study in steps come from, unless from a function: what they are given by name.
struct constant_inputs {};

/// The runs of a study in steps, as many side by side as a vector of the processor has numbers.
template <class Step, class Law, class Number>
class stepped_study final : public job {
  using System = typename study_in_steps<Step, Number>::System;
  using side_by_side_ = batch<batches::widest<Number>, Number>;
  using number = typename side_by_side_::number;
  static constexpr std::size_t lanes = side_by_side_::lanes;
  static constexpr const deriving::survey& known = compiled::survey_of<System>;
  static constexpr bool has_law = !std::is_same_v<Law, constant_inputs>;
  using states = many<state<System, Number>>;
  using parameters = many<parameter_values<System, Number>>;
  using inputs = many<input_values<System, Number>>;
  using given_inputs_type = std::conditional_t<has_law, Law, inputs>;
  using moving = batches::moving_batch<Step, side_by_side_, parameters, given_inputs_type>;

public:
  stepped_study(study_in_steps<Step, Number> told, Law law)
      : told_(std::move(told)), law_(std::move(law)), given_(told_), mistake_(find_mistake()) {}

  /// What was told wrongly, as a sentence.
  const std::string& mistake() const { return mistake_; }
  /// By what it is known from others, beside its layout.
  std::string text() const {
    bytes_writer all;
    all.put(type_name<Step>()), all.put(compiled::digest_of_model<System>);
    all.put(sizeof(Number)), all.put(has_law), all.put(static_cast<bool>(told_.for_each_run));
    all.put(told_.guesses_dependent);
    all.put(told_.step), all.put(told_.steps), all.put(told_.start), all.put(told_.look_every);
    for (const auto& each : told_.keep) all.put(each.text);
    return given_.text(told_) + all.bytes();
  }

  const study_layout& layout() const override { return layout_; }
  std::size_t side_by_side() const override { return lanes; }
  std::vector<finished_run> run(std::size_t first, std::size_t count) const override {
    std::vector<finished_run> all(count);
    for (std::size_t i = 0; i < count; i += lanes)
      run_batch(first + i, (std::min)(lanes, count - i), all.data() + i);
    return all;
  }

private:
  std::string find_mistake() const {
    if (!given_.mistake.empty()) return given_.mistake;
    if (has_law && given_.gives_inputs) return "the inputs are told twice, by the study and by a function";
    if (!has_law && !given_.inputs.mistake().empty()) return given_.inputs.mistake();
    if (!(numeric::is_finite(told_.step) && numeric::is_finite(told_.start)))
      return "the steps of the study are not finite";
    if (told_.steps < 0) return "the number of steps is negative";
    if (told_.look_every < 1) return "a study looks at its runs after a step at least";
    if (std::string mistake = mistake_in(layout_.columns); !mistake.empty()) return mistake;
    if (!told_.for_each_run) return {};
    return mistake_in_call([&] {
      const run_values first(told_.runs, 0);
      run_setup<System> one = given_.in(first);
      auto change = told_.for_each_run;
      change(first, one);
    });
  }

  /// What a batch of runs is given, and how it stands.
  struct lanes_of_runs {
    states x{static_cast<Eigen::Index>(lanes)};
    parameters p{static_cast<Eigen::Index>(lanes)};
    inputs r{static_cast<Eigen::Index>(lanes)};
    std::vector<number> extremes{};
  };

  void run_batch(std::size_t first, std::size_t count, finished_run* done) const {
    lanes_of_runs of;
    for (std::size_t lane = 0; lane < count; ++lane) begin(first + lane, lane, of, done[lane]);
    // Runs that could not begin go along as others, and so do lanes without a run.
    if (const auto sound = std::find_if(done, done + count, is_sound); sound != done + count) {
      for (std::size_t lane = 0; lane < lanes; ++lane)
        if (lane >= count || !is_sound(done[lane])) copy(static_cast<std::size_t>(sound - done), lane, of);
      moving all(of.x, 0, static_cast<Eigen::Index>(lanes), of.p, inputs_of(of), told_.start);
      try {
        move(all, of, count, done);
      } catch (const std::exception& thrown) {
        fail_all(thrown.what(), count, done);
      } catch (...) {
        fail_all("something was thrown that is no std::exception", count, done);
      }
    }
    for (std::size_t lane = 0; lane < count; ++lane) study_columns::complete(told_, layout_, done[lane]);
  }

  /// What a function of the inputs throws at one of them it throws at all that go side by side.
  static void fail_all(const std::string& why, std::size_t count, finished_run* done) {
    for (std::size_t lane = 0; lane < count; ++lane)
      if (is_sound(done[lane])) done[lane].fail(why);
  }

  static bool is_sound(const finished_run& one) { return one.end != run_end::failed; }

  void begin(std::size_t run, std::size_t lane, lanes_of_runs& of, finished_run& done) const {
    done.run = run;
    done.values = study_columns::row_of(layout_, run);
    try {
      const run_values given(told_.runs, run);
      const auto place = static_cast<Eigen::Index>(lane);
      study_columns::begin(done, given);
      run_setup<System> one = given_.in(given);
      if (auto change = told_.for_each_run) change(given, one);
      auto& [x, p, r] = one;
      if constexpr (has_law) r = law_(told_.start, rounded<state<System, Number>>(x)).template cast<double>();
      done.stand_at(told_.start, x);
      if (const auto mistake = given_parameters<System>(p).mistake)
        return done.fail(std::string(mistake.view()));
      if constexpr (known.constraints + known.configuration_constraints + known.quaternions > 0) {
        const state<System> told = x;
        if (const assembly built = assemble<System>(x, p, r, told_.start); !built)
          return done.fail(built.cause());
        if (std::string mistake = contradiction_at_start(told, x); !mistake.empty())
          return done.fail(std::move(mistake));
      }
      if (std::string mistake = contradiction_in_rates(x, r); !mistake.empty())
        return done.fail(std::move(mistake));
      of.x.set(place, rounded<state<System, Number>>(x));
      of.p.set(place, rounded<parameter_values<System, Number>>(p));
      of.r.set(place, rounded<input_values<System, Number>>(r));
    } catch (const std::exception& thrown) {
      done.fail(thrown.what());
    } catch (...) {
      done.fail("something was thrown that is no std::exception");
    }
  }

  std::string contradiction_at_start(const state<System>& told, const state<System>& found) const {
    if (told_.guesses_dependent) return {};
    return simulated::contradiction_at_start(known, told, found,
                                             [&](std::size_t i) { return given_.tells(told, i); });
  }

  /// In rates of prescribed quantities.
  std::string contradiction_in_rates(const state<System>& x, const input_values<System>& r) const {
    if constexpr (!simulated::has_prescribed_rates(known)) {
      return {};
    } else if constexpr (!has_law) {
      return simulated::contradiction_in_constants(known, r.data());
    } else {
      const time_span span{told_.start, told_.start + told_.step * told_.steps};
      return simulated::contradiction_in_function(
          known, span, x.data(), [this](double t, const double* at, double* into) {
            const input_values<System> given =
                law_(t, rounded<state<System, Number>>(state<System>(at))).template cast<double>();
            std::copy_n(given.data(), given.size(), into);
          });
    }
  }

  template <class Vector, class Given>
  static Vector rounded(const Given& given) {
    return Vector(given.template cast<Number>());
  }

  static void copy(std::size_t from, std::size_t to, lanes_of_runs& of) {
    const auto source = static_cast<Eigen::Index>(from), target = static_cast<Eigen::Index>(to);
    of.x.set(target, of.x.get(source)), of.p.set(target, of.p.get(source)),
        of.r.set(target, of.r.get(source));
  }

  const given_inputs_type& inputs_of(const lanes_of_runs& of) const {
    if constexpr (has_law)
      return law_;
    else
      return of.r;
  }

  static double time(moving& all) {
    return all.at_present([](double t, const auto&, const auto&, const auto&) { return t; });
  }

  void move(moving& all, lanes_of_runs& of, std::size_t count, finished_run* done) const {
    const auto leave = [&](std::size_t lane, const status& why) {
      if (lane >= count || !is_sound(done[lane])) return;
      done[lane].stand_at(time(all), all.state_in(lane));
      done[lane].fail(why.cause());
    };
    look(all, of, count, done, 0);
    for (int made = 0; made < told_.steps && all.living() > 0;) {
      if (!all.step(told_.step, leave)) continue;
      ++made;
      if (made % told_.look_every == 0 || made == told_.steps) look(all, of, count, done, made);
    }
    for (std::size_t lane = 0; lane < count; ++lane)
      if (is_sound(done[lane])) end(all, of, lane, done[lane]);
  }

  number value(const kept_in_steps<System, Number>& each, moving& all) const {
    return all.at_present([&](double t, const auto& x, const auto& p, const auto& r) {
      if constexpr (has_law)
        return each.of(t, x, p, inputs_by_law(t, x));
      else
        return each.of(t, x, p, r);
    });
  }
  template <class State>
  auto inputs_by_law(double t, const State& x) const {
    if constexpr (batches::takes_batches<Law, State>())
      return law_(t, x);
    else
      return batches::lane_by_lane<side_by_side_, input_values<System, Number>, Law>{law_}(t, x);
  }

  void look(moving& all, lanes_of_runs& of, std::size_t count, finished_run* done, int made) const {
    const bool is_first = of.extremes.empty();
    if (is_first) of.extremes.resize(told_.keep.size());
    for (std::size_t i = 0; i < told_.keep.size(); ++i) {
      const kept_in_steps<System, Number>& each = told_.keep[i];
      if (each.when == in_time::at_end && made < told_.steps) continue;
      const number now = value(each, all);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const Number at = batches::lane_of(now, lane), before = batches::lane_of(of.extremes[i], lane);
        const bool is_kept = is_first || each.when == in_time::at_end || elementary::detail::is_nan(at) ||
                             (each.when == in_time::greatest ? at > before : at < before);
        if (is_kept && !(elementary::detail::is_nan(before) && !is_first))
          batches::set_lane(of.extremes[i], lane, at);
      }
    }
    if (told_.keep_trajectories) keep_samples(all, count, done);
  }

  void keep_samples(moving& all, std::size_t count, finished_run* done) const {
    const double t = time(all);
    for (std::size_t lane = 0; lane < count; ++lane) {
      if (!is_sound(done[lane])) continue;
      const auto x = all.state_in(lane);
      const auto r = all.at_present([&](double now, const auto& at, const auto&, const auto& held) {
        if constexpr (has_law)
          return side_by_side_::get(inputs_by_law(now, at), lane);
        else
          return side_by_side_::get(held, lane);
      });
      done[lane].samples.push_back(t);
      done[lane].samples.insert(done[lane].samples.end(), x.data(), x.data() + x.size());
      done[lane].samples.insert(done[lane].samples.end(), r.data(), r.data() + r.size());
    }
  }

  void end(moving& all, const lanes_of_runs& of, std::size_t lane, finished_run& done) const {
    done.stand_at(time(all), all.state_in(lane));
    double* to = study_columns::kept_in(layout_, done);
    for (std::size_t i = 0; i < told_.keep.size(); ++i) {
      to[i] = batches::lane_of(of.extremes[i], lane);
      if (elementary::detail::is_nan(to[i])) return done.fail(told_.keep[i].what.name + " is not a number");
    }
  }

  const study_in_steps<Step, Number> told_;
  const Law law_;
  const given_to_systems<System> given_;
  const study_layout layout_ = study_columns::layout_of(told_, known, type_name<System>());
  const std::string mistake_;
};

} // namespace kanexpr::ensembles
