// Builds a recipe as a mechanism of the library at run time, and evaluates its equations.
#pragma once

#include "numbers_of.hpp"
#include "recipe.hpp"

#include <Eigen/Core>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/runtime/builder.hpp>

namespace recipe {

using kanexpr::mechanics::components;
using kanexpr::mechanics::matrix3;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::point_id;
using kanexpr::symbolic::expression;

inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Builds as a user would, through the public interface.
class building {
public:
  building(const mechanism& from, builder& into) : from_(from), b_(into) {
    symbols();
    for (std::size_t i = 1; i < from.frames.size(); ++i) add(from.frames[i], "F" + std::to_string(i));
    for (std::size_t i = 0; i < from.points.size(); ++i) add(from.points[i], "P" + std::to_string(i));
    for (std::size_t i = 0; i < from.bodies.size(); ++i) add(from.bodies[i], "B" + std::to_string(i));
    for (const load& f : from.forces) add_force(f);
    for (const load& t : from.torques) add_torque(t);
    for (const spring& s : from.springs) add(s);
    for (const damper& c : from.dampers)
      b_.torsional_damper(frames[at(c.frame)], frames[at(c.against)], now_(c.damping));
    for (const twist& s : from.twists) b_.torsional_spring(now_(s.angle), now_(s.stiffness), now_(s.rest));
    if (from.has_gravity)
      b_.gravity(
          b_.along(b_.inertial_frame(), now_(from.gravity[0]), now_(from.gravity[1]), now_(from.gravity[2])));
    for (const rates& k : from.kinematics) add(k);
  }

  kanexpr::runtime::vector vector(const sum& v) {
    kanexpr::runtime::vector total;
    for (const part& p : v)
      total.add(b_.along(frames[at(p.frame)], now_(p.value[0]), now_(p.value[1]), now_(p.value[2])));
    return total;
  }

  expression scalar(const formula& f) const { return now_(f); }
  expression speed(int i) const { return now_.u[at(i)]; }
  expression rate(int i) const { return now_.qdot[at(i)]; }

  std::vector<frame_id> frames{builder::inertial_frame()};
  std::vector<point_id> points;

private:
  void symbols() {
    now_.number = [this](double c) { return b_.number(c); };
    now_.t = b_.time();
    for (std::size_t i = 0; i < from_.q.size(); ++i) now_.q.push_back(b_.coordinate("q" + std::to_string(i)));
    for (const expression& q : now_.q) now_.qdot.push_back(b_.dot(q));
    for (std::size_t i = 0; i < from_.u.size(); ++i) now_.u.push_back(b_.speed("u" + std::to_string(i)));
    for (std::size_t i = 0; i < from_.r.size(); ++i) {
      now_.r.push_back(b_.input("r" + std::to_string(i)));
      b_.used_elsewhere(now_.r.back()); // or nowhere
    }
    for (std::size_t i = 0; i < from_.parameters.size(); ++i) {
      now_.parameters.push_back(b_.parameter("p" + std::to_string(i)));
      b_.used_elsewhere(now_.parameters.back()); // or nowhere
    }
  }

  matrix3 basis_rotation(char letter, expression angle) {
    const int a = letter - 'x', b = (a + 1) % 3, d = (a + 2) % 3;
    matrix3 r(b_.graph());
    r(a, a) = b_.number(1);
    r(b, b) = r(d, d) = cos(angle);
    r(d, b) = sin(angle);
    r(b, d) = -r(d, b);
    return r;
  }

