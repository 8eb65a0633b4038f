#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulate/motions/rates_at.hpp>
#include <kanexpr/simulate/motions/tolerances.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace kanexpr::simulated {

/// Watched functions that are zero where an integration begins, at the start or after a handler. Integrators
/// detect only changes of sign, so they miss these.
class departures {
public:
  using state = Eigen::VectorXd;

  explicit departures(surroundings& around) : around_(around) {}

  void set(const tolerances& of_entries) { tolerances_ = of_entries; }

  /// Finds the functions that pass zero at the start: those that are zero there, within the tolerances, and
  /// leave zero in the direction of their event. An event of either direction must be seen on both sides of
  /// zero. Returns false if a function cannot be evaluated.
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
    if (!none(waiting_)) look_ahead(t, x, farthest, passed);
    around_.forget();
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
  void look_ahead_by(double step) { least_ahead_ = 1e-3 * step; }

  /// Whether a function passes zero against the sign of its rate.
  bool contradict(double t, const state& x, const std::vector<int>& passed) {
    const std::vector<double> slopes = slopes_at(t, x);
    for (std::size_t i = 0; i < passed.size(); ++i)
      if (slopes[i] * passed[i] < 0) return true;
    return false;
  }

  /// Returns the index of a function that was found to pass zero but stays there, since small changes of its
  /// arguments do not change it; −1 if there is none.
  int resting(double t, const state& x, const std::vector<int>& passed) {
    if (!evaluate(t, x, here_)) return -1;
    for (std::size_t i = 0; i < passed.size(); ++i) {
      if (passed[i] == 0 || !numeric::equal(here_[i], 0.0)) continue;
      find_margins(t, x);
      if (numeric::equal(margins_[i], 0.0)) return static_cast<int>(i);
    }
    return -1;
  }

  /// Whether a function that has passed zero was exactly zero where `resting` evaluated it.
  bool is_zero(const std::vector<int>& passed) const {
    for (std::size_t i = 0; i < passed.size(); ++i)
      if (passed[i] != 0 && numeric::equal(here_[i], 0.0)) return true;
    return false;
  }

  /// Records the functions that have just passed zero, after handlers that left the state `x`: a function
  /// that they reversed or brought to rest is expected to return; one that continues may not have reached
  /// zero yet.
  void note(double t, const state& before, const state& x, const std::vector<int>& passed) {
    const std::vector<double> slopes_before = slopes_at(t, before), slopes = slopes_at(t, x);
    returning_.assign(count(), 0), completing_.assign(count(), 0);
    for (std::size_t i = 0; i < count(); ++i) {
      if (passed[i] == 0) continue;
      const bool goes_back = slopes[i] * passed[i] <= 1e-6 * std::abs(slopes_before[i]);
      if (goes_back && around_.events()[i].has_handler) returning_[i] = -passed[i];
      if (!goes_back && here_[i] * passed[i] <= 0) completing_[i] = passed[i];
    }
    if (none(returning_) && none(completing_) && none(waiting_)) return;
    find_margins(t, x);
    for (std::size_t i = 0; i < count(); ++i)
      if (std::abs(here_[i]) > margins_[i]) waiting_[i] = returning_[i] = completing_[i] = 0;
  }

  /// After a step: removes from `passed` the functions whose passage was already handled, and returns whether
  /// a function that was expected to return is beyond zero without having been seen to pass it.
  bool missed(double t, const state& x, std::vector<int>& passed) {
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
  std::size_t count() const { return around_.events().size(); }
  int direction(std::size_t i) const { return around_.direction(static_cast<int>(i)); }
  static bool none(const std::vector<int>& of) {
    return std::ranges::all_of(of, [](int each) { return each == 0; });
  }

  bool evaluate(double t, const state& x, std::vector<double>& values) {
    values.resize(count());
    return around_.watch(t, x.data(), values.data()) == answer::given;
  }

  /// Finds by how much each function changes when the entries of the state change by their tolerances, and
  /// the time by rounding.
  void find_margins(double t, const state& x) {
    margins_.assign(count(), 0);
    const state units = tolerances_.at(x);
    const auto add = [&](double at, const state& beside) {
      if (evaluate(at, beside, later_))
        for (std::size_t i = 0; i < count(); ++i) margins_[i] += std::abs(later_[i] - here_[i]);
    };
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      state beside = x;
      beside(j) += units(j);
      add(t, beside);
    }
    add(t * (1 + 4 * std::numeric_limits<double>::epsilon()), x);
    around_.forget();
  }
  bool is_clear(std::size_t i, double moved) const { return std::abs(moved) > 1e-3 * margins_[i]; }

  bool rates(double t, const state& x, state& out) { return rates_at(around_, t, x, out); }

  /// Extrapolates farther and farther until it is clear to which side each function at zero moves.
  void look_ahead(double t, const state& x, double farthest, std::vector<int>& passed) {
    const state units = tolerances_.at(x);
    state slope, rough, fine;
    if (!rates(t, x, slope)) return;
    for (double ahead = 1e-3 / fastest(x, slope); ahead <= farthest && !none(waiting_); ahead *= 2) {
      if (!advance(t, x, ahead, rough, fine)) return;
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

  /// Takes a step with the midpoint rule and one with the classic Runge-Kutta method.
  bool advance(double t, const state& x, double h, state& rough, state& fine) {
    state k1, k2, k3, k4;
    if (!rates(t, x, k1) || !rates(t + h / 2, moved(x, h / 2, k1), k2) ||
        !rates(t + h / 2, moved(x, h / 2, k2), k3) || !rates(t + h, moved(x, h, k3), k4))
      return false;
    rough = moved(x, h, k2);
    fine = moved(x, h, k1, k2, k3, k4);
    return true;
  }

  /// Returns the rate of each function; NaN if it cannot be evaluated.
  std::vector<double> slopes_at(double t, const state& x) {
    std::vector<double> slopes(count(), std::numeric_limits<double>::quiet_NaN());
    state now;
    if (evaluate(t, x, here_) && rates(t, x, now)) {
      const double seen =
          16 * std::numeric_limits<double>::epsilon() * std::abs(t); // the rounding of the time itself
      const double ahead = (std::max)({least_ahead_, 1 / fastest(x, now), seen});
      if (numeric::is_finite(ahead) && evaluate(t + ahead, moved(x, ahead, now), later_))
        for (std::size_t i = 0; i < count(); ++i) slopes[i] = (later_[i] - here_[i]) / ahead;
    }
    around_.forget();
    return slopes;
  }

  /// Returns the largest rate in units of the tolerances.
  double fastest(const state& x, const state& rates) const { return largest(rates, tolerances_.at(x)); }

  surroundings& around_;
  tolerances tolerances_{};
  double least_ahead_ = 0;
  std::vector<int> waiting_{};                  ///< the direction in which each must leave zero
  std::vector<int> returning_{}, completing_{}; ///< the direction in which each is expected to pass
  std::vector<double> here_{}, later_{}, margins_{};
};

} // namespace kanexpr::simulated
