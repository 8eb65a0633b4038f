#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/recorded_poses.hpp>
#include <kanexpr/figures/outlines.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/runtime/interpreted.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
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

/// The places of the nodes of a flexible body along a motion, in inertial axes: for each sample, one after
/// the other.
struct recorded_nodes {
  int body = mechanics::none; ///< the index of the flexible body
  std::size_t nodes = 0;
  std::vector<Eigen::Vector3d> places{};
};

/// The flexible bodies of a model along a motion.
struct recorded_outlines {
  std::vector<recorded_beam> beams{};
  std::vector<recorded_nodes> nodes{};
};

namespace detail {

/// The positions, axes and directions across all sections, followed by the positions of all nodes.
inline symbolic::matrix numbers_of(const figures::outlined_mechanism& drawn) {
  const mechanics::mechanism& m = drawn.mechanism;
  base::sequence<symbolic::expression> wanted;
  const auto add = [&](const mechanics::components& c) {
    for (int i = 0; i < 3; ++i) wanted.push(c[i]);
  };
  const auto add_position = [&](int point) {
    add(mechanics::express(m, mechanics::position_from_origin(m, point), m.inertial));
  };
  for (const figures::beam_sections& beam : drawn.beams) {
    const mechanics::flexible_body& f = m.flexible_bodies[beam.body];
    const mechanics::components across = figures::across_beam(f);
    for (std::size_t i = 0; i < beam.points.size(); ++i) {
      add_position(beam.points[i]);
      add(mechanics::express(m, f.outline.axis, beam.frames[i], m.inertial));
      add(mechanics::express(m, across, beam.frames[i], m.inertial));
    }
  }
  for (const figures::body_nodes& body : drawn.nodes)
    for (const int point : body.points) add_position(point);
  symbolic::matrix all(*m.g, wanted.size(), 1);
  for (int i = 0; i < wanted.size(); ++i) all(i, 0) = wanted[i];
  return all;
}

inline placement placement_of_section(const Eigen::Vector<double, 9>& numbers) {
  placement here{.position = numbers.head<3>()};
  here.orientation.col(2) = numbers.segment<3>(3).normalized();
  here.orientation.col(1) = numbers.tail<3>().normalized();
  here.orientation.col(0) = here.orientation.col(1).cross(here.orientation.col(2));
  return here;
}

inline void add_sample(recorded_outlines& to, const Eigen::VectorXd& numbers) {
  Eigen::Index next = 0;
  for (recorded_beam& beam : to.beams)
    for (std::size_t i = 0; i < beam.sections; ++i, next += 9)
      beam.placements.push_back(placement_of_section(numbers.segment<9>(next)));
  for (recorded_nodes& body : to.nodes)
    for (std::size_t i = 0; i < body.nodes; ++i, next += 3)
      body.places.emplace_back(numbers.segment<3>(next));
}

} // namespace detail

/// Evaluates the flexible bodies along a motion at which the model has poses.
inline recorded_outlines record_outlines(model& m, const recorded_motion& motion) {
  const figures::outlined_mechanism drawn(m.mechanism());
  recorded_outlines recorded;
  for (const figures::beam_sections& beam : drawn.beams)
    recorded.beams.push_back({beam.body, beam.points.size(), {}});
  for (const figures::body_nodes& body : drawn.nodes)
    recorded.nodes.push_back({body.body, body.points.size(), {}});
  if (recorded.beams.empty() && recorded.nodes.empty()) return recorded;
  runtime::interpreted<double> function = m.function(detail::numbers_of(drawn));
  const Eigen::VectorXd no_rates = Eigen::VectorXd::Zero(m.mechanism().speeds.size());
  for (std::size_t k = 0; k < motion.times.size(); ++k)
    detail::add_sample(
        recorded, function(motion.times[k], motion.states[k], motion.parameters, motion.inputs[k], no_rates));
  return recorded;
}

} // namespace kanexpr::animate
