#pragma once

#include "playground/model/evaluate.hpp"
#include "playground/text/line.hpp"

#include <kanexpr/mechanics/motion/observe.hpp>

#include <utility>
#include <vector>

namespace playground {

/// The vector and the directions along which it vanishes.
inline kanexpr::runtime::zero_components along_each(construction& in, kanexpr::mechanics::vector v,
                                                    const std::vector<tree>& directions) {
  kanexpr::runtime::zero_components all{std::move(v), {}};
  for (const tree& each : directions) all.directions.push_back(evaluator(in).vector(each));
  return all;
}

inline void build_loop(construction& in, const line& l) {
  const point_id to = in.point(l.name(0)), from = in.point(l.name(1));
  if (!in.wrong().empty()) return;
  const auto vanishes = along_each(in, in.b.position_of(to, from), l.list(2));
  if (in.wrong().empty()) in.b.configuration_constraint(vanishes);
}

inline void build_no_slip(construction& in, const line& l) {
  const point_id point = in.point(l.name(0));
  if (!in.wrong().empty()) return;
  const auto velocity = kanexpr::mechanics::velocity_of_point(in.moving(), kanexpr::runtime::place(point));
  const auto vanishes = along_each(in, velocity, l.list(1));
  if (in.wrong().empty()) in.b.velocity_constraint(vanishes);
}

inline void build_equation(construction& in, const line& l) {
  evaluator e(in);
  const expression left = e.scalar(l.expression(0)), right = e.scalar(l.expression(1));
  if (!in.wrong().empty()) return;
  l.word == "configuration_constraint" ? in.b.configuration_constraint(left - right)
                                       : in.b.velocity_constraint(left - right);
}

inline void build_dependent(construction& in, const line& l) {
  for (const tree& each : l.list(0)) {
    const expression symbol = evaluator(in).scalar(each);
    if (in.wrong().empty()) in.b.dependent(symbol);
  }
}

} // namespace playground
