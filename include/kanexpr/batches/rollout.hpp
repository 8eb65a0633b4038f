#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/batches/batch_stepper.hpp>
#include <kanexpr/batches/chunks.hpp>
#include <kanexpr/batches/system_statuses.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/steps/fixed_step.hpp>

#include <Eigen/Core>
#include <type_traits>
#include <utility>
#include <vector>

namespace kanexpr {

/// Options of a rollout.
struct rollout_options {
  double step = 0; ///< in the model's unit of time, seconds
  int steps = 0;
  int store_every = 0; ///< steps between two stored states; 0 keeps only the last state
  double start = 0;    ///< the start time
};

/// Advances many systems by steps of a fixed length, one batch at a time:
///
///     rollout<runge_kutta_4<System>> ahead(1000, {.step = 1e-3, .steps = 500, .store_every = 50});
///     ahead.run(x, p, r);                  // x, a many<eom::state>, advances by 500 steps
///     ahead.stored(0)[q1];                 // after 50 steps, of all systems
///
/// The states are the same as after separate calls of `step(t, x, h, p, r)`. Memory is allocated on
/// construction; a run neither allocates memory nor throws. A system whose step fails stays at its last valid
/// state, its status holds the cause, and states stored later are NaN; the other systems continue.
template <class Step, class Number = double, std::size_t lanes = batches::default_lanes<Number>>
class rollout {
  using batch_type = batch<lanes, Number>;
  static constexpr Eigen::Index width = static_cast<Eigen::Index>(lanes);

public:
  using state = batches::with_scalar<typename Step::eom::state, Number>;

  rollout(Eigen::Index systems, const rollout_options& how)
      : how_(how), statuses_(systems), steps_(static_cast<std::size_t>(statuses_.size())) {
    const int count = how.store_every > 0 && how.steps > 0 ? how.steps / how.store_every : 0;
    stored_.assign(static_cast<std::size_t>(count), many<state>(systems));
    times_.assign(stored_.size(), how.start);
  }

  Eigen::Index size() const { return statuses_.size(); }

  /// Advances the states x: run(x), (x, p) or (x, p, r). Parameters are `many` or one vector for all systems.
  /// Inputs are either constant over the run, as `many` or as one vector for all systems, or a function (t,
  /// x). The function is called with a batch of states if the type of x is generic, as in `[](double t, const
  /// auto& x) { … }`; otherwise it is called with one state after another. An optional first argument
  /// distributes the work among threads, as in `many_results::evaluate`. Returns the status of the first
  /// system that failed.
  template <class First, class... More>
  status run(First&& first, More&&... more) {
    using given = std::remove_reference_t<First>;
    constexpr bool are_many = !batches::single<std::remove_cv_t<given>>;
    constexpr bool can_move =
        !batches::is_many<std::remove_cv_t<given>> || std::is_same_v<given, many<state>>;
    static_assert(are_many, "run takes `many` states; for one state, call the step itself");
    static_assert(can_move, "run requires non-const `many` states of its system and precision");
    if constexpr (!are_many || !can_move)
      return {};
    else if constexpr (std::is_same_v<given, many<state>>)
      return run_by(batches::sequential{}, first, more...);
    else
      return run_by(std::forward<First>(first), more...);
  }

  /// Returns the number of times at which states were stored, and the states and the time of the k-th.
  int stored() const { return static_cast<int>(stored_.size()); }
  const many<state>& stored(int k) const { return stored_[static_cast<std::size_t>(k)]; }
  double time(int k) const { return times_[static_cast<std::size_t>(k)]; }

  /// Returns the status of a system, with the cause if it stopped early.
  const status& status_of(Eigen::Index system) const { return statuses_.of(system); }
  /// Returns the number of systems that stopped early.
  Eigen::Index failures() const { return statuses_.failures(); }
  /// Returns the number of steps that a system has taken.
  int steps_of(Eigen::Index system) const { return steps_[static_cast<std::size_t>(system)]; }

private:
  using none = compiled::omitted;

  template <class Executor, class Parameters = none, class Inputs = none>
  status run_by(Executor&& by, many<state>& x, const Parameters& p = {}, const Inputs& r = {}) {
    constexpr bool have_one_precision =
        batches::is_of_numbers<Parameters, Number> && batches::is_of_numbers<Inputs, Number>;
    constexpr bool have_inputs = batches::is_input_argument<Inputs, state, batch_type>;
    static_assert(have_one_precision,
                  "the precision of the `many` arguments differs from that of the states");
    static_assert(have_inputs, "the inputs must be those of one system, `many`, or a const function (t, x), "
                               "such as a lambda without `mutable`");
    if constexpr (!have_one_precision || !have_inputs)
      return {};
    else
      return run_given(std::forward<Executor>(by), x, p, r);
  }

  template <class Executor, class Parameters, class Inputs>
  status run_given(Executor&& by, many<state>& x, const Parameters& p, const Inputs& r) {
    if (x.size() != size() || !batches::has_size(p, size()) || !batches::has_size(r, size()))
      return refuse(status("the arguments and the rollout have different numbers of systems"));
    if (how_.steps < 0) return refuse(status("the number of steps is negative"));
    double t = how_.start;
    for (std::size_t k = 0; k < times_.size(); ++k) {
      for (int i = 0; i < how_.store_every; ++i) t += how_.step;
      times_[k] = t;
    }
    std::fill(steps_.begin(), steps_.end(), 0);
    statuses_.run(
        std::forward<Executor>(by), 2 * width, width,
        [&](Eigen::Index begin, Eigen::Index end) {
          Eigen::Index failed = 0;
          for (Eigen::Index first = begin; first < end; first += width)
            failed += move(x, first, (std::min)(width, end - first), p, r);
          return failed;
        },
        [&](Eigen::Index begin, Eigen::Index end) { set_to_nan(begin, end); });
    return statuses_.first();
  }

  status refuse(const status& why) {
    set_to_nan(0, size());
    std::fill(steps_.begin(), steps_.end(), 0);
    return statuses_.refuse(why);
  }

  /// Sets the stored states of the systems [begin, end) to NaN.
  void set_to_nan(Eigen::Index begin, Eigen::Index end) {
    for (many<state>& each : stored_) each.set_to_nan(begin, end);
  }

  /// Advances `count` systems from `first` on; returns how many of them did not reach the end.
  template <class Parameters, class Inputs>
  Eigen::Index move(many<state>& x, Eigen::Index first, Eigen::Index count, const Parameters& p,
                    const Inputs& r) {
    batches::batch_stepper<Step, batch_type, Parameters, Inputs> all(x, first, count, p, r, how_.start);
    int steps_made = 0;
    const auto leave = [&](std::size_t lane, const status& why) {
      const Eigen::Index system = first + static_cast<Eigen::Index>(lane);
      statuses_.set(system, why);
      steps_[static_cast<std::size_t>(system)] = steps_made;
      x.set(system, all.state_in(lane));
    };
    auto store = stored_.begin();
    while (steps_made < how_.steps && all.active_count() > 0) {
      if (!all.step(how_.step, leave)) continue;
      ++steps_made;
      if (store != stored_.end() && steps_made % how_.store_every == 0)
        all.store_into(*store++, first, count);
    }
    while (store != stored_.end()) all.store_into(*store++, first, count); // no system is left
    for (std::size_t lane = 0; lane < lanes; ++lane)
      if (all.is_active(lane)) leave(lane, {});
    return count - all.active_count();
  }

  std::vector<many<state>> stored_;
  std::vector<double> times_;
  rollout_options how_;
  batches::system_statuses statuses_;
  std::vector<int> steps_;
};

} // namespace kanexpr
