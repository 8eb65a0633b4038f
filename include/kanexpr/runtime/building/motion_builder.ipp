#pragma once

#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/mechanics/motion/observe.hpp>
#include <kanexpr/runtime/building/motion_builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::runtime {

KANEXPR_ENGINE vector motion_builder::velocity_of(point_id point, mechanics::known_motion& known) {
  if (!is_own(known, "a velocity") || !checks_.owns("a velocity", point)) return {};
  return mechanics::velocity_of_point(known.moving(), place(point));
}

KANEXPR_ENGINE vector motion_builder::acceleration_of(point_id point, mechanics::known_motion& known) {
  if (!is_own(known, "an acceleration") || !checks_.owns("an acceleration", point)) return {};
  return mechanics::acceleration_of_point(known.moving(), place(point));
}

KANEXPR_ENGINE vector motion_builder::angular_velocity_of(frame_id frame, mechanics::known_motion& known) {
  if (!is_own(known, "an angular velocity") || !checks_.owns("an angular velocity", frame)) return {};
  return mechanics::angular_velocity_of_frame(known.moving(), place(frame));
}

KANEXPR_ENGINE vector motion_builder::angular_acceleration_of(frame_id frame,
                                                              mechanics::known_motion& known) {
  if (!is_own(known, "an angular acceleration") || !checks_.owns("an angular acceleration", frame)) return {};
  return mechanics::angular_acceleration_of_frame(known.moving(), place(frame));
}

KANEXPR_ENGINE expression motion_builder::derivative(expression e, mechanics::known_motion& known) {
  if (!is_own(known, "a derivative") || !checks_.owns("a derivative", e)) return m_.zero();
  mechanics::motion& k = known.moving();
  return k.rate(k.known(e));
}

KANEXPR_ENGINE vector motion_builder::derivative_in(const vector& v, frame_id frame,
                                                    mechanics::known_motion& known) {
  if (!is_own(known, "a derivative") || !checks_.owns("a derivative", v, frame)) return {};
  return mechanics::derivative_in(known.moving(), v, place(frame));
}

} // namespace kanexpr::runtime
