#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/simulate/constraints/manifold.hpp>
#include <kanexpr/simulate/output_schedule.hpp>
#include <kanexpr/simulate/sundials/stepper.hpp>
#include <kanexpr/simulate/motions/simulation_context.hpp>
#include <kanexpr/simulate/motions/tolerances.hpp>

#include <algorithm>
#include <new>
#include <optional>
#include <utility>
#include <vector>

namespace kanexpr::simulated {

/// Takes the samples of a simulation when they are due, and stores them or passes them on. If a sample cannot
/// be taken, the surroundings hold the cause.
class sampling {
public:
  using state = Eigen::VectorXd;

  sampling(const settings& options, const time_span& span, surroundings& around)
      : options_(options), schedule_(span, options.output_every, options.output_times), around_(around),
        manifold_(around.constraints()) {}
  sampling(const sampling&) = delete;
  sampling& operator=(const sampling&) = delete;

  /// Sets the tolerances by which corrections are measured.
  void set(const tolerances& of_entries) { tolerances_ = of_entries; }

  bool takes_each_step() const { return schedule_.takes_each_step(); }

  /// Takes the samples that are due before the first step.
  bool begin(double t, const state& x) {
    if (takes_each_step()) return record(t, x);
    for (; !is_over() && next() <= t; schedule_.pass())
      if (!record(t, x)) return false;
    return true;
  }

  /// Takes the samples that became due during a step, up to a time since the start. If a sample is due at
  /// that time, the state is projected onto the constraints.
  bool go_on(solvers::stepper& s, double elapsed, state& x) {
    const double t = around_.time(elapsed);
    if (takes_each_step()) return record(t, x);
    for (; !is_over() && around_.elapsed(next()) <= elapsed; schedule_.pass()) {
      if (around_.elapsed(next()) < elapsed) {
        state due = x;
        if (!interpolate(s, around_.elapsed(next()), due) || !bring_to_constraints(next(), due) ||
            !record(next(), due))
          return false;
      } else if ((!s.shows_projected() && !bring_to_constraints(t, x)) || !record(t, x)) {
        return false;
      }
    }
    return true;
  }

  bool record(double t, const state& x) {
    if (around_.take(t, x) != answer::given) return false;
    const double* r = around_.r().data();
    try {
      if (options_.keep) around_.system().keep(t, x.data(), r);
    } catch (const std::bad_alloc&) {
      around_.refuse("no memory is left for another sample");
      return false;
    }
    last_ = {t, x};
    is_refused_ = options_.shows_samples && around_.guarded("the function each_sample", [&] {
      around_.system().show(t, x.data(), r);
    }) != answer::given;
    return !is_refused_;
  }

  /// Makes the time and state that were reached the last sample; goes back to the last sample if it was
  /// rejected or no further sample fits.
  void end(double& t, state& x) {
    if (!last_) return;
    const bool is_taken = numeric::equal(last_->t, t) && last_->x == x;
    if (!is_taken && !is_refused_ && last_->t <= t) record(t, x);
    t = last_->t, x = last_->x;
  }

  /// Keeps the polynomial of the last step, from the last event or later up to a time since the start.
  void keep_polynomial(solvers::stepper& s, double elapsed, double last_event) {
    piece p{around_.time((std::max)(s.step_begin(), last_event)), around_.time(elapsed), {}};
    double factorial = 1;
    for (int k = 0; k <= s.degree(); ++k) {
      if (k > 0) factorial *= k;
      if (!s.derivative(elapsed, k, room_for(s))) break;
      for (int i = 0; i < around_.system().states(); ++i)
        p.coefficients.push_back(whole_[static_cast<std::size_t>(i)] / factorial);
    }
    if (!p.coefficients.empty() && p.begin < p.end) around_.system().keep(std::move(p));
  }

  /// Evaluates the state at a time within the last step.
  bool state_at(solvers::stepper& s, double elapsed, state& x) {
    return interpolate(s, elapsed, x) && bring_to_constraints(around_.time(elapsed), x);
  }

private:
  bool is_over() const { return schedule_.is_over(); }
  double next() const { return schedule_.next(); }

  bool interpolate(solvers::stepper& s, double elapsed, state& x) {
    const bool found = s.derivative(elapsed, 0, room_for(s));
    if (found) std::copy_n(whole_.begin(), x.size(), x.begin());
    if (!found || !numeric::all_finite(x)) around_.refuse("the solution could not be interpolated");
    return found && numeric::all_finite(x);
  }

  /// Projects a state onto the constraints, which an interpolated state satisfies only approximately.
  bool bring_to_constraints(double t, state& x) {
    if (manifold_ == nullptr) return true;
    if (around_.take(t, x) != answer::given) return false;
    state weights = tolerances_.at(x);
    for (double& weight : weights) weight = 1 / weight;
    if (!manifold_->project(t, x, around_.r(), weights)) {
      around_.refuse("the constraints are dependent or inconsistent near this state");
      return false;
    }
    x = moved(x, 1, manifold_->correction());
    return true;
  }

  /// Returns storage for all entries of an integrator, which may be more than the state.
  double* room_for(const solvers::stepper& s) {
    whole_.resize(static_cast<std::size_t>(s.entries()));
    return whole_.data();
  }

  struct instant {
    double t;
    state x;
  };

  const settings& options_;
  output_schedule schedule_;
  surroundings& around_;
  manifold* manifold_;
  std::optional<instant> last_{};
  bool is_refused_ = false; ///< by the function each_sample
  tolerances tolerances_{};
  std::vector<double> whole_{};
};

} // namespace kanexpr::simulated
