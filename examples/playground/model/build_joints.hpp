#pragma once

#include "playground/model/build_symbols.hpp"
#include "playground/model/evaluate.hpp"
#include "playground/text/line.hpp"

#include <string>

namespace playground {

/// A pin or a slider: a coordinate, a speed that is its rate, and the frame or point that they move.
inline void build_joint(construction& in, const line& l) {
  const bool is_pin = l.word == "pin";
  build_symbol(in, l, 3, "coordinate");
  build_symbol(in, l, 5, "speed");
  if (!in.wrong().empty()) return;
  const expression q = in.find<expression>(l.name(3), "symbol"), u = in.find<expression>(l.name(5), "symbol");
  in.b.kinematic_equation(in.b.dot(q) - u);
  const auto direction = evaluator(in).vector(l.expression(2));
  if (is_pin) {
    const frame_id parent = in.frame(l.name(1));
    if (in.wrong().empty()) in.declare(l.name(0), in.b.rotated(l.name(0), parent, q, direction));
  } else {
    const point_id parent = in.point(l.name(1));
    if (in.wrong().empty()) in.declare(l.name(0), in.b.offset(l.name(0), parent, q * direction));
  }
}

inline void build_rotated(construction& in, const line& l) {
  const frame_id parent = in.frame(l.name(1));
  evaluator e(in);
  const expression angle = e.scalar(l.expression(2));
  const auto axis = e.vector(l.expression(3));
  if (in.wrong().empty()) in.declare(l.name(0), in.b.rotated(l.name(0), parent, angle, axis));
}

inline void build_rotated_by_sequence(construction& in, const line& l) {
  const frame_id parent = in.frame(l.name(1));
  if (l.list(3).size() != 3) in.fail(l.word + " takes 3 angles, got " + std::to_string(l.list(3).size()));
  if (!in.wrong().empty()) return;
  evaluator e(in);
  const expression first = e.scalar(l.list(3)[0]), second = e.scalar(l.list(3)[1]),
                   third = e.scalar(l.list(3)[2]);
  if (!in.wrong().empty()) return;
  in.declare(l.name(0), l.word == "body_fixed"
                            ? in.b.body_fixed(l.name(0), parent, l.name(2), first, second, third)
                            : in.b.space_fixed(l.name(0), parent, l.name(2), first, second, third));
}

inline void build_angular_velocity(construction& in, const line& l) {
  const frame_id frame = in.frame(l.name(0)), reference = in.frame(l.name(1));
  const auto value = evaluator(in).vector(l.expression(2));
  if (in.wrong().empty()) in.b.angular_velocity(frame, reference, value);
}

inline void build_kinematics_of(construction& in, const line& l) {
  const frame_id frame = in.frame(l.name(0)), reference = in.frame(l.name(1));
  if (in.wrong().empty()) in.b.kinematics_of(frame, reference);
}

inline void build_offset(construction& in, const line& l) {
  const point_id parent = in.point(l.name(1));
  const auto from_parent = evaluator(in).vector(l.expression(2));
  if (in.wrong().empty()) in.declare(l.name(0), in.b.offset(l.name(0), parent, from_parent));
}

inline void build_fixed(construction& in, const line& l) {
  const point_id point = in.point(l.name(0));
  const frame_id frame = in.frame(l.name(1));
  if (in.wrong().empty()) in.b.fixed_in(point, frame);
}

} // namespace playground
