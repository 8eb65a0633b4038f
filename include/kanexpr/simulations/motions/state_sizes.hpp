#pragma once

#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/numeric/angle.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/constraints/manifold.hpp>
#include <kanexpr/simulations/motions/trial_steps.hpp>
#include <kanexpr/steps/assemble.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace kanexpr::simulations {

/// The magnitudes of the coordinates and speeds of a motion, in their units, estimated from its beginning:
/// their values there, and the values that they reach in the time in which the motion changes. An angle is at
/// least 1. Any other coordinate that does not move is as large as the largest of these, or as the distance
/// that it would move if the angles were different, or 1; a speed is not much smaller than the speed that
/// moves its coordinate through its magnitude in that time.
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
    const double way = longest_way(context, t, x, angles);
    if (!(longest > nothing * way)) longest = way;
    for (int j = 0; j < coordinates; ++j) {
      const bool is_angle = angles[static_cast<std::size_t>(j)];
      const double usual = is_angle || !(longest > 0) ? 1 : longest;
      if (is_angle || !(sizes_(j) > nothing * usual)) sizes_(j) = (std::max)(sizes_(j), usual);
    }
  }

  /// Returns how far coordinates that are not angles would move if the angles were different.
  double longest_way(const simulation_context& context, double t, const state& x,
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

  /// The rates of coordinates are linear in the speeds. Errors of a speed that move each coordinate by less
  /// than its own error do not matter.
  void fill_speeds(const simulation_context& context, double t, const state& x) {
    state alone = x;
    std::fill_n(alone.data() + coordinates, speeds, 0.0);
    const Eigen::VectorXd at_rest = functions(context, t, alone);
    for (int k = coordinates; k < coordinates + speeds; ++k) {
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
  }

  manifold* manifold_;
  int coordinates, speeds;
  state sizes_;
  double time_;        ///< the time in which the motion changes
  double least_share_; ///< the least magnitude of a speed, as a fraction of the speed that moves a coordinate
                       ///< through its magnitude in that time
};

} // namespace kanexpr::simulations
