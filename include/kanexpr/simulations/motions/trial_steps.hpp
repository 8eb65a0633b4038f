#pragma once

#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/motions/runge_kutta_step.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace kanexpr::simulations {

/// Explores the beginning of a motion by steps of the classic Runge-Kutta method from the start, each longer
/// than the one before, as long as they can be trusted.
class trial_steps {
public:
  using state = Eigen::VectorXd;

  trial_steps(simulation_context& context, double t, const state& x, double span)
      : context_(context), t_(t), start_(x), span_(span) {
    if (span > 0 && context_.find_rates(t, x, rates_)) look_ahead();
  }

  /// Whether the motion has its own time scale: a time within the span after which one step no longer
  /// predicts most entries.
  bool has_own_time() const { return has_own_time_ && !trials_.empty(); }

  /// Returns that time, or the span.
  double time() const { return has_own_time() ? trials_.back().ahead : span_; }

  /// Returns how large the entries become until the motion has changed.
  state sizes() const {
    state found = start_;
    for (double& size : found) size = std::abs(size);
    const double time = time_of_change();
    for (const trial_step& o : trials_)
      for (Eigen::Index i = 0; i < found.size(); ++i)
        if (o.ahead <= time && numeric::is_finite(o.change(i)))
          found(i) = (std::max)({found(i), std::abs(o.change(i)), std::abs(start_(i) + o.change(i))});
    return found;
  }

private:
  /// The change over a step from the start; NaN where it is unknown.
  struct trial_step {
    double ahead;
    state change;
  };

  /// Takes longer and longer steps until most entries differ from the result of two steps of half the length.
  void look_ahead() {
    long most = 0;
    state rough, half, fine;
    for (double ahead = 0x1p-30 * span_; ahead <= span_; ahead *= 4) {
      if (!step(t_, start_, rates_, ahead, rough) || !step(t_, start_, rates_, ahead / 2, half)) return;
      state there;
      if (!context_.find_rates(t_ + ahead / 2, half, there)) return;
      if (!step(t_ + ahead / 2, half, there, ahead / 2, fine)) return;
      trial_step one{ahead, moved(fine, -1, start_)};
      long told = 0;
      for (Eigen::Index i = 0; i < start_.size(); ++i)
        if (is_predicted(i, one.change(i), fine(i) - rough(i)))
          ++told;
        else
          one.change(i) = std::numeric_limits<double>::quiet_NaN();
      most = (std::max)(most, told);
      has_own_time_ = 2 * told < most;
      if (has_own_time_) return;
      trials_.push_back(one);
    }
  }

  /// Whether a change exceeds rounding and the error of a step.
  bool is_predicted(Eigen::Index i, double change, double error) const {
    const double rounding = 1e3 * std::numeric_limits<double>::epsilon() * std::abs(start_(i));
    return std::abs(change) > rounding && std::abs(error) <= 0.1 * std::abs(change);
  }

  bool step(double t, const state& x, const state& k1, double h, state& end) {
    state midpoint;
    if (!runge_kutta_step(context_, t, x, k1, h, midpoint, end)) return false;
    return numeric::all_finite(end);
  }

  /// Returns, for a motion without its own time scale, such as a fall, the time in which entries change by
  /// their own magnitude: the median over the entries, so that one that begins near zero does not matter.
  double time_of_change() const {
    const double all = std::numeric_limits<double>::infinity();
    if (has_own_time_) return all;
    std::vector<double> times;
    for (Eigen::Index i = 0; i < start_.size(); ++i) {
      double farthest = 0;
      for (const trial_step& o : trials_)
        if (std::abs(o.change(i)) > farthest) farthest = std::abs(o.change(i));
      if (std::abs(start_(i)) <= std::numeric_limits<double>::epsilon() * farthest)
        continue; // effectively zero
      const auto changed = std::ranges::find_if(
          trials_, [&](const trial_step& o) { return std::abs(o.change(i)) >= std::abs(start_(i)); });
      times.push_back(changed != trials_.end() ? changed->ahead : all);
    }
    if (times.empty()) return all;
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::ranges::nth_element(times, middle);
    return *middle;
  }

  simulation_context& context_;
  double t_;
  state start_, rates_{};
  double span_;
  std::vector<trial_step> trials_{};
  bool has_own_time_ = false;
};

} // namespace kanexpr::simulations
