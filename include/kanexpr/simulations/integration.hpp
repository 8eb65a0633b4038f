#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/check_options.hpp>
#include <kanexpr/simulations/constraints/contradiction.hpp>
#include <kanexpr/simulations/events/events_at_start.hpp>
#include <kanexpr/simulations/inputs/prescribed_rates.hpp>
#include <kanexpr/simulations/motions/moving_system.hpp>
#include <kanexpr/simulations/motions/state_sizes.hpp>
#include <kanexpr/simulations/sampling.hpp>
#include <kanexpr/steps/assemble.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::simulations {

/// One simulation, from its first check to its end.
template <integrator by>
class integration {
public:
  integration(system_interface& of, const time_span& span, const settings& options)
      : options_(options), span_(span), context_(of, span, options), moving_(context_),
        sampling_(options, span, context_) {}

  simulation_end run(double* x) {
    result_.time = span_.from;
    state_ = Eigen::Map<const state>(x, context_.system().states());
    if (begin()) {
      integrate();
      end();
    }
    std::copy_n(state_.data(), state_.size(), x);
    return std::move(result_);
  }

private:
  using state = Eigen::VectorXd;

  const derivation::survey& known() const { return context_.known(); }
  simulations::stepper& stepper() { return moving_.stepper(); }

  bool fail(std::string why) {
    if (result_.failure.empty()) result_.failure = std::move(why);
    return false;
  }

  /// Ends the simulation at its current state.
  bool fail_here(const std::string& why) {
    const std::string because = context_.last_error();
    if (has_begun_) sampling_.finish(result_.time, state_);
    std::string where = "the simulation ended at t = " + digits(result_.time) + " with ";
    for (int i = 0; i < context_.system().states(); ++i)
      where += (i == 0 ? "" : ", ") + context_.name_of_state(i) + " = " + digits(state_(i));
    return fail(where + ": " + why + (because.empty() || why.empty() ? "" : ": ") + because);
  }

  /// Fails if there is a mistake; returns true if there is none.
  bool passes(const std::string& mistake) { return mistake.empty() || fail(mistake); }

  bool begin() {
    simulations::stepper_options o = stepper_options();
    state first = state_;
    if (!passes(check_options(options_, span_)) || !assemble_at(span_.from, first) ||
        !passes(contradiction_at_start(first)))
      return false;
    state_ = first;
    if (!passes(contradiction_in_rates())) return false;
    const state_sizes found(context_, span_.from, first, context_.length());
    context_.set_sizes(span_.from, first, found.sizes());
    if (!passes(read_tolerances(context_.system(), options_, found.sizes(), o.absolute_tolerances)))
      return false;
    context_.set_absolute_tolerances(o.absolute_tolerances);
    context_.update_singularity(span_.from, state_, moving_.least_distinctness);
    if (moving_.start(state_, o) != answer::success) return fail_here("");
    if (!stepper().failure().empty()) return fail_here(stepper().failure());
    if (context_.is_near_singular()) set_tolerances();
    has_begun_ = true;
    return sampling_.begin(span_.from, state_) || fail_here("");
  }

  std::string contradiction_at_start(const state& found) const {
    if (options_.guesses_dependent) return {};
    const auto is_given = [&](std::size_t i) {
      return options_.is_left_out.empty() || !options_.is_left_out[i];
    };
    return simulations::contradiction_at_start(known(), state_, found, is_given);
  }

  /// Returns a contradiction in the rates of prescribed quantities.
  std::string contradiction_in_rates() const {
    if (!has_prescribed_rates(known())) return {};
    if (options_.inputs_are_constant) return contradiction_in_constants(known(), context_.r().data());
    return contradiction_in_function(known(), span_, state_.data(), context_.system().copy_of_inputs());
  }

  void update_singularity(double t, const state& x) {
    const bool was_near = context_.is_near_singular();
    context_.update_singularity(t, x, moving_.least_distinctness);
    if (context_.is_near_singular() == was_near) return;
    set_tolerances();
    has_tightened_tolerances_ = was_near && options_.relative_tolerance < least_tolerance_near_singular;
  }

  /// Continues with the equations for all speeds if a step fails near a singular position.
  bool continue_near_singular() {
    if (context_.is_near_singular() || context_.has_thrown()) return false;
    context_.update_singularity(result_.time, state_, not_far);
    if (!context_.is_near_singular()) return false;
    context_.clear_error();
    set_tolerances();
    return restart();
  }

  /// Raises tolerances that are too small near a singular position, where the rates are less accurate and no
  /// step would satisfy them.
  void set_tolerances() {
    const double least = context_.is_near_singular() ? least_tolerance_near_singular : 0;
    std::vector<double> absolute = context_.absolute_tolerances();
    for (std::size_t i = 0; i < absolute.size(); ++i)
      absolute[i] = (std::max)(absolute[i], least * context_.sizes()(static_cast<Eigen::Index>(i)));
    moving_.set_tolerances((std::max)(options_.relative_tolerance, least), absolute);
  }

