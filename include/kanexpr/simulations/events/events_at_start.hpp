#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/motions/simulation_context.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace kanexpr::simulations {

/// Watched functions that are zero when an integration begins, at the start or after a handler. Integrators
/// detect only changes of sign, so they miss these.
class events_at_start {
public:
  using state = Eigen::VectorXd;

  explicit events_at_start(simulation_context& context) : context_(context) {}

  /// Finds the functions that cross zero at the start: those that are zero there, within the tolerances, and
  /// leave zero in the direction of their event. An event of either direction requires values on both sides
  /// of zero. Returns false if a function cannot be evaluated.
  bool begin(double t, const state& x, double span, std::vector<int>& passed) {
    passed.assign(count(), 0);
    waiting_ = returning_ = completing_ = passed;
    if (count() == 0) return true;
    if (!evaluate(t, x, here_)) return false;
    for (std::size_t i = 0; i < count(); ++i) waiting_[i] = direction(i) * here_[i] >= 0 ? direction(i) : 0;
    if (!none(waiting_)) find_margins(t, x);
    for (std::size_t i = 0; i < count(); ++i)
      if (waiting_[i] != 0 && std::abs(here_[i]) > margins_[i]) waiting_[i] = 0;
    const double farthest = span > 0 ? 1e-3 * span : (std::numeric_limits<double>::max)();
    if (!none(waiting_)) extrapolate(t, x, farthest, passed);
    context_.clear_error();
    return true;
  }

  /// Returns, after a step, the functions that have been zero since the start and have now left zero in the
  /// direction of their event.
  std::vector<int> left(double t, const state& x, const std::vector<int>& passed) {
    std::vector<int> found(count());
    if (none(waiting_) || !evaluate(t, x, later_)) return found;
    for (std::size_t i = 0; i < count(); ++i) {
      const double moved = later_[i] - here_[i];
      if (waiting_[i] == 0 || (passed[i] == 0 && !is_clear(i, moved))) continue;
      if (passed[i] == 0 && waiting_[i] * later_[i] > 0 && waiting_[i] * moved > 0) found[i] = waiting_[i];
      waiting_[i] = 0;
    }
    return found;
  }

  /// Whether one of the functions returned by `left` is beyond zero.
  bool is_beyond(double t, const state& x, const std::vector<int>& left) {
    if (!evaluate(t, x, later_)) return false;
    for (std::size_t i = 0; i < left.size(); ++i)
      if (left[i] * later_[i] > 0) return true;
    return false;
  }

  /// Sets how far ahead the rates of the functions are evaluated: a small fraction of a step.
  void set_look_ahead(double step) { least_ahead_ = 1e-3 * step; }

  /// Whether a function crosses zero against the sign of its rate.
  bool contradict(double t, const state& x, const std::vector<int>& passed) {
    const std::vector<double> slopes = slopes_at(t, x);
    for (std::size_t i = 0; i < passed.size(); ++i)
      if (slopes[i] * passed[i] < 0) return true;
    return false;
  }

  /// Returns the index of a function that was found to cross zero but stays there, since small changes of its
  /// arguments do not change it; −1 if there is none.
  int stationary_event(double t, const state& x, const std::vector<int>& passed) {
    if (!evaluate(t, x, here_)) return -1;
    for (std::size_t i = 0; i < passed.size(); ++i) {
      if (passed[i] == 0 || !base::equal(here_[i], 0.0)) continue;
      find_margins(t, x);
      if (base::equal(margins_[i], 0.0)) return static_cast<int>(i);
    }
    return -1;
  }

  /// Whether a function that has crossed zero was exactly zero when `stationary_event` evaluated it.
  bool is_zero(const std::vector<int>& passed) const {
    for (std::size_t i = 0; i < passed.size(); ++i)
      if (passed[i] != 0 && base::equal(here_[i], 0.0)) return true;
    return false;
  }

  /// Records the functions that have just crossed zero, after handlers that set the state to `x`: a function
  /// that they reversed or stopped will cross back; one that continues may not have reached zero yet.
  void record_passed(double t, const state& before, const state& x, const std::vector<int>& passed) {
    const std::vector<double> slopes_before = slopes_at(t, before), slopes = slopes_at(t, x);
    returning_.assign(count(), 0), completing_.assign(count(), 0);
    for (std::size_t i = 0; i < count(); ++i) {
      if (passed[i] == 0) continue;
      const bool goes_back = slopes[i] * passed[i] <= 1e-6 * std::abs(slopes_before[i]);
      if (goes_back && context_.events()[i].has_handler) returning_[i] = -passed[i];
      if (!goes_back && here_[i] * passed[i] <= 0) completing_[i] = passed[i];
    }
    if (none(returning_) && none(completing_) && none(waiting_)) return;
    find_margins(t, x);
    for (std::size_t i = 0; i < count(); ++i)
      if (std::abs(here_[i]) > margins_[i]) waiting_[i] = returning_[i] = completing_[i] = 0;
  }

