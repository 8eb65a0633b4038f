#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulate/rates_at.hpp>
#include <kanexpr/simulate/tolerances.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace kanexpr::simulated {

/// Watched functions that are zero where an integration begins, at the start or after a handler. Integrators
/// look for changes of sign, so that they take no notice of those.
class departures {
public:
  using state = Eigen::VectorXd;

  explicit departures(surroundings& around) : around_(around) {}

  void set(const tolerances& of_entries) { tolerances_ = of_entries; }

  /// Finds the functions that pass zero at the start: those that are zero there, as far as the tolerances
  /// tell, and leave it in the direction of their event. An event of either direction must be seen on both
  /// sides. False where functions have no value.
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

  /// After a step: functions that were zero since the start and have left it meanwhile in the direction of
  /// their event.
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

  /// Whether one of the functions that `left` found is beyond zero.
  bool is_beyond(double t, const state& x, const std::vector<int>& left) {
    if (!evaluate(t, x, later_)) return false;
    for (std::size_t i = 0; i < left.size(); ++i)
      if (left[i] * later_[i] > 0) return true;
    return false;
  }

  /// How far ahead the rates of functions are looked at: a small part of a step.
  void look_ahead_by(double step) { least_ahead_ = 1e-3 * step; }

  /// Whether functions pass zero against their rates.
  bool contradict(double t, const state& x, const std::vector<int>& passed) {
    const std::vector<double> slopes = slopes_at(t, x);
    for (std::size_t i = 0; i < passed.size(); ++i)
      if (slopes[i] * passed[i] < 0) return true;
    return false;
  }

  /// Which function that was found to pass zero does not: it is zero, whatever changes a little. −1: none.
  int resting(double t, const state& x, const std::vector<int>& passed) {
    if (!evaluate(t, x, here_)) return -1;
    for (std::size_t i = 0; i < passed.size(); ++i) {
      if (passed[i] == 0 || !numeric::equal(here_[i], 0.0)) continue;
      find_margins(t, x);
      if (numeric::equal(margins_[i], 0.0)) return static_cast<int>(i);
    }
    return -1;
  }

  /// Whether a function that has passed zero was found at zero itself, where `resting` looked.
  bool is_zero(const std::vector<int>& passed) const {
    for (std::size_t i = 0; i < passed.size(); ++i)
      if (passed[i] != 0 && numeric::equal(here_[i], 0.0)) return true;
    return false;
  }

  /// Notes what is to come of functions that have just passed zero, after handlers that left the state `x`:
  /// one that they turned round, or brought to rest, is to return; one that goes on may still be before zero.
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

  /// After a step: takes from `passed` what was passed before; and tells whether a function that was to
  /// return is found beyond zero, and was not seen to pass it.
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

  /// How much each function changes where the entries of the state, and the time, change by as little as
  /// cannot be seen.
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

  /// Looks farther and farther ahead until it is seen to which side the functions go that are zero.
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

  /// Goes a step by the midpoint rule and by the classic Runge-Kutta method.
  bool advance(double t, const state& x, double h, state& rough, state& fine) {
    state k1, k2, k3, k4;
    if (!rates(t, x, k1) || !rates(t + h / 2, moved(x, h / 2, k1), k2) ||
        !rates(t + h / 2, moved(x, h / 2, k2), k3) || !rates(t + h, moved(x, h, k3), k4))
      return false;
    rough = moved(x, h, k2);
    fine = moved(x, h, k1, k2, k3, k4);
    return true;
  }

  /// The rate of each function; not a number where it cannot be found.
  std::vector<double> slopes_at(double t, const state& x) {
    std::vector<double> slopes(count(), std::numeric_limits<double>::quiet_NaN());
    state now;
    if (evaluate(t, x, here_) && rates(t, x, now)) {
      const double seen = 16 * std::numeric_limits<double>::epsilon() * std::abs(t); // of the time itself
      const double ahead = (std::max)({least_ahead_, 1 / fastest(x, now), seen});
      if (numeric::is_finite(ahead) && evaluate(t + ahead, moved(x, ahead, now), later_))
        for (std::size_t i = 0; i < count(); ++i) slopes[i] = (later_[i] - here_[i]) / ahead;
    }
    around_.forget();
    return slopes;
  }

  /// Of rates, beside the tolerances.
  double fastest(const state& x, const state& rates) const { return largest(rates, tolerances_.at(x)); }

  surroundings& around_;
  tolerances tolerances_{};
  double least_ahead_ = 0;
  std::vector<int> waiting_{};                  ///< to leave zero in a direction
  std::vector<int> returning_{}, completing_{}; ///< to a side, in a direction
  std::vector<double> here_{}, later_{}, margins_{};
};

} // namespace kanexpr::simulated
