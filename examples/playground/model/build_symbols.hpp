#pragma once

#include "playground/model/evaluate.hpp"
#include "playground/text/line.hpp"

#include <string>

namespace playground {

/// Declares a coordinate, speed, parameter or input with its value.
inline void build_symbol(construction& in, const line& l, std::size_t place, const std::string& kind) {
  const std::string& name = l.name(place);
  if (l.has(place + 1)) in.start[name] = evaluator(in).number(l.expression(place + 1));
  if (!in.wrong().empty()) return;
  auto& b = in.b;
  in.declare(name, kind == "coordinate"  ? b.coordinate(name)
                   : kind == "speed"     ? b.speed(name)
                   : kind == "parameter" ? b.parameter(name)
                                         : b.input(name));
}

inline void build_kinematics(construction& in, const line& l) {
  evaluator e(in);
  const expression left = e.scalar(l.expression(0)), right = e.scalar(l.expression(1));
  if (in.wrong().empty()) in.b.kinematic_equation(left - right);
}

} // namespace playground