  void add(const frame& f, const std::string& called) {
    const frame_id parent = frames[at(f.parent)];
    const expression a = now_(f.angle[0]), b = now_(f.angle[1]), c = now_(f.angle[2]);
    const std::size_t e = at(f.quaternion);
    double basis[3]{0, 0, 0};
    basis[f.axis] = f.backwards ? -1 : 1;
    switch (f.how) {
    case turn::ground: break;
    case turn::about_basis:
      frames.push_back(b_.rotated(called, parent, a, b_.along(parent, basis[0], basis[1], basis[2])));
      break;
    case turn::about_axis:
      frames.push_back(
          b_.rotated(called, parent, a,
                     b_.along(parent, now_(f.direction[0]), now_(f.direction[1]), now_(f.direction[2]))));
      break;
    case turn::body_fixed: frames.push_back(b_.body_fixed(called, parent, f.letters, a, b, c)); break;
    case turn::space_fixed: frames.push_back(b_.space_fixed(called, parent, f.letters, a, b, c)); break;
    case turn::cosines:
      frames.push_back(
          b_.direction_cosines(called, parent,
                               basis_rotation(f.letters[0], a) *
                                   (basis_rotation(f.letters[1], b) * basis_rotation(f.letters[2], c))));
      break;
    case turn::quaternion:
      frames.push_back(b_.quaternion(called, parent, now_.q[e], now_.q[e + 1], now_.q[e + 2], now_.q[e + 3]));
      break;
    }
    if (f.reference < 0) return;
    if (f.turns_apart)
      b_.angular_velocity_apart_from_orientation(frames.back(), frames[at(f.reference)],
                                                 vector(f.angular_velocity));
    else
      b_.angular_velocity(frames.back(), frames[at(f.reference)], vector(f.angular_velocity));
  }

  void add(const point& p, const std::string& called) {
    if (p.parent < 0) return points.push_back(b_.origin(called));
    points.push_back(b_.offset(called, points[at(p.parent)], vector(p.offset)));
    if (p.fixed_in >= 0) b_.fixed_in(points.back(), frames[at(p.fixed_in)]);
    if (p.reference < 0) return;
    if (p.moves_apart)
      b_.velocity_apart_from_position(points.back(), frames[at(p.reference)], vector(p.velocity));
    else
      b_.velocity(points.back(), frames[at(p.reference)], vector(p.velocity));
  }

  void add(const body& b, const std::string& called) {
    const point_id center = points[at(b.center)];
    if (b.frame < 0) return b_.particle(called, center, now_(b.mass));
    kanexpr::runtime::dyadic total;
    for (const inertia& i : b.dyadic)
      total.add(b_.inertia(frames[at(i.axes)], now_(i.scalars[0]), now_(i.scalars[1]), now_(i.scalars[2]),
                           now_(i.scalars[3]), now_(i.scalars[4]), now_(i.scalars[5])));
    if (b.about < 0)
      b_.rigid_body(called, center, frames[at(b.frame)], now_(b.mass), total);
    else
      b_.rigid_body(called, center, frames[at(b.frame)], now_(b.mass), total, points[at(b.about)]);
    if (b.inertia_changes) b_.changing_inertia(called);
    b_.effective_inertia(called); // random, and not the inertia of any mass distribution
  }

  void add_force(const load& f) {
    if (f.against < 0) return b_.force(points[at(f.on)], vector(f.value));
    b_.force_between(points[at(f.on)], points[at(f.against)], vector(f.value));
  }
  void add_torque(const load& t) {
    if (t.against < 0) return b_.torque(frames[at(t.on)], vector(t.value));
    b_.torque_between(frames[at(t.on)], frames[at(t.against)], vector(t.value));
  }
  void add(const spring& s) {
    const point_id point = points[at(s.point)], other = points[at(s.other)];
    if (s.stiffness.value != 0) b_.spring(point, other, now_(s.stiffness), now_(s.length));
    if (s.damping.value != 0) b_.damper(other, point, now_(s.damping));
  }

