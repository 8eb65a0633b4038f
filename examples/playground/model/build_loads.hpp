#pragma once

#include "playground/model/evaluate.hpp"
#include "playground/text/line.hpp"

namespace playground {

inline void build_gravity(construction& in, const line& l) {
  const auto acceleration = evaluator(in).vector(l.expression(0));
  if (in.wrong().empty()) in.b.gravity(acceleration);
}

inline void build_force(construction& in, const line& l) {
  const auto force = evaluator(in).vector(l.expression(0));
  const point_id at = in.point(l.name(1)), other = l.word == "force" ? at : in.point(l.name(2));
  if (!in.wrong().empty()) return;
  l.word == "force" ? in.b.force(at, force) : in.b.force_between(at, other, force);
}

inline void build_torque(construction& in, const line& l) {
  const auto torque = evaluator(in).vector(l.expression(0));
  const frame_id on = in.frame(l.name(1)), other = l.word == "torque" ? on : in.frame(l.name(2));
  if (!in.wrong().empty()) return;
  l.word == "torque" ? in.b.torque(on, torque) : in.b.torque_between(on, other, torque);
}

inline void build_spring(construction& in, const line& l) {
  const point_id at = in.point(l.name(0)), other = in.point(l.name(1));
  evaluator e(in);
  const expression stiffness = e.scalar(l.expression(2)),
                   length = l.has(3) ? e.scalar(l.expression(3)) : stiffness;
  if (!in.wrong().empty()) return;
  l.has(3) ? in.b.spring(at, other, stiffness, length) : in.b.spring(at, other, stiffness);
}

inline void build_damper(construction& in, const line& l) {
  const point_id at = in.point(l.name(0)), other = in.point(l.name(1));
  const expression damping = evaluator(in).scalar(l.expression(2));
  if (in.wrong().empty()) in.b.damper(at, other, damping);
}

inline void build_torsional_spring(construction& in, const line& l) {
  evaluator e(in);
  const expression angle = e.scalar(l.expression(0)), stiffness = e.scalar(l.expression(1)),
                   rest = l.has(2) ? e.scalar(l.expression(2)) : angle;
  if (!in.wrong().empty()) return;
  l.has(2) ? in.b.torsional_spring(angle, stiffness, rest) : in.b.torsional_spring(angle, stiffness);
}

inline void build_torsional_damper(construction& in, const line& l) {
  const frame_id on = in.frame(l.name(0)), other = in.frame(l.name(1));
  const expression damping = evaluator(in).scalar(l.expression(2));
  if (in.wrong().empty()) in.b.torsional_damper(on, other, damping);
}

inline void build_potential_energy(construction& in, const line& l) {
  const expression energy = evaluator(in).scalar(l.expression(0));
  if (in.wrong().empty()) in.b.potential_energy(energy);
}

} // namespace playground
