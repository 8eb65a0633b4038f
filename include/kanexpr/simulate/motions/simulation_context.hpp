#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulate/constraints/manifold.hpp>
#include <kanexpr/simulate/motions/unknown_name_error.hpp>
#include <kanexpr/simulate/settings.hpp>
#include <kanexpr/simulate/sundials/initial_value_problem.hpp>
#include <kanexpr/simulate/system.hpp>
#include <kanexpr/simulate/motions/vectors.hpp>

#include <algorithm>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::simulated {

using solvers::answer;

/// Everything that acts on a system in a simulation: its inputs at each time and state, the watched events,
/// and the cause of the last refusal. Exceptions from user functions are caught here.
class surroundings {
public:
  using vector = Eigen::VectorXd;

  surroundings(simulated::system& of, const time_span& span, const settings& options)
      : of_(of), span_(span), options_(options), x_(vector::Zero(of.states())),
        sizes_(vector::Ones(of.states())), r_(of.known.inputs), constraints_(own_manifold(of)) {}

  simulated::system& system() { return of_; }
  const simulated::system& system() const { return of_; }
  const deriving::survey& known() const { return of_.known; }

  /// Integrators count time from the start, because floating-point numbers are finest near zero.
  double time(double elapsed) const {
    return elapsed < length() ? (std::min)(span_.from + elapsed, span_.to) : span_.to;
  }
  double elapsed(double t) const { return t - span_.from; }
  double length() const { return span_.to - span_.from; }

  const vector& x() const { return x_; }
  const vector& r() const { return r_; }
  bool inputs_depend_on_state() const { return options_.inputs_depend_on_state; }
  const std::vector<watched_event>& events() const { return options_.events; }

  /// Returns the magnitudes of the entries of the state, in their units.
  const vector& sizes() const { return sizes_; }
  void set_sizes(double t, const vector& x, const vector& sizes) {
    sizes_ = sizes;
    if (constraints_ != nullptr && take(t, x) == answer::given) constraints_->set_sizes(t, x, r_, sizes);
  }

  /// Returns the manifold of the constraints; null if there are none.
  manifold* constraints() { return constraints_.get(); }
  /// Reports the end of a step. `least` is the distinctness of the constraints below which the equations of
  /// all speeds are used.
  void come_to(double t, const vector& x, double least) {
    if (binds_speeds() && take(t, x) == answer::given) constraints_->come_to(t, x, r_, least);
  }
  bool is_near_singular() const { return binds_speeds() && constraints_->is_near_singular(); }

  /// Sets the time and state, and evaluates the inputs there.
  answer take(double t, const double* y) {
    std::copy_n(y, x_.size(), x_.data());
    return take_inputs(t);
  }
  answer take(double t, const vector& x) { return take(t, x.data()); }

  /// Evaluates ẋ at the current state: from the independent speeds, or from all speeds where those do not
  /// determine it.
  status rates(double t, double* xdot) const { return rates(t, x_, xdot); }
  /// Evaluates ẋ at a different state with the current inputs.
  status rates(double t, const vector& x, double* xdot) const {
    if (is_near_singular()) return constraints_->rates(t, x, r_, xdot);
    const status s = of_.rates(t, x.data(), r_.data(), xdot);
    return s || !binds_speeds() || !constraints_->rates(t, x, r_, xdot) ? s : status();
  }

  answer watch(double t, const double* y, double* values) {
    if (const answer a = take(t, y); a != answer::given) return a;
    for (std::size_t i = 0; i < events().size(); ++i) {
      const answer a =
          guarded("the event ", events()[i].name, [&] { values[i] = of_.event(i, t, x_.data(), r_.data()); });
      if (a != answer::given) return a;
      if (!numeric::is_finite(values[i]))
        return refuse("the value of the event " + events()[i].name + " is not a number");
    }
    return answer::given;
  }
  int direction(int i) const { return events()[static_cast<std::size_t>(i)].direction; }

  /// Records why an evaluation has no result here.
  answer refuse(std::string why) {
    last_refusal_ = std::move(why);
    return answer::not_here;
  }
  answer refuse(const status& s) { return refuse(s.cause()); }
  /// Returns the cause of the last refusal since `forget`.
  const std::string& last_refusal() const { return last_refusal_; }
  void forget() { last_refusal_.clear(); }
  /// Whether a user function has ever thrown.
  bool has_thrown() const { return has_thrown_; }

  /// Calls a user function.
  template <class Function>
  answer guarded(std::string_view what, const Function& call) {
    return guarded(what, "", call);
  }
  template <class Function>
  answer guarded(std::string_view what, std::string_view which, const Function& call) {
    try {
      call();
      return answer::given;
    } catch (const misnamed& found) {
      last_refusal_.assign(what).append(which).append(": ").append(found.what());
    } catch (const std::exception& thrown) {
      last_refusal_.assign(what).append(which).append(" threw: ").append(thrown.what());
    } catch (...) {
      last_refusal_.assign(what).append(which).append(" threw something that is not a std::exception");
    }
    has_thrown_ = true;
    return answer::never;
  }

  std::string name_of_state(int entry) const { return std::string(known().names[entry].view()); }

private:
  bool binds_speeds() const { return known().constraints != 0 && constraints_ != nullptr; }

  answer take_inputs(double t) {
    if (r_.size() == 0) return answer::given;
    const answer a = guarded("the input function", [&] { of_.give_inputs(t, x_.data(), r_.data()); });
    if (a != answer::given) return a;
    for (int i = 0; i < known().inputs; ++i)
      if (!numeric::is_finite(r_(i))) {
        const auto name = known().names[known().first_of(symbolic::symbol_kind::input) + i].view();
        refuse("the input function leaves input " + std::string(name) + " without a finite value");
        return answer::never;
      }
    return answer::given;
  }

  simulated::system& of_;
  const time_span span_;
  const settings& options_;
  vector x_, sizes_, r_;
  std::unique_ptr<manifold> constraints_;
  std::string last_refusal_{};
  bool has_thrown_ = false;
};

} // namespace kanexpr::simulated
