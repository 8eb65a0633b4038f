#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/mechanics/checks/check.hpp>
#include <kanexpr/mechanics/model/bodies.hpp>
#include <kanexpr/mechanics/model/central_inertia.hpp>
#include <kanexpr/mechanics/model/check_position.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/frames.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/model/points.hpp>
#include <kanexpr/mechanics/skeleton/orientation_kinematics.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/derived_from_builder.ipp>
#include <kanexpr/runtime/own_graph.ipp>
#include <kanexpr/runtime/unused_symbols.ipp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <memory>
#include <string_view>

namespace kanexpr::runtime {

KANEXPR_ENGINE builder::builder(std::string_view inertial_frame) : system_(*graph_), inspect_(m_) {
  inspect_.fresh("frames", inertial_frame, m_.frames);
  mechanics::add_inertial_frame(m_, inertial_frame);
}

KANEXPR_ENGINE sentence(builder::check)() const {
  if (mistake()) return mistake();
  const sentence found = mechanics::check_system(system_);
  return found ? found : check_uses(system_, used_elsewhere_);
}

KANEXPR_ENGINE void builder::used_elsewhere(expression parameter_or_input) {
  if (m_.parameters.contains(parameter_or_input) || m_.inputs.contains(parameter_or_input))
    used_elsewhere_.push(parameter_or_input);
  else
    inspect_.fail({"the argument of used_elsewhere is neither a parameter nor an input"});
}

KANEXPR_ENGINE expression builder::coordinate(std::string_view q) {
  return inspect_.fresh_symbol(q), m_.coordinate(q);
}

KANEXPR_ENGINE expression builder::speed(std::string_view u) { return inspect_.fresh_symbol(u), m_.speed(u); }

KANEXPR_ENGINE expression builder::parameter(std::string_view p) {
  return inspect_.fresh_symbol(p), m_.parameter(p);
}

KANEXPR_ENGINE expression builder::input(std::string_view r) { return inspect_.fresh_symbol(r), m_.input(r); }

KANEXPR_ENGINE expression builder::prescribed(std::string_view r) {
  mechanics::name called = r;
  const expression value = input(r);
  expression last = value;
  for (int order = 1; order <= 2; ++order) {
    called.append("'");
    inspect_.unused(called.view());
    const expression rate = m_.input(called);
    m_.prescribed_rates.push({last, rate});
    last = rate;
  }
  return value;
}

KANEXPR_ENGINE expression builder::auxiliary_speed(std::string_view u) {
  return inspect_.fresh_symbol(u), m_.auxiliary_speed(u);
}

KANEXPR_ENGINE void builder::rates_as_speeds() {
  m_.derived_by = mechanics::method::lagrange;
  m_.take_rates_as_speeds();
}

KANEXPR_ENGINE void builder::lagrangian(expression energy) {
  if (!inspect_.own(energy, "the Lagrangian")) return;
  system_.loads.has_lagrangian = true;
  system_.loads.lagrangian = energy;
}

KANEXPR_ENGINE expression builder::number(given_number value) {
  if (value.is_whole_zero()) inspect_.fail_by_whole_zero("the argument of number is 0");
  if (!symbolic::is_finite(value.value())) inspect_.fail({"the argument of number is not finite"});
  return m_.number(value.value());
}

KANEXPR_ENGINE expression builder::dot(expression e) {
  if (e.belongs_to(*graph_)) {
    if (const int q = m_.coordinates.find(e); q >= 0)
      return m_.derived_by == mechanics::method::lagrange ? m_.speeds[q] : m_.coordinate_rates[q];
    if (const int u = m_.speeds.find(e); u >= 0) return m_.speed_rates[u];
    for (const mechanics::prescribed_rate& p : m_.prescribed_rates)
      if (p.quantity == e) return p.rate;
  }
  inspect_.fail({"the argument of dot is not a coordinate, speed or prescribed quantity"});
  return m_.zero();
}

KANEXPR_ENGINE void builder::kinematic_equation(expression vanishes) {
  if (inspect_.own(vanishes, "a kinematic differential equation")) m_.kinematics.push(vanishes);
}

KANEXPR_ENGINE void builder::kinematics_of(frame_id frame, frame_id reference) {
  constexpr std::string_view whose = "kinematics_of";
  if (!inspect_.present(frame, whose) || !inspect_.present(reference, whose)) return;
  if (const sentence found = mechanics::check_orientation_kinematics(m_, place(frame), place(reference))) {
    inspect_.fail({found.view()});
    return;
  }
  for (const expression& e : mechanics::orientation_kinematics(m_, place(frame), place(reference)))
    m_.kinematics.push(e);
}

KANEXPR_ENGINE expression builder::of(const number_or_expression& given) {
  if (const given_number* value = std::get_if<given_number>(&given.held())) return number(value->value());
  return std::get<expression>(given.held());
}

KANEXPR_ENGINE bool builder::not_all_zero(std::initializer_list<const number_or_expression*> given,
                                          std::string_view whose) {
  for (const number_or_expression* each : given)
    if (!each->is_whole_zero()) return true;
  return inspect_.fail_by_whole_zero(whose);
}

KANEXPR_ENGINE vector builder::along(frame_id axes, const number_or_expression& x,
                                     const number_or_expression& y, const number_or_expression& z) {
  vector v;
  if (!not_all_zero({&x, &y, &z}, "every component of a vector is 0")) return v;
  const mechanics::components value{of(x), of(y), of(z)};
  if (inspect_.present(axes, "a vector") && inspect_.own(value, "a vector")) v.add(place(axes), value);
  return v;
}

KANEXPR_ENGINE expression builder::dot(const vector& a, const vector& b) {
  constexpr std::string_view whose = "a dot product";
  if (!inspect_.own(a, whose) || !inspect_.own(b, whose)) return m_.zero();
  return derivation::dot(m_, a, b);
}

KANEXPR_ENGINE dyadic builder::inertia(frame_id axes, const number_or_expression& xx,
                                       const number_or_expression& yy, const number_or_expression& zz,
                                       const number_or_expression& xy, const number_or_expression& yz,
                                       const number_or_expression& zx) {
  if (!not_all_zero({&xx, &yy, &zz, &xy, &yz, &zx}, "every entry of an inertia is 0")) return {};
  mechanics::symmetric scalars;
  scalars.xx = of(xx), scalars.yy = of(yy), scalars.zz = of(zz);
  scalars.xy = of(xy), scalars.yz = of(yz), scalars.zx = of(zx);
  const dyadic d = mechanics::dyadic_of(place(axes), scalars);
  return inspect_.own(d, "an inertia") ? d : dyadic{};
}

KANEXPR_ENGINE dyadic builder::inertia(frame_id axes, const number_or_expression& xx,
                                       const number_or_expression& yy, const number_or_expression& zz) {
  return inertia(axes, xx, yy, zz, 0, 0, 0);
}

KANEXPR_ENGINE frame_id builder::rotated(std::string_view called, frame_id parent, expression angle,
                                         const vector& axis) {
  if (!new_frame(called, parent) || !inspect_.own(angle, called) || !inspect_.own(axis, called)) return {};
  const mechanics::components a = mechanics::express(m_, axis, place(parent));
  if (a.is_zero())
    inspect_.fail({"frame ", called, " is rotated about an axis of zero length"});
  else if (!mechanics::is_fixed(a))
    inspect_.fail({"frame ", called, " is rotated about an axis that is not fixed in ", name_of(parent)});
  else
    return frame_id{mechanics::add_rotated_frame(m_, called, place(parent), angle, a)};
  return {};
}

KANEXPR_ENGINE frame_id builder::body_fixed(std::string_view called, frame_id parent,
                                            std::string_view letters, expression first, expression second,
                                            expression third) {
  return by_sequence(called, parent, letters, {first, second, third}, false);
}

KANEXPR_ENGINE frame_id builder::space_fixed(std::string_view called, frame_id parent,
                                             std::string_view letters, expression first, expression second,
                                             expression third) {
  return by_sequence(called, parent, letters, {first, second, third}, true);
}

KANEXPR_ENGINE frame_id builder::quaternion(std::string_view called, frame_id parent, expression e0,
                                            expression e1, expression e2, expression e3) {
  if (!new_frame(called, parent) || !inspect_.own({e0, e1, e2, e3}, called)) return {};
  return frame_id{mechanics::add_frame_by_quaternion(m_, called, place(parent), e0, e1, e2, e3)};
}

KANEXPR_ENGINE frame_id builder::modified_rodrigues(std::string_view called, frame_id parent, expression s1,
                                                    expression s2, expression s3) {
  const mechanics::components s{s1, s2, s3};
  if (!new_frame(called, parent) || !inspect_.own(s, called)) return {};
  return frame_id{mechanics::add_frame_by_modified_rodrigues(m_, called, place(parent), s)};
}

KANEXPR_ENGINE frame_id builder::direction_cosines(std::string_view called, frame_id parent,
                                                   const mechanics::matrix3& to_parent) {
  if (!new_frame(called, parent) || !inspect_.own(to_parent, called)) return {};
  return frame_id{mechanics::add_frame_by_matrix(m_, called, place(parent), to_parent)};
}

KANEXPR_ENGINE void builder::angular_velocity(frame_id frame, frame_id reference, const vector& value) {
  declare(frame, reference, value, false);
}

KANEXPR_ENGINE void builder::angular_velocity_apart_from_orientation(frame_id frame, frame_id reference,
                                                                     const vector& value) {
  declare(frame, reference, value, true);
}

KANEXPR_ENGINE point_id builder::origin(std::string_view called) {
  if (!inspect_.fresh("points", called, m_.points)) return {};
  return point_id{mechanics::add_origin(m_, called)};
}

KANEXPR_ENGINE point_id builder::offset(std::string_view called, point_id parent, const vector& from_parent) {
  if (!inspect_.fresh("points", called, m_.points) || !inspect_.present(parent, called) ||
      !inspect_.own(from_parent, called))
    return {};
  return point_id{mechanics::add_point(m_, called, place(parent), from_parent)};
}

KANEXPR_ENGINE void builder::fixed_in(point_id point, frame_id frame) {
  if (inspect_.present(frame, "a fixed point") && unsaid_motion(point))
    mechanics::fix_point(m_, place(point), place(frame));
}

KANEXPR_ENGINE vector builder::position_of(point_id point, point_id from) {
  if (!both(point, from, "a position")) return {};
  if (const sentence unknown = mechanics::check_position(m_, place(point), place(from))) {
    inspect_.fail({unknown.view()});
    return {};
  }
  return mechanics::position_from(m_, place(from), place(point));
}

KANEXPR_ENGINE void builder::velocity(point_id point, frame_id reference, const vector& value) {
  if (may_move(point, reference, value))
    mechanics::declare_velocity(m_.points[place(point)], place(reference), value);
}

KANEXPR_ENGINE void builder::velocity_apart_from_position(point_id point, frame_id reference,
                                                          const vector& value) {
  if (!may_move(point, reference, value)) return;
  mechanics::declare_velocity(m_.points[place(point)], place(reference), value);
  m_.points[place(point)].moves_apart = true;
}

KANEXPR_ENGINE void builder::velocity_from_parent(point_id point, frame_id reference, const vector& value) {
  if (may_move(point, reference, value))
    mechanics::declare_velocity_from_parent(m_.points[place(point)], place(reference), value);
}

KANEXPR_ENGINE void builder::particle(std::string_view called, point_id at, expression mass) {
  if (inspect_.fresh("bodies", called, m_.bodies) && inspect_.present(at, called) &&
      inspect_.own(mass, called))
    mechanics::add_particle(m_, called, place(at), mass);
}

KANEXPR_ENGINE void builder::rigid_body(std::string_view called, point_id center, frame_id frame,
                                        expression mass, const dyadic& inertia) {
  rigid_body(called, center, frame, mass, inertia, center);
}

KANEXPR_ENGINE void builder::rigid_body(std::string_view called, point_id center, frame_id frame,
                                        expression mass, const dyadic& inertia, point_id about) {
  if (inspect_.fresh("bodies", called, m_.bodies) && inspect_.present(center, called) &&
      inspect_.present(frame, called) && inspect_.own(mass, called) && inspect_.own(inertia, called) &&
      inspect_.present(about, called))
    mechanics::add_rigid_body(m_, called, place(center), place(frame), mass, inertia, place(about));
}

KANEXPR_ENGINE void builder::changing_inertia(std::string_view body) {
  for (mechanics::body& b : m_.bodies)
    if (b.called.view() == body) {
      b.inertia_changes = true;
      return;
    }
  inspect_.fail({"changing_inertia refers to body ", body, ", which does not exist"});
}

KANEXPR_ENGINE void builder::effective_inertia(std::string_view of) {
  for (mechanics::body& b : m_.bodies)
    if (b.called.view() == of) {
      b.effective = true;
      return;
    }
  inspect_.fail({"effective_inertia refers to body ", of, ", which does not exist"});
}

KANEXPR_ENGINE void builder::dependent(expression e) {
  if (!inspect_.own(e, "the argument of dependent")) return;
  const int q = m_.coordinates.find(e), u = m_.speeds.find(e);
  base::sequence<int>& places =
      q >= 0 ? system_.constraints.dependent_coordinates : system_.constraints.dependent_speeds;
  const int at = q >= 0 ? q : u;
  if (at < 0)
    inspect_.fail({"the argument of dependent is neither a coordinate nor a speed"});
  else if (places.contains(at))
    inspect_.fail({m_.g->symbol_at(e.node()).called.view(), " is declared dependent twice"});
  else
    places.push(at);
}

KANEXPR_ENGINE void builder::redundant(int configuration_constraint) {
  system_.constraints.redundant.push(configuration_constraint);
}

KANEXPR_ENGINE void builder::declare(frame_id frame, frame_id reference, const vector& value, bool apart) {
  constexpr std::string_view whose = "a declared angular velocity";
  if (!inspect_.present(frame, whose) || !inspect_.present(reference, whose)) return;
  if (frame == inertial_frame())
    inspect_.fail({"the inertial frame ", name_of(frame), " has a declared angular velocity"});
  else if (m_.frames[place(frame)].has_declared_angular_velocity())
    inspect_.fail({"frame ", name_of(frame), " has two declared angular velocities"});
  else if (inspect_.own(value, name_of(frame)))
    mechanics::declare_angular_velocity(m_, place(frame), place(reference), value, apart);
}

KANEXPR_ENGINE bool builder::new_frame(std::string_view called, frame_id parent) {
  return inspect_.fresh("frames", called, m_.frames) && inspect_.present(parent, called);
}

KANEXPR_ENGINE bool builder::unsaid_motion(point_id p) {
  if (!inspect_.present(p, "a declared motion")) return false;
  const mechanics::point& at = m_.points[place(p)];
  if (at.parent == mechanics::none)
    return inspect_.fail(
        {"point ", name_of(p), " is an origin, fixed in the inertial frame, but has a declared motion"});
  if (at.fixed_in != mechanics::none || at.has_declared_velocity())
    return inspect_.fail({"point ", name_of(p), " has two declared motions"});
  return true;
}

KANEXPR_ENGINE bool builder::may_move(point_id point, frame_id reference, const vector& velocity) {
  return inspect_.present(reference, "a declared velocity") && unsaid_motion(point) &&
         inspect_.own(velocity, name_of(point));
}

KANEXPR_ENGINE frame_id builder::by_sequence(std::string_view called, frame_id parent,
                                             std::string_view letters,
                                             const base::sequence<expression>& angles, bool space_fixed) {
  if (!new_frame(called, parent) || !inspect_.own(angles, called)) return {};
  if (!mechanics::is_sequence(letters)) {
    inspect_.fail({"frame ", called, " is rotated by the sequence ", letters,
                   ", which is invalid; use three axes, no two consecutive ones equal"});
    return {};
  }
  return frame_id{mechanics::add_frame_by_sequence(m_, called, place(parent), letters, angles, space_fixed)};
}

} // namespace kanexpr::runtime

namespace kanexpr {

KANEXPR_ENGINE model derive(const runtime::builder& built) {
  return model(
      std::make_shared<runtime::derived_from_builder>(built.graph_, built.system(), (built.check)()));
}

KANEXPR_ENGINE model runtime::derive_in_own_graph(const builder& built) {
  const auto own = std::make_shared<symbolic::graph>();
  mechanics::multibody_system system(built.system());
  move_to(*own, system);
  return model(std::make_shared<derived_from_builder>(own, system, (built.check)()));
}

} // namespace kanexpr
