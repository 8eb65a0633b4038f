#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/mechanics/checks/check.hpp>
#include <kanexpr/mechanics/checks/check_units.hpp>
#include <kanexpr/mechanics/model/central_inertia.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/frames.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/mechanics/skeleton/orientation_kinematics.hpp>
#include <kanexpr/mechanics/units/unit_inference.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/derived.ipp>
#include <kanexpr/runtime/system_expressions.ipp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <memory>
#include <optional>
#include <string_view>

namespace kanexpr::runtime {

KANEXPR_ENGINE builder::builder(std::string_view inertial_frame) : system_(*graph_), checks_(m_) {
  checks_.is_new("frames", inertial_frame, m_.frames);
  mechanics::add_inertial_frame(m_, inertial_frame);
}

KANEXPR_ENGINE sentence(builder::check)() const {
  if (mistake()) return mistake();
  sentence found = mechanics::check_system(system_);
  if (!found && m_.state_variables != 0) found = mechanics::check_state_rates(m_, system_.loads.state_rates);
  if (!found) found = check_unused_symbols(system_, used_elsewhere_);
  return found ? found : mechanics::check_units(system_);
}

KANEXPR_ENGINE mechanics::unit_table builder::units() const { return mechanics::unit_table_of(system_); }

KANEXPR_ENGINE mechanics::possible_unit builder::unit_of(expression e) const {
  if (!e.belongs_to(*graph_)) return std::nullopt;
  mechanics::unit_inference inferred(m_);
  mechanics::system_units(system_, inferred).state();
  return inferred.unit_of(e);
}

// ---- scalars

KANEXPR_ENGINE void builder::used_elsewhere(expression parameter_or_input) {
  if (m_.parameters.contains(parameter_or_input) || m_.inputs.contains(parameter_or_input))
    used_elsewhere_.push(parameter_or_input);
  else
    checks_.fail({"the argument of used_elsewhere is neither a parameter nor an input"});
}

KANEXPR_ENGINE expression builder::prescribed(std::string_view r) {
  base::name called = r;
  const expression value = input(r);
  expression last = value;
  for (int order = 1; order <= 2; ++order) {
    called.append("'");
    checks_.is_unused(called.view());
    const expression rate = m_.input(called);
    m_.prescribed_rates.push({last, rate});
    last = rate;
  }
  return value;
}

KANEXPR_ENGINE void builder::rates_as_speeds() {
  m_.derived_by = mechanics::method::lagrange;
  checks_.is_before_state_variables("the rates of the coordinates are");
  m_.take_rates_as_speeds();
}

KANEXPR_ENGINE void builder::lagrangian(expression energy) {
  if (!checks_.owns("the Lagrangian", energy)) return;
  system_.loads.has_lagrangian = true;
  system_.loads.lagrangian = energy;
}

KANEXPR_ENGINE expression builder::number(given_number value) {
  if (value.is_whole_zero()) checks_.fail_integer_zero("the argument of number is 0");
  if (!symbolic::is_finite(value.value())) checks_.fail({"the argument of number is not finite"});
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
  checks_.fail({"the argument of dot is not a coordinate, speed or prescribed quantity"});
  return m_.zero();
}

KANEXPR_ENGINE void builder::dynamics(expression state_variable, expression rate) {
  const int speed = state_variable.belongs_to(*graph_) ? m_.speeds.find(state_variable) : -1;
  if (speed < m_.speeds_of_motion()) {
    checks_.fail({"the first argument of dynamics is not a state variable"});
    return;
  }
  if (!checks_.owns("the rate of a state variable", rate)) return;
  const mechanics::solved_state_rate solved =
      mechanics::solve_for_state_rate(m_, speed, m_.speed_rates[speed] - rate);
  if (solved.mistake)
    checks_.fail({solved.mistake.view()});
  else
    system_.loads.state_rates.push(solved.found);
}

KANEXPR_ENGINE void builder::kinematics_of(frame_id frame, frame_id reference) {
  if (!checks_.owns("kinematics_of", frame, reference)) return;
  if (const sentence found = mechanics::check_orientation_kinematics(m_, place(frame), place(reference))) {
    checks_.fail({found.view()});
    return;
  }
  for (const expression& e : mechanics::orientation_kinematics(m_, place(frame), place(reference)))
    m_.kinematics.push(e);
}

// ---- vectors and dyadics

KANEXPR_ENGINE expression builder::as_expression(const number_or_expression& given) {
  if (const given_number* value = std::get_if<given_number>(&given.held())) return number(value->value());
  return std::get<expression>(given.held());
}

KANEXPR_ENGINE expression builder::as_nonzero(const number_or_expression& given, std::string_view what) {
  if (given.is_whole_zero()) checks_.fail_integer_zero(sentence({what, " is 0"}).view());
  return as_expression(given);
}

KANEXPR_ENGINE bool builder::not_all_zero(std::initializer_list<const number_or_expression*> given,
                                          std::string_view whose) {
  for (const number_or_expression* each : given)
    if (!each->is_whole_zero()) return true;
  return checks_.fail_integer_zero(whose);
}

KANEXPR_ENGINE vector builder::along(frame_id axes, const number_or_expression& x,
                                     const number_or_expression& y, const number_or_expression& z) {
  vector v;
  if (!not_all_zero({&x, &y, &z}, "every component of a vector is 0")) return v;
  const mechanics::components value{as_expression(x), as_expression(y), as_expression(z)};
  if (checks_.owns("a vector", axes, value)) v.add(place(axes), value);
  return v;
}

KANEXPR_ENGINE expression builder::dot(const vector& a, const vector& b) {
  return checks_.owns("a dot product", a, b) ? derivation::dot(m_, a, b) : m_.zero();
}

KANEXPR_ENGINE dyadic builder::inertia(frame_id axes, const number_or_expression& xx,
                                       const number_or_expression& yy, const number_or_expression& zz,
                                       const number_or_expression& xy, const number_or_expression& yz,
                                       const number_or_expression& zx) {
  if (!not_all_zero({&xx, &yy, &zz, &xy, &yz, &zx}, "every entry of an inertia is 0")) return {};
  mechanics::symmetric scalars;
  scalars.xx = as_expression(xx), scalars.yy = as_expression(yy), scalars.zz = as_expression(zz);
  scalars.xy = as_expression(xy), scalars.yz = as_expression(yz), scalars.zx = as_expression(zx);
  const dyadic d = mechanics::dyadic_of(place(axes), scalars);
  return checks_.owns("an inertia", d) ? d : dyadic{};
}

// ---- frames

KANEXPR_ENGINE frame_id builder::rotated(std::string_view called, frame_id parent, expression angle,
                                         const vector& axis) {
  if (!is_new_frame(called, parent, angle, axis)) return {};
  const mechanics::components a = mechanics::express(m_, axis, place(parent));
  if (a.is_zero())
    checks_.fail({"frame ", called, " is rotated about an axis of zero length"});
  else if (!mechanics::is_fixed(a))
    checks_.fail({"frame ", called, " is rotated about an axis that is not fixed in ", name_of(parent)});
  else
    return frame_id{mechanics::add_rotated_frame(m_, called, place(parent), angle, a)};
  return {};
}

KANEXPR_ENGINE frame_id builder::rotated_by_sequence(std::string_view called, frame_id parent,
                                                     std::string_view letters,
                                                     const base::sequence<expression>& angles,
                                                     bool space_fixed) {
  if (!is_new_frame(called, parent, angles)) return {};
  if (!mechanics::is_sequence(letters)) {
    checks_.fail({"frame ", called, " is rotated by the sequence ", letters,
                  ", which is invalid; use three axes, no two consecutive ones equal"});
    return {};
  }
  return frame_id{mechanics::add_frame_by_sequence(m_, called, place(parent), letters, angles, space_fixed)};
}

KANEXPR_ENGINE frame_id builder::quaternion(std::string_view called, frame_id parent, expression e0,
                                            expression e1, expression e2, expression e3) {
  if (!is_new_frame(called, parent, e0, e1, e2, e3)) return {};
  return frame_id{mechanics::add_frame_by_quaternion(m_, called, place(parent), e0, e1, e2, e3)};
}

KANEXPR_ENGINE frame_id builder::modified_rodrigues(std::string_view called, frame_id parent, expression s1,
                                                    expression s2, expression s3) {
  if (!is_new_frame(called, parent, s1, s2, s3)) return {};
  return frame_id{mechanics::add_frame_by_modified_rodrigues(m_, called, place(parent), {s1, s2, s3})};
}

KANEXPR_ENGINE frame_id builder::direction_cosines(std::string_view called, frame_id parent,
                                                   const mechanics::matrix3& to_parent) {
  if (!is_new_frame(called, parent, to_parent)) return {};
  return frame_id{mechanics::add_frame_by_matrix(m_, called, place(parent), to_parent)};
}

KANEXPR_ENGINE void builder::declare_angular_velocity(frame_id frame, frame_id reference, const vector& value,
                                                      bool apart) {
  if (!checks_.owns("a declared angular velocity", frame, reference)) return;
  if (frame == inertial_frame())
    checks_.fail({"the inertial frame ", name_of(frame), " has a declared angular velocity"});
  else if (m_.frames[place(frame)].has_declared_angular_velocity())
    checks_.fail({"frame ", name_of(frame), " has two declared angular velocities"});
  else if (checks_.owns(name_of(frame), value))
    m_.frames[place(frame)].declare_angular_velocity(place(reference), value, apart);
}

// ---- points

KANEXPR_ENGINE point_id builder::origin(std::string_view called) {
  return checks_.is_new("points", called, m_.points) ? point_id{m_.points.push({.called = called})}
                                                     : point_id{};
}

KANEXPR_ENGINE point_id builder::offset(std::string_view called, point_id parent, const vector& from_parent) {
  if (!checks_.is_new("points", called, m_.points) || !checks_.owns(called, parent, from_parent)) return {};
  return point_id{m_.points.push({.called = called, .parent = place(parent), .offset = from_parent})};
}

KANEXPR_ENGINE void builder::fixed_in(point_id point, frame_id frame) {
  if (checks_.owns("a fixed point", frame) && is_motion_undeclared(point))
    m_.points[place(point)].fixed_in = place(frame);
}

KANEXPR_ENGINE vector builder::position_of(point_id point, point_id from) {
  if (!checks_.owns("a position", point, from)) return {};
  if (const sentence unknown = mechanics::check_position(m_, place(point), place(from))) {
    checks_.fail({unknown.view()});
    return {};
  }
  return mechanics::position_from(m_, place(from), place(point));
}

KANEXPR_ENGINE bool builder::is_motion_undeclared(point_id p) {
  if (!checks_.owns("a declared motion", p)) return false;
  const mechanics::point& at = m_.points[place(p)];
  if (at.parent == mechanics::none)
    return checks_.fail(
        {"point ", name_of(p), " is an origin, fixed in the inertial frame, but has a declared motion"});
  if (at.fixed_in != mechanics::none || at.has_declared_velocity())
    return checks_.fail({"point ", name_of(p), " has two declared motions"});
  return true;
}

KANEXPR_ENGINE bool builder::may_declare_velocity(point_id point, frame_id reference,
                                                  const vector& velocity) {
  return checks_.owns("a declared velocity", reference) && is_motion_undeclared(point) &&
         checks_.owns(name_of(point), velocity);
}

KANEXPR_ENGINE void builder::velocity(point_id point, frame_id reference, const vector& value) {
  if (may_declare_velocity(point, reference, value))
    m_.points[place(point)].declare_velocity(place(reference), value,
                                             place(reference) != mechanics::mechanism::inertial);
}

KANEXPR_ENGINE void builder::velocity_apart_from_position(point_id point, frame_id reference,
                                                          const vector& value) {
  if (!may_declare_velocity(point, reference, value)) return;
  m_.points[place(point)].declare_velocity(place(reference), value,
                                           place(reference) != mechanics::mechanism::inertial);
  m_.points[place(point)].moves_apart = true;
}

KANEXPR_ENGINE void builder::velocity_from_parent(point_id point, frame_id reference, const vector& value) {
  if (may_declare_velocity(point, reference, value))
    m_.points[place(point)].declare_velocity(place(reference), value, true);
}

// ---- bodies

KANEXPR_ENGINE bool builder::is_new_body(std::string_view called) {
  return checks_.is_new("bodies", called, m_.bodies) && checks_.is_new("bodies", called, m_.flexible_bodies);
}

KANEXPR_ENGINE void builder::particle(std::string_view called, point_id at, expression mass) {
  if (is_new_body(called) && checks_.owns(called, at, mass))
    m_.bodies.push({.called = called, .center = place(at), .mass = mass});
}

KANEXPR_ENGINE void builder::rigid_body(std::string_view called, point_id center, frame_id frame,
                                        expression mass, const dyadic& inertia, point_id about) {
  if (is_new_body(called) && checks_.owns(called, center, frame, mass, inertia, about))
    m_.bodies.push({.called = called,
                    .center = place(center),
                    .frame = place(frame),
                    .mass = mass,
                    .inertia = inertia,
                    .about = place(about)});
}

KANEXPR_ENGINE void builder::mark_body(std::string_view body, bool mechanics::body::* mark,
                                       std::string_view whose) {
  for (mechanics::body& b : m_.bodies)
    if (b.called.view() == body) {
      b.*mark = true;
      return;
    }
  checks_.fail({whose, " refers to body ", body, ", which does not exist"});
}

KANEXPR_ENGINE void builder::changing_inertia(std::string_view body) {
  mark_body(body, &mechanics::body::inertia_changes, "changing_inertia");
}

KANEXPR_ENGINE void builder::effective_inertia(std::string_view body) {
  mark_body(body, &mechanics::body::effective, "effective_inertia");
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
  copy_to_graph(*own, system);
  return model(std::make_shared<derived_from_builder>(own, system, (built.check)()));
}

} // namespace kanexpr