  simulations::stepper_options stepper_options() const {
    return {.end = context_.length(),
            .relative_tolerance = options_.relative_tolerance,
            .first_step = options_.first_step,
            .least_step = (std::max)(options_.least_step, shortest_step(span_)),
            .greatest_step = options_.greatest_step,
            .analytic_jacobian = options_.analytic_jacobian};
  }

  /// Solves for the dependent coordinates and speeds.
  bool assemble_at(double t, state& x) {
    if (context_.set_state(t, x) != answer::success) return fail_here("");
    manifold* const constraints = context_.constraints();
    if (!constraints) return true;
    const assembly built = constraints->assemble(t, x, context_.r());
    if (!built) return fail_here(built.cause());
    return context_.set_state(t, x) == answer::success || fail_here("");
  }

  /// Checks that the redundant constraints, which are not solved for anything, still follow from the others.
  bool holds_redundant(double t, const state& x) {
    if (known().redundant_constraints == 0 || context_.constraints() == nullptr) return true;
    if (context_.set_state(t, x) != answer::success) return fail_here("");
    double error = options_.relative_tolerance;
    for (int i = 0; i < context_.system().states(); ++i)
      error = (std::max)(error,
                         context_.absolute_tolerances()[static_cast<std::size_t>(i)] / context_.sizes()(i));
    const double tolerance = (std::max)(1e-6, 1e3 * error); // steps leave residuals in the other constraints
    const base::sentence violation =
        context_.constraints()->redundant_violation(t, x, context_.r(), tolerance);
    return !violation || fail_here(violation.cause() + " at t = " + digits(t) +
                                   ": it does not follow from the other constraints");
  }

  void integrate() {
    std::vector<int> passed;
    bool goes_on = events_at_start_.begin(result_.time, state_, context_.length(), passed) ||
                   fail_here("an event could not be evaluated");
    if (goes_on && is_any(passed)) goes_on = pass_event(passed);
    while (goes_on && elapsed_ < context_.length()) goes_on = step();
  }

  /// Takes one step of the integrator. The simulation stays at the beginning of the step until the end of the
  /// step is accepted.
  bool step() {
    if (moving_.steps() >= options_.most_steps) return fail_here("the maximum number of steps was reached");
    const arrival arrived = stepper().advance(context_.length());
    if (arrived == arrival::failed) return continue_near_singular() || fail_here(stepper().failure());
    context_.clear_error();
    events_at_start_.set_look_ahead(stepper().step_end() - stepper().step_begin());
    double elapsed = stepper().time(), t = context_.time(elapsed);
    state x = Eigen::Map<const state>(stepper().state(), state_.size());
    if (!numeric::all_finite(x)) return fail_here(overflow_message(x));
    std::vector<int> passed =
        arrived == arrival::event ? stepper().events() : std::vector<int>(options_.events.size());
    if (events_at_start_.has_missed_return(t, x, passed)) return fail_here(ever_faster);
    const std::vector<int> left = events_at_start_.left(t, x, passed);
    if (is_any(left)) {
      find_departure(left, elapsed, x);
      t = context_.time(elapsed);
    }
    if (!holds_redundant(t, x)) return false;
    elapsed_ = elapsed, result_.time = t, state_ = x;
    update_singularity(t, x);
    if (options_.dense) sampling_.keep_polynomial(stepper(), elapsed, begun_);
    if (!sampling_.record_due_samples(stepper(), elapsed, state_)) return fail_here("");
    if (is_any(left)) return pass_event(left) && restart();
    if (is_any(passed) && !(is_passing(passed) && pass_event(passed))) return false;
    if ((moving_.has_to_change() || has_tightened_tolerances_) && elapsed_ < context_.length() && !restart())
      return false;
    return !options_.progress ||
           context_.call_user_function("the progress function",
                                       [&] { options_.progress(result_.time, span_); }) == answer::success ||
           fail_here("");
  }

  /// Goes back to the point where functions that were zero leave zero: the beginning of the step or, for a
  /// jump, a point within it.
  void find_departure(const std::vector<int>& left, double& elapsed, state& x) {
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * elapsed;
    double before = elapsed_;
    state middle = x;
    if (events_at_start_.is_beyond(result_.time, state_, left)) elapsed = before;
    while (elapsed - before > rounding) {
      const double half = before + (elapsed - before) / 2;
      if (!sampling_.state_at(stepper(), half, middle)) break;
      if (events_at_start_.is_beyond(context_.time(half), middle, left))
        elapsed = half, x = middle;
      else
        before = half;
    }
    context_.clear_error();
    if (elapsed - elapsed_ <= 2 * rounding) elapsed = elapsed_, x = state_;
  }

