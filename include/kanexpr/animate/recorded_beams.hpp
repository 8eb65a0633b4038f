#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/recorded_poses.hpp>
#include <kanexpr/figures/beam_sections.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/runtime/interpreted.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace kanexpr::animate {

/// The places of the sections of a beam along a motion, in inertial axes: for each sample, from the root to
/// the tip. Their z axes are along the beam, and their y axes along its first direction of bending.
struct recorded_beam {
  int body = mechanics::none; ///< the index of the flexible body
  std::size_t sections = 0;
  std::vector<placement> placements{};
};

namespace detail {

/// The positions, axes and directions across all sections, one after the other.
inline symbolic::matrix numbers_of(const figures::mechanism_with_sections& drawn) {
  const mechanics::mechanism& m = drawn.mechanism;
  symbolic::matrix wanted(*m.g, 9 * static_cast<int>(drawn.beams.size()) * mechanics::beam_outline::sections,
                          1);
  int next = 0;
  const auto add = [&](const mechanics::components& c) {
    for (int i = 0; i < 3; ++i) wanted(next++, 0) = c[i];
  };
  for (const figures::beam_sections& beam : drawn.beams) {
    const mechanics::flexible_body& f = m.flexible_bodies[beam.body];
    const mechanics::components across = figures::across_beam(f);
    for (std::size_t i = 0; i < beam.points.size(); ++i) {
      add(mechanics::express(m, mechanics::position_from_origin(m, beam.points[i]), m.inertial));
      add(mechanics::express(m, f.outline.axis, beam.frames[i], m.inertial));
      add(mechanics::express(m, across, beam.frames[i], m.inertial));
    }
  }
  return wanted;
}

inline placement placement_of_section(const Eigen::Vector<double, 9>& numbers) {
  placement here{.position = numbers.head<3>()};
  here.orientation.col(2) = numbers.segment<3>(3).normalized();
  here.orientation.col(1) = numbers.tail<3>().normalized();
  here.orientation.col(0) = here.orientation.col(1).cross(here.orientation.col(2));
  return here;
}

} // namespace detail

/// Evaluates the sections of all beams along a motion at which the model has poses.
inline std::vector<recorded_beam> record_beams(model& m, const recorded_motion& motion) {
  const figures::mechanism_with_sections drawn(m.mechanism());
  std::vector<recorded_beam> recorded;
  for (const figures::beam_sections& beam : drawn.beams)
    recorded.push_back({beam.body, beam.points.size(), {}});
  if (recorded.empty()) return recorded;
  runtime::interpreted<double> function = m.function(detail::numbers_of(drawn));
  const Eigen::VectorXd no_rates = Eigen::VectorXd::Zero(m.mechanism().speeds.size());
  for (std::size_t k = 0; k < motion.times.size(); ++k) {
    const Eigen::VectorXd numbers =
        function(motion.times[k], motion.states[k], motion.parameters, motion.inputs[k], no_rates);
    Eigen::Index next = 0;
    for (recorded_beam& beam : recorded)
      for (std::size_t i = 0; i < beam.sections; ++i, next += 9)
        beam.placements.push_back(detail::placement_of_section(numbers.segment<9>(next)));
  }
  return recorded;
}

} // namespace kanexpr::animate
