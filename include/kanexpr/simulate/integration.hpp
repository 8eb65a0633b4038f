#pragma once

#include <kanexpr/compiled/assemble.hpp>
#include <kanexpr/simulate/check_options.hpp>
#include <kanexpr/simulate/departures.hpp>
#include <kanexpr/simulate/moving_system.hpp>
#include <kanexpr/simulate/sampling.hpp>
#include <kanexpr/simulate/simulation.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace kanexpr::simulated {

/// One simulation, from its first check to its end.
template <class System, integrator by>
class integration {
public:
  integration(const given_parameters<System>& p, const time_span& span,
              const simulation_options<System>& options)
      : options_(options), span_(span), around_(p.values, options.inputs, options.events), moving_(around_),
        sampling_(options, span, around_, result_.trajectory) {
    result_.trajectory = kanexpr::trajectory<System>(p.values);
    if (p.problem) fail(std::string(p.problem.view()));
  }

  simulation<System> run(const given_state<System>& x) {
    result_.time = span_.from;
    result_.state = x.values;
    if (begin(x)) {
      go();
      end();
    }
    return std::move(result_);
  }

private:
  using state = kanexpr::state<System>;
  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  using quaternions = compiled::unit_quaternions<System>;
  static constexpr bool is_constrained =
      known.constraints + known.configuration_constraints + known.quaternions != 0;

  solvers::stepper& stepper() { return moving_.stepper(); }

  bool fail(std::string why) {
    if (result_.reason.empty()) result_.reason = std::move(why);
    return false;
  }

  /// Ends the simulation where it stands.
  bool fail_here(const std::string& why) {
    std::string where = "the simulation ended at t = " + digits(result_.time) + " with ";
    for (int i = 0; i < known.coordinates + known.speeds; ++i)
      where +=
          (i == 0 ? "" : ", ") + surroundings<System>::name_of_state(i) + " = " + digits(result_.state(i));
    const std::string& because = around_.reason();
    return fail(where + ": " + why + (because.empty() || why.empty() ? "" : ": ") + because);
  }

  bool begin(const given_state<System>& x) {
    if (!result_.reason.empty()) return false;
    if (x.problem) return fail(std::string(x.problem.view()));
    solvers::stepper_options o = stepper_options();
    if (std::string wrong = check_options(options_, span_); !wrong.empty()) return fail(std::move(wrong));
    if (std::string wrong = read_tolerances(options_, o.absolute_tolerances); !wrong.empty())
      return fail(std::move(wrong));
    if (!assemble_at(span_.from, result_.state)) return false;
    if (moving_.start(span_.from, result_.state, o) != answer::given) return fail_here("");
    if (stepper().failed()) return fail_here(stepper().failed().sentence);
    return sampling_.begin(span_.from, result_.state) || fail_here("");
  }

  solvers::stepper_options stepper_options() const {
    const double latest = std::max(std::abs(span_.from), std::abs(span_.to));
    solvers::stepper_options o;
    o.end = span_.to;
    o.relative_tolerance = options_.relative_tolerance;
    o.first_step = options_.first_step;
    o.least_step = std::max(options_.least_step, 4 * std::numeric_limits<double>::epsilon() * latest);
    o.greatest_step = options_.greatest_step;
    o.most_drift = options_.most_drift;
    o.most_steps = options_.most_steps;
    o.analytic_jacobian = options_.analytic_jacobian;
    return o;
  }

  /// Lets the dependent coordinates and speeds follow. A quaternion that is given may be rounded, no more.
  bool assemble_at(double t, state& x) {
    if constexpr (!quaternions::are_bound)
      if (const status s = quaternions::normalize(x, {0.99, 1.01}); !s)
        return fail_here(std::string(s.cause()));
    if (around_.take(t, x) != answer::given) return fail_here("");
    if constexpr (is_constrained) {
      const assembly built = kanexpr::assemble<System>(x, around_.p(), around_.r(), t);
      if (!built) return fail_here(std::string(built.cause()));
      if (around_.take(t, x) != answer::given) return fail_here("");
    }
    return true;
  }