  std::string overflow_message(const state& x) const {
    int i = 0;
    while (numeric::is_finite(x(i))) ++i;
    return context_.name_of_state(i) + " overflows double";
  }

  /// Rejects functions that stay at zero; integrators report an arbitrary time for them.
  bool is_passing(const std::vector<int>& passed) {
    const int resting = events_at_start_.stationary_event(result_.time, state_, passed);
    return resting < 0 || fail_here("the event " + options_.events[static_cast<std::size_t>(resting)].name +
                                    " stays at zero; it must pass through zero");
  }

  static bool is_any(const std::vector<int>& passed) {
    return std::ranges::any_of(passed, [](int each) { return each != 0; });
  }

  /// Calls the handlers of the events that occurred, and continues from the state that they leave.
  bool pass_event(const std::vector<int>& passed) {
    const double t = result_.time;
    if (is_endless(passed)) return fail_here(ever_faster);
    const auto& events = options_.events;
    state x = state_;
    if (context_.set_state(t, x) != answer::success) return fail_here("");
    bool stops = false, handled = false;
    for (std::size_t i = 0; i < events.size(); ++i) {
      if (passed[i] == 0) continue;
      result_.events.push_back({t, events[i].name});
      if (!events[i].has_handler) continue;
      handled = true;
      const answer a = context_.call_user_function("the handler of the event " + events[i].name, [&] {
        stops |= context_.system().handle(i, t, x.data(), context_.r().data()) == after_event::stop;
      });
      if (a != answer::success) return fail_here("");
    }
    if (!handled) return !(time_is_coarse() && events_at_start_.is_zero(passed)) || restart();
    const bool changed = x != state_;
    if (changed && !numeric::all_finite(x))
      return fail_here("the handler of an event left a state that is not finite");
    if (changed) {
      const state given = x;
      if (!assemble_at(t, x)) return false;
      const auto is_changed = [&](std::size_t i) {
        const auto k = static_cast<Eigen::Index>(i);
        return !base::equal(given(k), state_(k));
      };
      if (std::string mistake = contradiction(known(), given, x, is_changed); !mistake.empty())
        return fail_here(mistake + " after the handler of an event");
    }
    events_at_start_.record_passed(t, state_, x, passed);
    state_ = x;
    if (changed && sampling_.takes_each_step() && !sampling_.record(t, x)) return fail_here("");
    result_.stopped_by_event = stops;
    return !stops && restart();
  }

  /// Restarts the integrator at the current state.
  bool restart() {
    begun_ = elapsed_, has_tightened_tolerances_ = false;
    return moving_.restart(elapsed_, state_) || fail_here(stepper().failure());
  }

  /// Whether the time is so large that a function may stay at zero for longer than the integrators allow.
  bool time_is_coarse() const { return std::abs(result_.time) > 64 * elapsed_; }

  /// Whether one event occurs again and again at the same time.
  bool is_endless(const std::vector<int>& passed) {
    const double t = elapsed_, length = context_.length();
    bool is_soon = false;
    for (std::size_t i = 0; i < passed.size(); ++i) {
      if (passed[i] == 0) continue;
      repetition& r = repetitions_[i];
      r.times = t - r.last <= 1e-12 * length ? r.times + 1 : 0;
      is_soon |= t - r.last <= 1e-6 * length;
      r.last = t;
      if (r.times > 20) return true;
    }
    return is_soon && events_at_start_.contradict(result_.time, state_, passed);
  }

  void end() {
    result_.statistics = moving_.statistics();
    result_.statistics.events = static_cast<long>(result_.events.size());
  }

  static constexpr double least_tolerance_near_singular = 1e-10;
  static constexpr double not_far = 0.5; ///< a distinctness of the constraints
  static constexpr const char* ever_faster = "events occur faster and faster; a handler must stop this";

  const settings& options_;
  const time_span span_;
  simulation_context context_;
  moving_system<by> moving_;
  simulation_end result_{};
  state state_{}; ///< the current state
  sampling sampling_;
  events_at_start events_at_start_{context_};
  double elapsed_ = 0; ///< the time from the start to the current state
  double begun_ = -std::numeric_limits<double>::infinity();
  /// Counts how many times in succession an event has occurred at the same time.
  struct repetition {
    double last = -std::numeric_limits<double>::infinity();
    int times = 0;
  };
  std::vector<repetition> repetitions_ = std::vector<repetition>(options_.events.size());
  bool has_begun_ = false;
  bool has_tightened_tolerances_ = false; ///< the tolerances are tighter than in the integrator's last steps
};

template <integrator by>
simulation_end run(system_interface& moved, double* state, const time_span& span, const settings& options) {
  return integration<by>(moved, span, options).run(state);
}

} // namespace kanexpr::simulations
