#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/constraints/manifold.hpp>
#include <kanexpr/simulations/settings.hpp>
#include <kanexpr/simulations/sundials/stepper.hpp>
#include <kanexpr/simulations/system_interface.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::simulations {

inline constexpr const char* off_manifold = "the constraints are dependent or inconsistent near this state";

/// Everything that acts on a system in a simulation: its inputs at each time and state, the watched events,
/// and the last error. Exceptions from user functions are caught here.
class simulation_context {
public:
  using vector = Eigen::VectorXd;

  simulation_context(system_interface& of, const time_span& span, const settings& options)
      : of_(of), span_(span), options_(options), x_(vector::Zero(of.states())),
        sizes_(vector::Ones(of.states())), r_(of.known.inputs), constraints_(manifold_for(of)) {}

  system_interface& system() { return of_; }
  const system_interface& system() const { return of_; }
  const derivation::survey& known() const { return of_.known; }

  /// Integrators count time from the start, because floating-point numbers are most closely spaced near zero.
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
    if (constraints_ != nullptr && set_state(t, x) == answer::success)
      constraints_->set_sizes(t, x, r_, sizes);
  }

  /// Returns the absolute tolerance of each entry of the state.
  const std::vector<double>& absolute_tolerances() const { return absolute_tolerances_; }
  void set_absolute_tolerances(const std::vector<double>& each) { absolute_tolerances_ = each; }
  /// Returns the tolerated error of a step in each entry of a state.
  vector tolerances_at(const vector& x) const {
    vector both(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i)
      both(i) =
          options_.relative_tolerance * std::abs(x(i)) + absolute_tolerances_[static_cast<std::size_t>(i)];
    return both;
  }

  /// Returns the manifold of the constraints; null if there are none.
  manifold* constraints() { return constraints_.get(); }
  /// Reports the end of a step. `least` is the distinctness of the constraints below which the equations for
  /// all speeds are used.
  void update_singularity(double t, const vector& x, double least) {
    if (binds_speeds() && set_state(t, x) == answer::success)
      constraints_->update_singularity(t, x, r_, least);
  }
  bool is_near_singular() const { return binds_speeds() && constraints_->is_near_singular(); }

  /// Sets the time and state, and evaluates the inputs there.
  answer set_state(double t, const double* y) {
    std::copy_n(y, x_.size(), x_.data());
    return evaluate_inputs(t);
  }
  answer set_state(double t, const vector& x) { return set_state(t, x.data()); }

  /// Evaluates ẋ at the current state: from the independent speeds, or from all speeds if those do not
  /// determine it.
  status rates(double t, double* xdot) const { return rates(t, x_, xdot); }
  /// Evaluates ẋ at a different state with the current inputs.
  status rates(double t, const vector& x, double* xdot) const {
    if (is_near_singular()) return constraints_->rates(t, x, r_, xdot);
    const status s = of_.evaluate(results::rates, {t, x.data(), r_.data()}, {xdot});
    return s || !binds_speeds() || !constraints_->rates(t, x, r_, xdot) ? s : status();
  }

  /// Evaluates the rates of a state with the inputs at that time and state; returns false if they cannot be
  /// evaluated.
  bool find_rates(double t, const vector& x, vector& xdot) {
    if (set_state(t, x) != answer::success) return false;
    xdot.resize(x.size());
    return static_cast<bool>(rates(t, xdot.data())) && numeric::all_finite(xdot);
  }

  answer evaluate_events(double t, const double* y, double* values) {
    if (const answer a = set_state(t, y); a != answer::success) return a;
    for (std::size_t i = 0; i < events().size(); ++i) {
      const answer a = call_user_function("the event ", events()[i].name,
                                          [&] { values[i] = of_.event(i, t, x_.data(), r_.data()); });
      if (a != answer::success) return a;
      if (!numeric::is_finite(values[i]))
        return fail("the value of the event " + events()[i].name + " is not a number");
    }
    return answer::success;
  }
  int direction(int i) const { return events()[static_cast<std::size_t>(i)].direction; }

  /// Records why an evaluation failed.
  answer fail(std::string why) {
    last_error_ = std::move(why);
    return answer::recoverable;
  }
  answer fail(const status& s) { return fail(s.cause()); }
  /// Fails with a message if an entry is not finite.
  template <class Entries>
  answer check_finite(const Entries& entries, const char* not_finite) {
    return numeric::all_finite(entries) ? answer::success : fail(not_finite);
  }
  /// Returns the last error since `clear_error`.
  const std::string& last_error() const { return last_error_; }
  void clear_error() { last_error_.clear(); }
  /// Whether a user function has ever thrown.
  bool has_thrown() const { return has_thrown_; }

  /// Calls a user function.
  template <class Function>
  answer call_user_function(std::string_view what, const Function& call) {
    return call_user_function(what, "", call);
  }
  template <class Function>
  answer call_user_function(std::string_view what, std::string_view which, const Function& call) {
    try {
      call();
      return answer::success;
    } catch (const unknown_name_error& found) {
      last_error_.assign(what).append(which).append(": ").append(found.what());
    } catch (const std::exception& thrown) {
      last_error_.assign(what).append(which).append(" threw: ").append(thrown.what());
    } catch (...) {
      last_error_.assign(what).append(which).append(" threw something that is not a std::exception");
    }
    has_thrown_ = true;
    return answer::unrecoverable;
  }

  std::string name_of_state(int entry) const { return std::string(known().names[entry].view()); }

