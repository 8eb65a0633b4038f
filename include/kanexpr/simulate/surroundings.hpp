#pragma once

#include <kanexpr/compiled/equations_of_motion.hpp>
#include <kanexpr/simulate/event.hpp>
#include <kanexpr/simulate/input_source.hpp>
#include <kanexpr/simulate/sundials/initial_value_problem.hpp>
#include <kanexpr/simulate/time_span.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::simulated {

using solvers::answer;

/// What acts on a system in a simulation: its parameters, its inputs at each time and state, the events that
/// are watched; and the reason of the last refusal, in words. What its user's functions throw ends here.
template <class System>
class surroundings {
public:
  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  using state = kanexpr::state<System>;

  surroundings(const parameter_values<System>& p, const time_span& span, const input_source<System>& inputs,
               const std::vector<event<System>>& events)
      : p_(p), span_(span), source_(inputs), events_(events) {}

  /// Integrators count the time from the start, as numbers are finest near zero.
  double time(double elapsed) const {
    return elapsed < length() ? (std::min)(span_.from + elapsed, span_.to) : span_.to;
  }
  double elapsed(double t) const { return t - span_.from; }
  double length() const { return span_.to - span_.from; }

  const parameter_values<System>& p() const { return p_; }
  const state& x() const { return x_; }
  const input_values<System>& r() const { return r_; }
  const input_source<System>& source() const { return source_; }
  const std::vector<event<System>>& events() const { return events_; }

  /// How large the entries of the state are, in whatever units.
  const state& sizes() const { return sizes_; }
  void set_sizes(const state& sizes) { sizes_ = sizes; }

  /// Goes to a time and a state, whose inputs are then known.
  answer take(double t, const double* y) {
    x_ = Eigen::Map<const typename state::base>(y);
    return take_inputs(t);
  }
  answer take(double t, const state& x) {
    x_ = x;
    return take_inputs(t);
  }

  answer watch(double t, const double* y, double* values) {
    if (const answer a = take(t, y); a != answer::given) return a;
    for (std::size_t i = 0; i < events_.size(); ++i) {
      const answer a =
          guarded("the event ", events_[i].name, [&] { values[i] = events_[i].value(t, x_, p_, r_); });
      if (a != answer::given) return a;
      if (!std::isfinite(values[i]))
        return refuse("the value of the event " + events_[i].name + " is not a number");
    }
    return answer::given;
  }
  int direction(int i) const { return static_cast<int>(events_[static_cast<std::size_t>(i)].direction); }

  /// Notes why an evaluation has no result here.
  answer refuse(std::string why) {
    reason_ = std::move(why);
    return answer::not_here;
  }
  answer refuse(const status& s) { return refuse(std::string(s.cause())); }
  /// The reason of the last refusal since `forget`.
  const std::string& reason() const { return reason_; }
  void forget() { reason_.clear(); }

  /// Calls a function of the user.
  template <class Function>
  answer guarded(std::string_view what, const Function& call) {
    return guarded(what, "", call);
  }
  template <class Function>
  answer guarded(std::string_view what, std::string_view which, const Function& call) {
    try {
      call();
      return answer::given;
    } catch (const std::exception& thrown) {
      reason_.assign(what).append(which).append(" threw: ").append(thrown.what());
    } catch (...) {
      reason_.assign(what).append(which).append(" threw something that is not a std::exception");
    }
    return answer::never;
  }

  static std::string name_of_state(int entry) { return std::string(known.names[entry].view()); }

private:
  answer take_inputs(double t) {
    if constexpr (known.inputs != 0) {
      const answer a = guarded("the function of the inputs", [&] { source_.give(t, x_, r_); });
      if (a != answer::given) return a;
      for (int i = 0; i < known.inputs; ++i)
        if (!std::isfinite(r_(i))) {
          const auto name = known.names[known.first_of(symbolic::symbol_kind::input) + i].view();
          refuse("the function of the inputs gives input " + std::string(name) + " no finite value");
          return answer::never;
        }
    }
    static_cast<void>(t);
    return answer::given;
  }

  parameter_values<System> p_;
  const time_span span_;
  const input_source<System>& source_;
  const std::vector<event<System>>& events_;
  state x_{}, sizes_ = state::Ones();
  input_values<System> r_{};
  std::string reason_{};
};

} // namespace kanexpr::simulated
