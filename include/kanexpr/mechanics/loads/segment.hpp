#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/mechanics/motion/relative_motion.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// The straight line between two points, along which springs, dampers and cables pull.
struct segment {
  int point = none;
  int against = none;

  /// The line d from `against` to `point`, in the axes in which the forces at the point deeper in the tree
  /// are formed.
  struct line {
    int axes = mechanism::inertial;
    components d{};
  };
  constexpr line line_in(const skeleton& s) const {
    const mechanism& m = *s.model;
    line found;
    int depth = 0;
    for (int p : {point, against}) {
      const int axes = s.working_axes[s.stations[s.station_of_point[p]].axes];
      if (path::depth(m, axes) > depth) found.axes = axes, depth = path::depth(m, axes);
    }
    found.d = express(m, line_in(m), found.axes);
    return found;
  }

  /// The line for an energy. Rotating the whole line does not change its length, so it is expressed in the
  /// axes of the first rotating frame that it involves.
  constexpr components line_for_energy(const mechanism& m) const {
    const vector all = line_in(m);
    int axes = mechanism::inertial, least = 0;
    for (const vector::part& p : all.parts) {
      const int depth = path::depth(m, p.frame);
      if (depth > 0 && (least == 0 || depth < least)) axes = p.frame, least = depth;
    }
    return express(m, all, axes);
  }

  /// The relative velocity of the points times the line, v·d.
  constexpr expression stretching(motion& k, const line& along) const {
    const skeleton& s = k.skeleton_used();
    const vector v = velocity_between(k, s.station_of_point[point], s.station_of_point[against]);
    return dot(along.d, express(*s.model, v, along.axes));
  }

  /// The vector from the second point to the first, without the part that both positions have in common.
  constexpr vector line_in(const mechanism& m) const {
    vector d;
    for (const vector::part& p : position_from(m, against, point).parts)
      if (!p.value.is_zero()) d.parts.push(p);
    return d;
  }

  /// Reports a segment whose length is not known or always zero; `what` names the load, as in "spring".
  constexpr sentence find_mistake(const mechanism& m, std::string_view what) const {
    const std::string_view first = m.points[point].called.view(), other = m.points[against].called.view();
    if (point == against) return sentence({"a ", what, " acts between point ", first, " and itself"});
    const int origin = origin_of(m, point), of_other = origin_of(m, against);
    if (origin != of_other)
      return sentence({"the ", what, " between ", first, " and ", other,
                       " has ends measured from two origins, ", m.points[origin].called.view(), " and ",
                       m.points[of_other].called.view(), ", whose distance is not known"});
    if (line_in(m).parts.empty())
      return sentence(
          {"the ", what, " between ", first, " and ", other, " has zero length in every configuration"});
    return {};
  }
};

} // namespace kanexpr::mechanics
