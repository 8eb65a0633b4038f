#pragma once

#include "playground/model/evaluate.hpp"
#include "playground/text/line.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace playground {

inline void build_particle(construction& in, const line& l) {
  const point_id at = in.point(l.name(1));
  const expression mass = evaluator(in).scalar(l.expression(2));
  if (!in.wrong().empty()) return;
  in.declare(l.name(0), named_body{});
  in.b.particle(l.name(0), at, mass);
}

inline void build_rigid_body(construction& in, const line& l) {
  const point_id center = in.point(l.name(1));
  const frame_id frame = in.frame(l.name(2)), axes = l.has(5) ? in.frame(l.name(5)) : frame;
  evaluator e(in);
  const expression mass = e.scalar(l.expression(3));
  const std::vector<tree>& entries = l.list(4);
  if (entries.size() != 3 && entries.size() != 6)
    in.fail("an inertia has 3 or 6 entries, got " + std::to_string(entries.size()));
  std::array<expression, 6> inertia{};
  for (std::size_t i = 0; i < inertia.size(); ++i)
    inertia[i] = i < entries.size() ? e.scalar(entries[i]) : in.b.number(0.0);
  if (!in.wrong().empty()) return;
  in.declare(l.name(0), named_body{});
  in.b.rigid_body(l.name(0), center, frame, mass,
                  in.b.inertia(axes, inertia[0], inertia[1], inertia[2], inertia[3], inertia[4], inertia[5]));
}

} // namespace playground
