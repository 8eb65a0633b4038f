#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/simulations/constraints/manifold.hpp>
#include <kanexpr/simulations/motions/simulation_context.hpp>
#include <kanexpr/simulations/output_schedule.hpp>
#include <kanexpr/simulations/sundials/stepper.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <new>
#include <optional>
#include <utility>
#include <vector>

namespace kanexpr::simulations {

/// Takes the samples of a simulation when they are due, and stores them or passes them on. If a sample cannot
/// be taken, the context reports the cause.
class sampling {
public:
  using state = Eigen::VectorXd;

  sampling(const settings& options, const time_span& span, simulation_context& context)
      : options_(options), schedule_(span, options.output_every, options.output_times), context_(context),
        manifold_(context.constraints()) {}
  sampling(const sampling&) = delete;
  sampling& operator=(const sampling&) = delete;

  bool takes_each_step() const { return schedule_.takes_each_step(); }

  /// Takes the samples that are due before the first step.
  bool begin(double t, const state& x) {
    if (takes_each_step()) return record(t, x);
    for (; !schedule_.is_over() && schedule_.next() <= t; schedule_.advance())
      if (!record(t, x)) return false;
    return true;
  }

  /// Takes the samples that became due during a step, up to an elapsed time. If a sample is due at that time,
  /// the state is projected onto the constraints.
  bool record_due_samples(stepper& s, double elapsed, state& x) {
    const double t = context_.time(elapsed);
    if (takes_each_step()) return record(t, x);
    for (; !schedule_.is_over(); schedule_.advance()) {
      const double next = schedule_.next(), due = context_.elapsed(next);
      if (due > elapsed) break;
      if (due < elapsed) {
        state between = x;
        if (!interpolate(s, due, between) || !project(next, between) || !record(next, between)) return false;
      } else if ((!s.reports_projected_states() && !project(t, x)) || !record(t, x)) {
        return false;
      }
    }
    return true;
  }

  bool record(double t, const state& x) {
    if (context_.set_state(t, x) != answer::success) return false;
    const double* r = context_.r().data();
    try {
      if (options_.keep) context_.system().store_sample(t, x.data(), r);
    } catch (const std::bad_alloc&) {
      context_.fail("no memory is left for another sample");
      return false;
    }
    last_ = {t, x};
    is_refused_ = options_.shows_samples && context_.call_user_function("the function each_sample", [&] {
      context_.system().pass_sample(t, x.data(), r);
    }) != answer::success;
    return !is_refused_;
  }

  /// Records the time and state that were reached as the last sample. If that sample is rejected or does not
  /// fit, resets t and x to the last recorded sample.
  void finish(double& t, state& x) {
    if (!last_) return;
    const bool is_taken = base::equal(last_->t, t) && last_->x == x;
    if (!is_taken && !is_refused_ && last_->t <= t) record(t, x);
    t = last_->t, x = last_->x;
  }

  /// Stores the polynomial of the last step up to an elapsed time; it begins no earlier than the last event.
  void keep_polynomial(stepper& s, double elapsed, double last_event) {
    piece p{context_.time((std::max)(s.step_begin(), last_event)), context_.time(elapsed), {}};
    double factorial = 1;
    for (int k = 0; k <= s.degree(); ++k) {
      if (k > 0) factorial *= k;
      if (!s.derivative(elapsed, k, buffer_for(s))) break;
      for (int i = 0; i < context_.system().states(); ++i)
        p.coefficients.push_back(whole_[static_cast<std::size_t>(i)] / factorial);
    }
    if (!p.coefficients.empty() && p.begin < p.end) context_.system().store_polynomial(std::move(p));
  }

  /// Evaluates the state at a time within the last step.
  bool state_at(stepper& s, double elapsed, state& x) {
    return interpolate(s, elapsed, x) && project(context_.time(elapsed), x);
  }

private:
  bool interpolate(stepper& s, double elapsed, state& x) {
    const bool found = s.derivative(elapsed, 0, buffer_for(s));
    if (found) std::copy_n(whole_.begin(), x.size(), x.begin());
    if (!found || !numeric::all_finite(x)) context_.fail("the solution could not be interpolated");
    return found && numeric::all_finite(x);
  }

  /// Projects a state onto the constraints, which an interpolated state satisfies only approximately.
  bool project(double t, state& x) {
    if (manifold_ == nullptr) return true;
    if (context_.set_state(t, x) != answer::success) return false;
    if (!manifold_->project(t, x, context_.r(), context_.tolerances_at(x).cwiseInverse())) {
      context_.fail(off_manifold);
      return false;
    }
    x = moved(x, 1, manifold_->correction());
    return true;
  }

  /// Returns a buffer for all entries of an integrator, which may have more entries than the state.
  double* buffer_for(const stepper& s) {
    whole_.resize(static_cast<std::size_t>(s.entries()));
    return whole_.data();
  }

  struct recorded {
    double t;
    state x;
  };

  const settings& options_;
  output_schedule schedule_;
  simulation_context& context_;
  manifold* manifold_;
  std::optional<recorded> last_{};
  bool is_refused_ = false; ///< whether the function each_sample rejected a sample
  std::vector<double> whole_{};
};

} // namespace kanexpr::simulations
