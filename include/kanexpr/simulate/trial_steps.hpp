#pragma once

#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulate/rates_at.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace kanexpr::simulated {

/// What becomes of a motion at its beginning: steps of the classic Runge-Kutta method from the start, each
/// longer than the one before, as far as they can be trusted.
class trial_steps {
public:
  using state = Eigen::VectorXd;

  trial_steps(surroundings& around, double t, const state& x, double span)
      : around_(around), t_(t), start_(x), span_(span) {
    if (span > 0 && rates_at(around_, t, x, rates_)) look_ahead();
  }

  /// Until most entries are no longer what a step says of them, if that comes before the end of the span.
  bool has_own_time() const { return has_own_time_ && !seen_.empty(); }

  /// That time, or the span.
  double time() const { return has_own_time() ? seen_.back().ahead : span_; }

  /// How large the entries become until the motion has changed.
  state sizes() const {
    state found = start_;
    for (double& size : found) size = std::abs(size);
    const double time = time_of_change();
    for (const outlook& o : seen_)
      for (Eigen::Index i = 0; i < found.size(); ++i)
        if (o.ahead <= time && numeric::is_finite(o.change(i)))
          found(i) = (std::max)({found(i), std::abs(o.change(i)), std::abs(start_(i) + o.change(i))});
    return found;
  }

private:
  /// What a step from the start changes; not a number where it cannot be found.
  struct outlook {
    double ahead;
    state change;
  };

  /// Until most entries differ from what two steps of half the length give.
  void look_ahead() {
    long most = 0;
    state rough, half, fine;
    for (double ahead = 0x1p-30 * span_; ahead <= span_; ahead *= 4) {
      if (!step(t_, start_, rates_, ahead, rough) || !step(t_, start_, rates_, ahead / 2, half)) return;
      state there;
      if (!rates_at(around_, t_ + ahead / 2, half, there)) return;
      if (!step(t_ + ahead / 2, half, there, ahead / 2, fine)) return;
      outlook one{ahead, moved(fine, -1, start_)};
      long told = 0;
      for (Eigen::Index i = 0; i < start_.size(); ++i)
        if (is_told(i, one.change(i), fine(i) - rough(i)))
          ++told;
        else
          one.change(i) = std::numeric_limits<double>::quiet_NaN();
      most = (std::max)(most, told);
      has_own_time_ = 2 * told < most;
      if (has_own_time_) return;
      seen_.push_back(one);
    }
  }

  /// Whether a change is more than rounding and the error of a step.
  bool is_told(Eigen::Index i, double change, double error) const {
    const double rounding = 1e3 * std::numeric_limits<double>::epsilon() * std::abs(start_(i));
    return std::abs(change) > rounding && std::abs(error) <= 0.1 * std::abs(change);
  }

  bool step(double t, const state& x, const state& k1, double h, state& end) {
    state k2, k3, k4;
    if (!rates_at(around_, t + h / 2, moved(x, h / 2, k1), k2) ||
        !rates_at(around_, t + h / 2, moved(x, h / 2, k2), k3) ||
        !rates_at(around_, t + h, moved(x, h, k3), k4))
      return false;
    end = moved(x, h, k1, k2, k3, k4);
    return numeric::all_finite(end);
  }

  /// A motion without a time of its own, as a fall, is looked at until entries have changed by their own
  /// size: the median of these times, so that one which begins next to zero does not matter.
  double time_of_change() const {
    const double all = std::numeric_limits<double>::infinity();
    if (has_own_time_) return all;
    std::vector<double> times;
    for (Eigen::Index i = 0; i < start_.size(); ++i) {
      double farthest = 0;
      for (const outlook& o : seen_)
        if (std::abs(o.change(i)) > farthest) farthest = std::abs(o.change(i));
      if (std::abs(start_(i)) <= std::numeric_limits<double>::epsilon() * farthest) continue; // it is zero
      const auto changed = std::ranges::find_if(
          seen_, [&](const outlook& o) { return std::abs(o.change(i)) >= std::abs(start_(i)); });
      times.push_back(changed != seen_.end() ? changed->ahead : all);
    }
    if (times.empty()) return all;
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::ranges::nth_element(times, middle);
    return *middle;
  }

  surroundings& around_;
  double t_;
  state start_, rates_{};
  double span_;
  std::vector<outlook> seen_{};
  bool has_own_time_ = false;
};

} // namespace kanexpr::simulated
