#pragma once

#include <kanexpr/animate/rigid_parts.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/runtime/interpreted.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace kanexpr::animate {

/// The samples of a motion, as vectors in the order of the model.
struct recorded_motion {
  std::vector<double> times{};
  std::vector<Eigen::VectorXd> states{}, inputs{};
  Eigen::VectorXd parameters{};
};

/// The positions of places and the orientations of frames along a motion, in inertial axes.
class recorded_poses {
public:
  recorded_poses(model& m, const rigid_parts& parts, const recorded_motion& motion)
      : frames_(m.mechanism().frames.size()) {
    const mechanics::mechanism& of = m.mechanism();
    symbolic::matrix wanted(m.graph(), 6 * frames_ + 3 * static_cast<int>(parts.places().size()), 1);
    int next = 0;
    const auto add = [&](const mechanics::components& c) {
      for (int i = 0; i < 3; ++i) wanted(next++, 0) = c[i];
    };
    for (int f = 0; f < frames_; ++f)
      for (int axis : {0, 1}) add(mechanics::express(of, mechanics::unit(*of.g, axis), f, of.inertial));
    for (const mechanics::vector& place : parts.places()) add(mechanics::express(of, place, of.inertial));
    runtime::interpreted<double> function = m.function(wanted);
    const Eigen::VectorXd no_rates = Eigen::VectorXd::Zero(of.speeds.size());
    for (std::size_t k = 0; k < motion.times.size() && cause_.empty(); ++k) {
      numbers_.emplace_back(
          function(motion.times[k], motion.states[k], motion.parameters, motion.inputs[k], no_rates));
      cause_ = function.status().cause();
      failed_at_ = k;
    }
  }

  /// The reason why a pose does not exist at a sample; empty if all exist.
  const std::string& cause() const { return cause_; }
  std::size_t failed_at() const { return failed_at_; }

  std::size_t samples() const { return numbers_.size(); }
  Eigen::Vector3d place(int i, std::size_t sample) const {
    return numbers_[sample].segment<3>(6 * frames_ + 3 * i);
  }
  Eigen::Matrix3d frame(int f, std::size_t sample) const {
    Eigen::Matrix3d axes;
    axes.col(0) = numbers_[sample].segment<3>(6 * f);
    axes.col(1) = numbers_[sample].segment<3>(6 * f + 3);
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return axes;
  }

private:
  int frames_;
  std::vector<Eigen::VectorXd> numbers_{};
  std::string cause_{};
  std::size_t failed_at_ = 0;
};

} // namespace kanexpr::animate
