#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/load_names.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/mechanics/loads/segment.hpp>
#include <kanexpr/mechanics/loads/wrapping.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/constant_position.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/mechanics/motion/relative_motion.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/derivatives/accumulate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/printing/short_text.hpp>
#include <kanexpr/units/si.hpp>

#include <string_view>

namespace kanexpr::mechanics {

enum class pathway_form : unsigned char {
  through_points, ///< straight lines from point to point
  given_length,   ///< a length given as an expression of coordinates, such as the coordinate of a joint
  around_cylinder,
  around_sphere,
  around_cone,
};

/// A line whose length l depends on the configuration, such as that of a cable. A tension T in it has the
/// power −T dl/dt: it pulls at the points on which the line ends or is deflected.
struct pathway {
  pathway_form form{};
  sequence<int> points{}; ///< the ends, and between them the points through which it passes
  expression length{};    ///< of a given length
  int frame = none;       ///< in which a surface is fixed
  int center = none;      ///< a point of its axis, its center or its tip
  wrapped_surface surface{};

  constexpr bool is_around_surface() const { return frame != none; }

  /// The length as an expression for an energy.
  constexpr expression length_in(const mechanism& m) const {
    if (form == pathway_form::given_length) return length;
    if (is_around_surface()) return wrapped(m).length;
    expression sum = m.zero();
    for (int i = 1; i < points.size(); ++i) {
      const components d = segment{points[i - 1], points[i]}.line_for_energy(m);
      sum += sqrt(dot(d, d));
    }
    return sum;
  }

  /// The line around a surface, in the axes of the surface.
  constexpr wrapped_line wrapped(const mechanism& m) const {
    const components first = express(m, position_from(m, center, points[0]), frame),
                     last = express(m, position_from(m, center, points.back()), frame);
    if (form == pathway_form::around_cylinder) return line_around_cylinder(surface, first, last);
    if (form == pathway_form::around_sphere) return line_around_sphere(surface, first, last);
    return line_around_cone(surface, first, last);
  }

  /// Returns "between P and Q", or "with q" for a given length.
  constexpr sentence place(const load_names& by) const {
    if (form == pathway_form::given_length)
      return sentence({"with ", symbolic::short_text(length.owner(), length.node()).view()});
    return sentence({"between ", by.point(points[0]), " and ", by.point(points.back())});
  }

  /// Reports a pathway whose length is not known; `what` names the load, as in "linear spring".
  constexpr sentence find_mistake(const mechanism& m, std::string_view what) const {
    if (form == pathway_form::through_points) {
      for (int i = 1; i < points.size(); ++i)
        if (const sentence found = segment{points[i - 1], points[i]}.find_mistake(m, what)) return found;
    } else if (is_around_surface()) {
      for (const int end : {points[0], points.back()})
        if (const sentence found = check_position(m, end, center)) return found;
      return find_mistake_of_ends(m, what);
    }
    return {};
  }

  /// Checks the expressions; `whose` names the load.
  constexpr void check_with(load_check& by, std::string_view whose) const {
    if (form == pathway_form::given_length) by.check_no_rates(length, "the length of the ", whose);
    if (!is_around_surface()) return;
    by.check_fixed(surface.size, "the surface of the ", whose);
    if (!surface.size.is_constant()) return;
    const bool is_cone = form == pathway_form::around_cone;
    const double size = surface.size.owner().number_at(surface.size.node()).value();
    if (!(size > 0))
      by.fail({"the surface of the ", whose, " has no positive ", is_cone ? "angle" : "radius"});
    if (is_cone && size >= 1.570796326794896)
      by.fail({"the angle between the axis of the ", whose, " and its cone is not less than a right angle"});
  }

  constexpr void state_units(load_units& by, std::string_view whose) const {
    if (!is_around_surface()) return;
    by.describe({"the surface of the ", whose});
    by.expect(surface.size, form == pathway_form::around_cone ? units::si::radian : units::si::meter);
  }

  /// Whether the length is the same in every configuration, because it contains no coordinates.
  constexpr bool is_constant(const mechanism& m) const {
    if (form == pathway_form::given_length) return is_fixed(length);
    int moving = 0, base = is_around_surface() ? frame_of_constant_position(m, points[0], center) : none;
    for (int i = 1; i < points.size(); ++i) {
      const int from = is_around_surface() ? center : points[i - 1];
      const int at = frame_of_constant_position(m, points[i], from);
      if (at == none || (is_around_surface() && at != base)) ++moving;
    }
    const bool has_axis = is_around_surface() && form != pathway_form::around_sphere;
    return moving == 0 && (!has_axis || base == rigid_base(m, frame));
  }

private:
  /// Reports ends at which the pathway never exists: a common one, one inside the surface, or one that is
  /// declared to be on the surface and is not. Only distances that are numbers are known to be wrong.
  constexpr sentence find_mistake_of_ends(const mechanism& m, std::string_view what) const {
    const int first = points[0], last = points.back();
    const auto called = [&](int p) { return m.points[p].called.view(); };
    if (first == last) return sentence({"a ", what, " acts between point ", called(first), " and itself"});
    const auto fail = [&](int end, std::string_view how) {
      return sentence({"the end ", called(end), " of the ", what, " between ", called(first), " and ",
                       called(last), how});
    };
    for (const int end : {first, last}) {
      const bool is_on_surface = end == first ? surface.first_is_on_surface : surface.last_is_on_surface;
      const expression outside = height_above_surface(m, end);
      if (!outside.is_constant()) continue;
      const double height = outside.owner().number_at(outside.node()).value();
      if (is_on_surface && (height > 1e-9 || height < -1e-9)) return fail(end, " is not on the surface");
      if (!is_on_surface && height < -1e-9) return fail(end, " is inside the surface");
    }
    return {};
  }

