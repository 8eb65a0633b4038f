#pragma once

#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/runtime/building/number_or_expression.hpp>
#include <kanexpr/runtime/building/pulling_load.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <vector>

namespace kanexpr::runtime {

/// The forces and torques of a builder, and the springs and dampers between two points or frames.
class load_builder : private builder_part {
public:
  void force(point_id at, const vector& value);
  void torque(frame_id on, const vector& value);
  /// A force on the point `at` and the opposite force on `other`.
  void force_between(point_id at, point_id other, const vector& value);
  /// A force −c |v| v, where v is the velocity of the point.
  void drag(point_id at, const number_or_expression& coefficient, mechanics::known_motion& known);
  /// A torque on the frame `on` and the opposite torque on `other`.
  void torque_between(frame_id on, frame_id other, const vector& value);
  /// The gravitational acceleration of all bodies.
  void gravity(const vector& acceleration);
  /// A potential energy as a function of coordinates, parameters, time and inputs.
  void potential_energy(expression energy);
  /// A straight spring that pulls two points together with the force stiffness·(distance − natural length).
  pulling_load spring(point_id at, point_id other, expression stiffness, expression natural_length);
  pulling_load spring(point_id at, point_id other, expression stiffness) {
    return spring(at, other, stiffness, m_.zero());
  }
  /// A damper that pulls two points together with the force damping·(rate of change of their distance).
  pulling_load damper(point_id at, point_id other, expression damping);
  /// A torsional spring that returns an angle to its rest position with the torque stiffness·(angle − rest).
  void torsional_spring(expression angle, expression stiffness, expression rest);
  void torsional_spring(expression angle, expression stiffness) {
    torsional_spring(angle, stiffness, m_.zero());
  }
  /// A torque −damping·ω on the frame `on` and the opposite torque on `other`, where ω is the angular
  /// velocity of `on` relative to `other`.
  void torsional_damper(frame_id on, frame_id other, expression damping);
  /// An elastic mount between the frame `on` at the point `at` and the frame `base` at the point
  /// `base_point`, with stiffnesses along and about the axes of `base`, as `bushing<Body, Base, …>`; dampings
  /// may be omitted.
  void bushing(frame_id on, point_id at, frame_id base, point_id base_point,
               const std::vector<expression>& stiffnesses, const std::vector<expression>& dampings = {});

protected:
  explicit load_builder(builder_core& core) : builder_part(core) {}
  ~load_builder() = default;
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/load_builder.ipp>
#endif
