#pragma once

#include <kanexpr/compiled/assemble.hpp>
#include <kanexpr/numeric/angle.hpp>
#include <kanexpr/simulate/trial_steps.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace kanexpr::simulated {

/// How large the coordinates and speeds of a motion are, in whatever units, as far as its beginning tells:
/// their values there, and what they become in the time in which the motion changes. An angle is at least 1.
/// Another coordinate that does not move at all is as large as the largest of these, or as what would move
/// them if the angles stood otherwise, or 1; a speed takes its coordinate through its size in that time, and
/// is not much smaller.
template <class System>
class state_sizes {
public:
  using state = kanexpr::state<System>;

  state_sizes(surroundings<System>& around, double t, const state& x, double span)
      : state_sizes(around, t, x, trial_steps<System>(around, t, x, span)) {}

  const state& sizes() const { return sizes_; }

private:
  state_sizes(surroundings<System>& around, double t, const state& x, const trial_steps<System>& ahead)
      : sizes_(ahead.sizes()), time_(ahead.time()), least_share_(ahead.has_own_time() ? 0.1 : 1e-4) {
    fill_coordinates(around, t, x);
    fill_speeds(around, t, x);
    around.forget();
  }

  static constexpr int coordinates = state::coordinates, speeds = state::speeds;
  static constexpr double nothing = 1e-12; ///< beside a size

  /// The rates with the inputs of the first instant, where they can be had, and what the configuration
  /// constraints leave.
  static Eigen::VectorXd functions(const surroundings<System>& around, double t, const state& x) {
    const compiled::constraints_at<System, parameter_values<System>, input_values<System>> constraints(
        t, around.p(), around.r());
    Eigen::VectorXd all(x.size() + compiled::survey_of<System>.configuration_constraints);
    all << out_of_line<function<System, mechanics::quantity::rhs>>{}(t, x, around.p(), around.r()),
        constraints.configuration_residual(x);
    return all;
  }

  void fill_coordinates(const surroundings<System>& around, double t, const state& x) {
    std::vector<bool> angles;
    double longest = 0;
    for (int j = 0; j < coordinates; ++j) {
      const auto beside = [&](double by) {
        state moved = x;
        moved(j) += by;
        return functions(around, t, moved);
      };
      angles.push_back(compiled::survey_of<System>.quaternion_of[j] != 0 || numeric::is_angle(beside));
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
  double longest_way(const surroundings<System>& around, double t, const state& x,
                     const std::vector<bool>& angles) const {
    state turned = x, moving = x;
    for (int j = 0; j < coordinates; ++j)
      if (angles[static_cast<std::size_t>(j)]) turned(j) += 1;
    moving.template tail<speeds>() =
        functions(around, t, turned).template segment<speeds>(coordinates) * time_ / 2;
    const Eigen::VectorXd rates = functions(around, t, moving);
    double longest = 0;
    for (int j = 0; j < coordinates; ++j)
      if (!angles[static_cast<std::size_t>(j)] && std::isfinite(rates(j)))
        longest = (std::max)(longest, std::abs(rates(j)) * time_);
    return longest;
  }

  /// The rates of coordinates are linear in the speeds. Errors of a speed do not matter that move each
  /// coordinate by less than its own error.
  void fill_speeds(const surroundings<System>& around, double t, const state& x) {
    state alone = x;
    alone.template tail<speeds>().setZero();
    const Eigen::VectorXd at_rest = functions(around, t, alone);
    for (int k = coordinates; k < coordinates + speeds; ++k) {
      alone(k) = 1;
      const Eigen::VectorXd change = functions(around, t, alone) - at_rest;
      alone(k) = 0;
      double usual = 0;
      for (int j = 0; j < coordinates; ++j) {
        const double found = sizes_(j) / std::abs(change(j)) / time_;
        if (found > 0 && std::isfinite(found)) usual = usual > 0 ? (std::min)(usual, found) : found;
      }
      if (!(usual > 0)) usual = 1;
      if (!(sizes_(k) > nothing * usual)) sizes_(k) = usual;
      sizes_(k) = (std::max)(sizes_(k), least_share_ * usual);
    }
  }

  state sizes_;
  double time_;        ///< in which the motion changes
  double least_share_; ///< of what takes a coordinate through its size in that time, to be a size of a speed
};

} // namespace kanexpr::simulated
