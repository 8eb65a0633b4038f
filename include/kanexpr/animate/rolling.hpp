#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/recorded_poses.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/runtime/interpreted.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

#include <Eigen/Core>

#include <cstddef>

namespace kanexpr::animate {

/// Moves all shapes of a model that rolls and uses the contact point as its origin, as `carried` does: the
/// displacement is the integral of the velocity of a point minus the change of its position. The integral is
/// evaluated by the trapezoidal rule on the samples.
inline void move_with_rolling(animation& a, model& m, int point, const recorded_motion& motion,
                              const recorded_poses& poses) {
  const mechanics::mechanism& of = m.mechanism();
  mechanics::known_motion known(of);
  mechanics::motion& moving = known.moving();
  const mechanics::components velocity =
      moving.velocity(known.skeleton_used().station_of_point[point], of.inertial);
  symbolic::matrix wanted(m.graph(), 3, 1);
  for (int i = 0; i < 3; ++i) wanted(i, 0) = velocity[i];
  runtime::interpreted<double> function = m.function(wanted);
  const Eigen::VectorXd no_rates = Eigen::VectorXd::Zero(of.speeds.size());
  Eigen::Vector3d traveled = Eigen::Vector3d::Zero(), before = traveled;
  for (std::size_t k = 0; k < motion.times.size(); ++k) {
    const Eigen::Vector3d now =
        function(motion.times[k], motion.states[k], motion.parameters, motion.inputs[k], no_rates);
    if (k > 0) traveled += (motion.times[k] - motion.times[k - 1]) / 2 * (before + now);
    before = now;
    const Eigen::Vector3d way = traveled - (poses.place(point, k) - poses.place(point, 0));
    const Eigen::Vector3d level = way - way.dot(a.up) * a.up;
    for (animation::shape& s : a.shapes) s.placements[k].position += level, s.placements[k].end += level;
  }
  a.carried = true;
}

} // namespace kanexpr::animate