  void go() {
    const bool by_steps =
        sampling_.takes_each_step() || options_.dense || options_.progress || stepper().goes_by_steps();
    bool goes_on = true;
    while (goes_on && result_.time < span_.to) {
      const double target = by_steps || sampling_.is_over() ? span_.to : sampling_.next();
      const solvers::arrival arrived = stepper().advance(target, !by_steps);
      result_.time = stepper().time();
      std::copy_n(stepper().state(), result_.state.size(), result_.state.begin());
      if (arrived == solvers::arrival::failed) {
        sampling_.record_last(result_.time, result_.state);
        fail_here(stepper().failed().sentence);
        return;
      }
      if (stepper().steps() > options_.most_steps) {
        fail_here("the most steps that are allowed were taken");
        return;
      }
      around_.forget();
      if (options_.dense) sampling_.keep_polynomial(stepper(), result_.time, begun_);
      const std::vector<int> passed =
          arrived == solvers::arrival::event ? stepper().events() : std::vector<int>(options_.events.size());
      goes_on = (sampling_.go_on(stepper(), result_.time, result_.state) || fail_here("")) && is_seen(passed);
      if (goes_on && arrived == solvers::arrival::event) goes_on = pass_event(passed);
      if (options_.progress && goes_on)
        goes_on = around_.guarded("the progress function", [&] { options_.progress(result_.time, span_); }) ==
                      answer::given ||
                  fail_here("");
    }
  }

  /// Lets the handlers of what happened act, and goes on from the state that they leave.
  bool pass_event(const std::vector<int>& passed) {
    const double t = result_.time;
    if (is_endless(passed)) return fail_here(ever_faster);
    const auto& events = options_.events;
    state x = result_.state;
    if (around_.take(t, x) != answer::given) return fail_here("");
    bool stops = false, handled = false;
    for (std::size_t i = 0; i < events.size(); ++i) {
      if (passed[i] == 0) continue;
      result_.events.push_back({t, events[i].name});
      if (!events[i].handler) continue;
      handled = true;
      moment<System> now{t, x, around_.p(), around_.r()};
      const answer a = around_.guarded("the handler of the event " + events[i].name,
                                       [&] { stops |= events[i].handler(now) == after_event::stop; });
      if (a != answer::given) return fail_here("");
    }
    if (!handled) return true;
    const bool changed = x != result_.state;
    if (changed && !x.allFinite())
      return fail_here("the handler of an event left a state that is not finite");
    if (changed && !assemble_at(t, x)) return false;
    result_.state = x;
    if (changed && sampling_.takes_each_step() && !sampling_.record(t, x)) return fail_here("");
    result_.stopped_by_event = stops;
    if (stops) return false;
    begun_ = t;
    if (changed) departures_.note(t, x, passed, around_);
    return moving_.restart(x) || fail_here(stepper().failed().sentence);
  }

  bool is_seen(const std::vector<int>& passed) {
    return !departures_.missed(result_.time, result_.state, passed, around_) || fail_here(ever_faster);
  }

  /// Whether events pile up at one time.
  bool is_endless(const std::vector<int>& passed) {
    const double scale = std::max({1.0, std::abs(span_.from), std::abs(span_.to)});
    const double since = result_.time - last_event_;
    events_at_once_ = since <= 1e-12 * scale ? events_at_once_ + 1 : 0;
    last_event_ = result_.time;
    return events_at_once_ > 20 ||
           (since <= 1e-6 * scale && departures_.contradict(result_.time, result_.state, passed, around_));
  }

  void end() {
    result_.statistics = stepper().statistics();
    result_.statistics.rate_evaluations = moving_.motion.rate_evaluations();
    result_.statistics.projections = moving_.motion.projections();
    result_.statistics.events = static_cast<long>(result_.events.size());
  }

  static constexpr const char* ever_faster = "events happen ever faster; a handler must end that";

  const simulation_options<System>& options_;
  const time_span span_;
  surroundings<System> around_;
  moving_system<System, by> moving_;
  simulation<System> result_;
  sampling<System> sampling_;
  departures<System> departures_;
  double begun_ = -std::numeric_limits<double>::infinity();
  double last_event_ = -std::numeric_limits<double>::infinity();
  int events_at_once_ = 0;
};

} // namespace kanexpr::simulated