  /// After a step: removes from `passed` the functions whose passage was already handled, and returns whether
  /// a function that was expected to return is beyond zero, although no crossing was detected.
  bool has_missed_return(double t, const state& x, std::vector<int>& passed) {
    if (none(returning_) && none(completing_)) return false;
    if (!evaluate(t, x, later_)) return false;
    for (std::size_t i = 0; i < count(); ++i) {
      const double moved = later_[i] - here_[i];
      if (completing_[i] != 0 && passed[i] == completing_[i]) passed[i] = completing_[i] = 0;
      if (is_clear(i, moved)) completing_[i] = 0;
      if (returning_[i] == 0) continue;
      if (passed[i] != 0 || (returning_[i] * later_[i] > 0 && is_clear(i, moved)))
        returning_[i] = 0;
      else if (returning_[i] * later_[i] < 0 && returning_[i] * moved < 0 && is_clear(i, moved))
        return true;
    }
    return false;
  }

private:
  std::size_t count() const { return context_.events().size(); }
  int direction(std::size_t i) const { return context_.direction(static_cast<int>(i)); }
  static bool none(const std::vector<int>& of) {
    return std::ranges::all_of(of, [](int each) { return each == 0; });
  }

  bool evaluate(double t, const state& x, std::vector<double>& values) {
    values.resize(count());
    return context_.evaluate_events(t, x.data(), values.data()) == answer::success;
  }

  /// Finds by how much each function changes when the entries of the state change by their tolerances, and
  /// the time by rounding.
  void find_margins(double t, const state& x) {
    margins_.assign(count(), 0);
    const state units = context_.tolerances_at(x);
    const auto add = [&](double at, const state& nearby) {
      if (evaluate(at, nearby, later_))
        for (std::size_t i = 0; i < count(); ++i) margins_[i] += std::abs(later_[i] - here_[i]);
    };
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      state nearby = x;
      nearby(j) += units(j);
      add(t, nearby);
    }
    add(t * (1 + 4 * std::numeric_limits<double>::epsilon()), x);
    context_.clear_error();
  }
  bool is_clear(std::size_t i, double moved) const { return std::abs(moved) > 1e-3 * margins_[i]; }

  /// Extrapolates farther and farther until it is clear to which side of zero each function moves.
  void extrapolate(double t, const state& x, double farthest, std::vector<int>& passed) {
    const state units = context_.tolerances_at(x);
    state slope, rough, fine;
    if (!context_.find_rates(t, x, slope)) return;
    for (double ahead = 1e-3 / fastest(x, slope); ahead <= farthest && !none(waiting_); ahead *= 2) {
      if (!runge_kutta_step(context_, t, x, slope, ahead, rough, fine)) return;
      if (largest(moved(fine, -1, x), units) > 1e6) return;
      if (!evaluate(t + ahead, rough, later_)) return;
      const std::vector<double> roughly = later_;
      if (!evaluate(t + ahead, fine, later_)) return;
      for (std::size_t i = 0; i < count(); ++i) {
        const double moved = later_[i] - here_[i], error = roughly[i] - later_[i];
        if (waiting_[i] == 0 || !is_clear(i, moved) || std::abs(error) > std::abs(moved) / 2) continue;
        if (waiting_[i] * moved > 0) passed[i] = waiting_[i];
        waiting_[i] = 0;
      }
    }
  }

  /// Returns the rate of each function; NaN if it cannot be evaluated.
  std::vector<double> slopes_at(double t, const state& x) {
    std::vector<double> slopes(count(), std::numeric_limits<double>::quiet_NaN());
    state now;
    if (evaluate(t, x, here_) && context_.find_rates(t, x, now)) {
      const double seen =
          16 * std::numeric_limits<double>::epsilon() * std::abs(t); // the rounding error of the time itself
      const double ahead = (std::max)({least_ahead_, 1 / fastest(x, now), seen});
      if (numeric::is_finite(ahead) && evaluate(t + ahead, moved(x, ahead, now), later_))
        for (std::size_t i = 0; i < count(); ++i) slopes[i] = (later_[i] - here_[i]) / ahead;
    }
    context_.clear_error();
    return slopes;
  }

  /// Returns the largest rate in units of the tolerances.
  double fastest(const state& x, const state& rates) const {
    return largest(rates, context_.tolerances_at(x));
  }

  simulation_context& context_;
  double least_ahead_ = 0;
  std::vector<int> waiting_{};                  ///< the direction in which each must leave zero
  std::vector<int> returning_{}, completing_{}; ///< the direction in which each is expected to cross zero
  std::vector<double> here_{}, later_{}, margins_{};
};

} // namespace kanexpr::simulations
