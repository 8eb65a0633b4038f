#pragma once

#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/angle.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/constraints/manifold.hpp>
#include <kanexpr/simulations/motions/simulation_context.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace kanexpr::simulations {

/// Explores the beginning of a motion by steps of the classic Runge-Kutta method. Each begins at the start
/// and is longer than the one before, as long as the steps are accurate.
class trial_steps {
public:
  using state = Eigen::VectorXd;

  trial_steps(simulation_context& context, double t, const state& x, double span)
      : context_(context), t_(t), start_(x), span_(span) {
    if (span > 0 && context_.find_rates(t, x, rates_)) look_ahead();
  }

  /// Whether the motion has its own time scale: a time, shorter than the span, beyond which a single step no
  /// longer predicts most entries.
  bool has_own_time() const { return has_own_time_ && !trials_.empty(); }

  /// Returns that time, or the span.
  double time() const { return has_own_time() ? trials_.back().ahead : span_; }

  /// Returns the largest magnitudes that the entries reach before the motion has changed.
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
  /// The change over a step from the start; unknown entries are NaN.
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
      long predicted = 0;
      for (Eigen::Index i = 0; i < start_.size(); ++i)
        if (is_predicted(i, one.change(i), fine(i) - rough(i)))
          ++predicted;
        else
          one.change(i) = std::numeric_limits<double>::quiet_NaN();
      most = (std::max)(most, predicted);
      has_own_time_ = 2 * predicted < most;
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
  /// their own magnitude: the median over the entries, so that an entry that begins near zero has no effect.
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

/// The magnitudes of the coordinates and speeds of a motion, in their units, estimated from its beginning:
/// their values there, and the values that they reach in the time in which the motion changes. The magnitude
/// of an angle is at least 1. Any other coordinate that does not move is assigned the largest magnitude of
/// the coordinates that are not angles or, if that is zero, the distance that they would move if the angles
/// were different or, if that is zero too, 1. A speed is not much smaller than the speed that moves its
/// coordinate through its magnitude in that time. The magnitude of a state variable that stays zero is 1.
class state_sizes {
public:
  using state = Eigen::VectorXd;

  state_sizes(simulation_context& context, double t, const state& x, double span)
      : state_sizes(context, t, x, trial_steps(context, t, x, span)) {}
  state_sizes(const state_sizes&) = delete;
  state_sizes& operator=(const state_sizes&) = delete;

  const state& sizes() const { return sizes_; }

private:
  state_sizes(simulation_context& context, double t, const state& x, const trial_steps& ahead)
      : manifold_(context.constraints()), coordinates(context.known().coordinates),
        speeds(context.known().speeds), sizes_(ahead.sizes()), time_(ahead.time()),
        least_share_(ahead.has_own_time() ? 0.1 : 1e-4) {
    fill_coordinates(context, t, x);
    fill_speeds(context, t, x);
    context.clear_error();
  }

  static constexpr double nothing = 1e-12; ///< relative to a magnitude

  /// Returns the rates with the inputs at the first instant, as far as they can be evaluated, and the
  /// residuals of the configuration constraints.
  Eigen::VectorXd functions(const simulation_context& context, double t, const state& x) const {
    const derivation::survey& known = context.known();
    Eigen::VectorXd all(x.size() + known.configuration_constraints);
    context.rates(t, x, all.data());
    if (known.configuration_constraints != 0)
      std::ranges::copy(manifold_->configuration_residual(t, x, context.r()), all.data() + x.size());
    return all;
  }

  void fill_coordinates(const simulation_context& context, double t, const state& x) {
    std::vector<bool> angles;
    double longest = 0;
    for (int j = 0; j < coordinates; ++j) {
      const auto nearby = [&](double by) {
        state moved = x;
        moved(j) += by;
        return functions(context, t, moved);
      };
      angles.push_back(context.known().quaternion_of[j] != 0 || numeric::is_angle(nearby));
      if (!angles.back()) longest = (std::max)(longest, sizes_(j));
    }
    const double displacement = longest_displacement(context, t, x, angles);
    if (!(longest > nothing * displacement)) longest = displacement;
    for (int j = 0; j < coordinates; ++j) {
      const bool is_angle = angles[static_cast<std::size_t>(j)];
      const double usual = is_angle || !(longest > 0) ? 1 : longest;
      if (is_angle || !(sizes_(j) > nothing * usual)) sizes_(j) = (std::max)(sizes_(j), usual);
    }
  }

  /// Returns how far coordinates that are not angles would move if the angles were different.
  double longest_displacement(const simulation_context& context, double t, const state& x,
                              const std::vector<bool>& angles) const {
    state turned = x, moving = x;
    for (int j = 0; j < coordinates; ++j)
      if (angles[static_cast<std::size_t>(j)]) turned(j) += 1;
    const Eigen::VectorXd pushed = functions(context, t, turned);
    for (int k = coordinates; k < coordinates + speeds; ++k) moving(k) = pushed(k) * time_ / 2;
    const Eigen::VectorXd rates = functions(context, t, moving);
    double longest = 0;
    for (int j = 0; j < coordinates; ++j)
      if (!angles[static_cast<std::size_t>(j)] && numeric::is_finite(rates(j)))
        longest = (std::max)(longest, std::abs(rates(j)) * time_);
    return longest;
  }

  /// The rates of coordinates are linear in the speeds. An error in a speed does not matter if it moves each
  /// coordinate by less than the error in that coordinate.
  void fill_speeds(const simulation_context& context, double t, const state& x) {
    state alone = x;
    std::fill_n(alone.data() + coordinates, speeds, 0.0);
    const Eigen::VectorXd at_rest = functions(context, t, alone);
    for (int k = coordinates; k < context.known().first_state_variable(); ++k) {
      alone(k) = 1;
      const Eigen::VectorXd change = moved(functions(context, t, alone), -1, at_rest);
      alone(k) = 0;
      double usual = 0;
      for (int j = 0; j < coordinates; ++j) {
        const double found = sizes_(j) / std::abs(change(j)) / time_;
        if (found > 0 && numeric::is_finite(found)) usual = usual > 0 ? (std::min)(usual, found) : found;
      }
      if (!(usual > 0)) usual = 1;
      if (!(sizes_(k) > nothing * usual)) sizes_(k) = usual;
      sizes_(k) = (std::max)(sizes_(k), least_share_ * usual);
    }
    for (int k = context.known().first_state_variable(); k < x.size(); ++k)
      if (!(sizes_(k) > 0)) sizes_(k) = 1;
  }

  manifold* manifold_;
  int coordinates, speeds;
  state sizes_;
  double time_;        ///< the time in which the motion changes
  double least_share_; ///< the least magnitude of a speed, as a fraction of the speed that moves a coordinate
                       ///< through its magnitude in that time
};

} // namespace kanexpr::simulations