  void add(const rates& k) {
    const std::size_t n = k.speeds.size();
    const auto u = [&](std::size_t i) { return now_.u[at(k.speeds[i])]; };
    const auto q = [&](std::size_t i) { return now_.q[at(k.coordinates[i])]; };
    const auto dot = [&](std::size_t i) { return now_.qdot[at(k.coordinates[i])]; };
    switch (k.how) {
    case law::linear:
      for (std::size_t i = 0; i < n; ++i) {
        expression left = now_(k.offset[i]) - u(i);
        for (std::size_t j = 0; j < n; ++j) left += now_(k.matrix[i * n + j]) * dot(j);
        b_.kinematic_equation(left);
      }
      break;
    case law::body_rates: {
      const frame& f = from_.frames[at(k.frame)];
      components left(b_.graph()); // Σ axis_i q̇_i in the frame's axes, rotation by rotation
      for (std::size_t i = 0; i < 3; ++i) {
        left = transpose(basis_rotation(f.letters[i], q(i))) * left;
        left[f.letters[i] - 'x'] += dot(i);
      }
      for (int i = 0; i < 3; ++i) b_.kinematic_equation(left[i] - u(at(i)));
      break;
    }
    case law::quaternion:
      b_.kinematic_equation(2 * dot(0) + q(1) * u(0) + q(2) * u(1) + q(3) * u(2));
      b_.kinematic_equation(2 * dot(1) - q(0) * u(0) - q(2) * u(2) + q(3) * u(1));
      b_.kinematic_equation(2 * dot(2) - q(0) * u(1) - q(3) * u(0) + q(1) * u(2));
      b_.kinematic_equation(2 * dot(3) - q(0) * u(2) - q(1) * u(1) + q(2) * u(0));
      break;
    case law::implicit_quaternion:
      b_.kinematic_equation(2 * (q(0) * dot(1) - q(1) * dot(0) - q(2) * dot(3) + q(3) * dot(2)) - u(0));
      b_.kinematic_equation(2 * (q(0) * dot(2) - q(2) * dot(0) - q(3) * dot(1) + q(1) * dot(3)) - u(1));
      b_.kinematic_equation(2 * (q(0) * dot(3) - q(3) * dot(0) - q(1) * dot(2) + q(2) * dot(1)) - u(2));
      b_.kinematic_equation(q(0) * dot(0) + q(1) * dot(1) + q(2) * dot(2) + q(3) * dot(3));
      break;
    case law::base_velocity: {
      const auto& e = from_.frames[at(k.frame)];
      const std::size_t c = at(e.quaternion);
      const expression e0 = now_.q[c], e1 = now_.q[c + 1], e2 = now_.q[c + 2], e3 = now_.q[c + 3];
      const components v(u(0), u(1), u(2)), axis(e1, e2, e3);
      const components twice = b_.number(2) * cross(axis, v);
      const components turned = v + e0 * twice + cross(axis, twice);
      for (int i = 0; i < 3; ++i) b_.kinematic_equation(dot(at(i)) - turned[i]);
      break;
    }
    }
  }

  const mechanism& from_;
  builder& b_;
  values<expression> now_;
};

// The value of each entry of a matrix of expressions, at the recipe's state.
inline Eigen::MatrixXd number(const mechanism& m, const kanexpr::symbolic::matrix& wanted,
                              const std::vector<double>& udot = {}) {
  return numbers_of(wanted, [&](const kanexpr::lower::load& l) {
    using kanexpr::symbolic::symbol_kind;
    switch (l.from) {
    case symbol_kind::time: return m.t;
    case symbol_kind::coordinate: return m.q.at(at(l.position));
    case symbol_kind::speed: return m.u.at(at(l.position));
    case symbol_kind::parameter: return m.parameters.at(at(l.position));
    case symbol_kind::input: return m.r.at(at(l.position));
    case symbol_kind::speed_rate: return udot.at(at(l.position));
    case symbol_kind::coordinate_rate:
    case symbol_kind::auxiliary_speed:
    case symbol_kind::multiplier:
    case symbol_kind::weight:
    case symbol_kind::direction: break;
    }
    return std::numeric_limits<double>::quiet_NaN(); // q̇ and auxiliary speeds must not remain
  });
}

} // namespace recipe