private:
  bool binds_speeds() const { return known().constraints != 0 && constraints_ != nullptr; }

  answer evaluate_inputs(double t) {
    if (r_.size() == 0) return answer::success;
    const answer a =
        call_user_function("the input function", [&] { of_.evaluate_inputs(t, x_.data(), r_.data()); });
    if (a != answer::success) return a;
    for (int i = 0; i < known().inputs; ++i)
      if (!numeric::is_finite(r_(i))) {
        const auto name = known().names[known().first_of(symbolic::symbol_kind::input) + i].view();
        fail("the input function leaves input " + std::string(name) + " without a finite value");
        return answer::unrecoverable;
      }
    return answer::success;
  }

  system_interface& of_;
  const time_span span_;
  const settings& options_;
  vector x_, sizes_, r_;
  std::vector<double> absolute_tolerances_{};
  std::unique_ptr<manifold> constraints_;
  std::string last_error_{};
  bool has_thrown_ = false;
};

/// Returns x + h k. This and the next functions are plain loops, which compile faster than Eigen expressions.
inline Eigen::VectorXd moved(const Eigen::VectorXd& x, double h, const Eigen::VectorXd& k) {
  Eigen::VectorXd to(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) to(i) = x(i) + h * k(i);
  return to;
}

/// Returns the largest magnitude of the quotients of the entries of a and b.
inline double largest(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double most = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) most = (std::max)(most, std::abs(a(i) / b(i)));
  return most;
}

/// Takes a step with the midpoint rule and one with the classic Runge-Kutta method, from a state with its
/// rates; returns false if the rates cannot be evaluated.
inline bool runge_kutta_step(simulation_context& context, double t, const Eigen::VectorXd& x,
                             const Eigen::VectorXd& k1, double h, Eigen::VectorXd& midpoint,
                             Eigen::VectorXd& end) {
  Eigen::VectorXd k2, k3, k4;
  if (!context.find_rates(t + h / 2, moved(x, h / 2, k1), k2) ||
      !context.find_rates(t + h / 2, moved(x, h / 2, k2), k3) ||
      !context.find_rates(t + h, moved(x, h, k3), k4))
    return false;
  midpoint = moved(x, h, k2);
  end.resize(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) end(i) = x(i) + h / 6 * (k1(i) + 2 * k2(i) + 2 * k3(i) + k4(i));
  return true;
}

} // namespace kanexpr::simulations