  /// The square of the distance from the axis or the center over that of the surface, minus 1.
  constexpr expression height_above_surface(const mechanism& m, int end) const {
    const vector line = position_from(m, center, end);
    int axes = frame; // those in which the position may be constant
    for (const vector::part& p : line.parts)
      if (!p.value.is_zero()) axes = p.frame;
    const components at = express(m, line, axes), axis = express(m, surface.axis, frame, axes);
    const expression along = dot(at, axis), whole = dot(at, at);
    if (form == pathway_form::around_sphere) return whole / (surface.size * surface.size) - 1;
    const components radial = at - along * axis;
    expression radius = surface.size;
    if (form == pathway_form::around_cone) radius = along * tan(surface.size);
    return dot(radial, radial) / (radius * radius) - 1;
  }
};

/// A pathway at a configuration: its length, and the lines along which it pulls.
class taut_pathway {
public:
  constexpr taut_pathway(const pathway& along, const skeleton& s) : of_(along), s_(s), m_(*s.model) {
    if (of_.form == pathway_form::given_length)
      length_ = of_.length;
    else if (of_.is_around_surface())
      wrap();
    else
      stretch();
  }

  constexpr expression length() const { return length_; }

  /// The rate of the length.
  constexpr expression rate(motion& k) const {
    if (of_.form == pathway_form::given_length) return k.rate(k.known(of_.length));
    expression sum = m_.zero();
    for (const segment_in_axes& each : segments_) {
      const expression stretching = each.between.stretching(k, each.line);
      sum += stretching / each.length;
    }
    if (of_.is_around_surface())
      for (const expression& each :
           {rate_at(k, of_.points[0], line_.at_first), rate_at(k, of_.points.back(), line_.at_last)})
        sum += each;
    return sum;
  }

  /// Applies a tension.
  constexpr void pull(force_system& on, expression tension) const {
    if (tension.is_zero()) return;
    if (of_.form == pathway_form::given_length) return pull_on_coordinates(on, tension);
    for (const segment_in_axes& each : segments_) {
      const expression over_length = tension / each.length;
      vector force;
      force.add(each.line.axes, over_length * each.line.d);
      on.add_force(each.between.point, -force);
      on.add_force(each.between.against, force);
    }
    if (!of_.is_around_surface()) return;
    pull_at(on, of_.points[0], tension * line_.at_first);
    pull_at(on, of_.points.back(), tension * line_.at_last);
  }

private:
  struct segment_in_axes {
    segment between{};
    segment::line line{};
    expression length{};
  };

  constexpr void stretch() {
    length_ = m_.zero();
    for (int i = 1; i < of_.points.size(); ++i) {
      const segment between{of_.points[i - 1], of_.points[i]};
      const segment::line line = between.line_in(s_);
      const expression length = sqrt(dot(line.d, line.d));
      segments_.push({between, line, length});
      length_ += length;
    }
  }

  constexpr void wrap() {
    line_ = of_.wrapped(m_);
    length_ = line_.length;
  }

  /// The rate of the length due to the motion of an end relative to the surface.
  constexpr expression rate_at(motion& k, int end, const components& away) const {
    const vector v = velocity_between(k, s_.station_of_point[end], s_.station_of_point[of_.center]);
    components relative = express(m_, v, of_.frame);
    const components w =
        express(m_, k.angular_velocity(of_.frame), s_.working_axes[s_.rigid_with[of_.frame]], of_.frame);
    relative -= cross(w, arm(end));
    return dot(away, relative);
  }

  /// Applies a force −`away` at an end, and the opposite force on the surface at the same place.
  constexpr void pull_at(force_system& on, int end, const components& away) const {
    vector force, moment;
    force.add(of_.frame, away);
    on.add_force(end, -force);
    on.add_force(of_.center, force);
    moment.add(of_.frame, cross(arm(end), away));
    on.add_torque(of_.frame, none, moment);
  }

  constexpr components arm(int end) const {
    return express(m_, position_from(m_, of_.center, end), of_.frame);
  }

  /// Generalized forces −T ∂l/∂q.
  constexpr void pull_on_coordinates(force_system& on, expression tension) const {
    symbolic::accumulation by_coordinates(*m_.g, {of_.length});
    by_coordinates.seed(of_.length, m_.one());
    by_coordinates.run();
    sequence<expression> forces;
    for (const expression& q : m_.coordinates) {
      const expression direction = by_coordinates.by(q);
      forces.push(-(tension * direction));
    }
    on.add_coordinate_forces(forces);
  }

  const pathway& of_;
  const skeleton& s_;
  const mechanism& m_;
  expression length_{};
  sequence<segment_in_axes> segments_{};
  wrapped_line line_{};
};

} // namespace kanexpr::mechanics
