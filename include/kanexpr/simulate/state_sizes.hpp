#pragma once

#include <kanexpr/numeric/angle.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulate/manifold.hpp>
#include <kanexpr/simulate/trial_steps.hpp>
#include <kanexpr/steps/assemble.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace kanexpr::simulated {

/// How large the coordinates and speeds of a motion are, in whatever units, as far as its beginning tells:
/// their values there, and what they become in the time in which the motion changes. An angle is at least 1.
/// Another coordinate that does not move at all is as large as the largest of these, or as what would move
/// them if the angles stood otherwise, or 1; a speed takes its coordinate through its size in that time, and
/// is not much smaller.
class state_sizes {
public:
  using state = Eigen::VectorXd;

  state_sizes(surroundings& around, double t, const state& x, double span)
      : state_sizes(around, t, x, trial_steps(around, t, x, span)) {}
  state_sizes(const state_sizes&) = delete;
  state_sizes& operator=(const state_sizes&) = delete;

  const state& sizes() const { return sizes_; }

private:
  state_sizes(surroundings& around, double t, const state& x, const trial_steps& ahead)
      : manifold_(around.constraints()), coordinates(around.known().coordinates),
        speeds(around.known().speeds), sizes_(ahead.sizes()), time_(ahead.time()),
        least_share_(ahead.has_own_time() ? 0.1 : 1e-4) {
    fill_coordinates(around, t, x);
    fill_speeds(around, t, x);
    around.forget();
  }

  static constexpr double nothing = 1e-12; ///< beside a size

  /// The rates with the inputs of the first instant, where they can be had, and what the configuration
  /// constraints leave.
  Eigen::VectorXd functions(const surroundings& around, double t, const state& x) const {
    const deriving::survey& known = around.known();
    Eigen::VectorXd all(x.size() + known.configuration_constraints);
    around.rates(t, x, all.data());
    if (known.configuration_constraints != 0)
      std::ranges::copy(manifold_->configuration_residual(t, x, around.r()), all.data() + x.size());
    return all;
  }

  void fill_coordinates(const surroundings& around, double t, const state& x) {
    std::vector<bool> angles;
    double longest = 0;
    for (int j = 0; j < coordinates; ++j) {
      const auto beside = [&](double by) {
        state moved = x;
        moved(j) += by;
        return functions(around, t, moved);
      };
      angles.push_back(around.known().quaternion_of[j] != 0 || numeric::is_angle(beside));
      if (!angles.back()) longest = (std::max)(longest, sizes_(j));
    }
    const double way = longest_way(around, t, x, angles);
    if (!(longest > nothing * way)) longest = way;
    for (int j = 0; j < coordinates; ++j) {
      const bool is_angle = angles[static_cast<std::size_t>(j)];
      const double usual = is_angle || !(longest > 0) ? 1 : longest;
      if (is_angle || !(sizes_(j) > nothing * usual)) sizes_(j) = (std::max)(sizes_(j), usual);
    }
  }

  /// How far coordinates that are no angles would go if the angles stood otherwise.
  double longest_way(const surroundings& around, double t, const state& x,
                     const std::vector<bool>& angles) const {
    state turned = x, moving = x;
    for (int j = 0; j < coordinates; ++j)
      if (angles[static_cast<std::size_t>(j)]) turned(j) += 1;
    const Eigen::VectorXd pushed = functions(around, t, turned);
    for (int k = coordinates; k < coordinates + speeds; ++k) moving(k) = pushed(k) * time_ / 2;
    const Eigen::VectorXd rates = functions(around, t, moving);
    double longest = 0;
    for (int j = 0; j < coordinates; ++j)
      if (!angles[static_cast<std::size_t>(j)] && numeric::is_finite(rates(j)))
        longest = (std::max)(longest, std::abs(rates(j)) * time_);
    return longest;
  }

  /// The rates of coordinates are linear in the speeds. Errors of a speed do not matter that move each
  /// coordinate by less than its own error.
  void fill_speeds(const surroundings& around, double t, const state& x) {
    state alone = x;
    std::fill_n(alone.data() + coordinates, speeds, 0.0);
    const Eigen::VectorXd at_rest = functions(around, t, alone);
    for (int k = coordinates; k < coordinates + speeds; ++k) {
      alone(k) = 1;
      const Eigen::VectorXd change = moved(functions(around, t, alone), -1, at_rest);
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
  double time_;        ///< in which the motion changes
  double least_share_; ///< of what takes a coordinate through its size in that time, to be a size of a speed
};

} // namespace kanexpr::simulated
