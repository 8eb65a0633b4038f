#pragma once

#include <kanexpr/mechanics/checks/check.hpp>
#include <kanexpr/mechanics/checks/check_torsional_spring.hpp>
#include <kanexpr/mechanics/model/bodies.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/frames.hpp>
#include <kanexpr/mechanics/model/loads.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/model/points.hpp>
#include <kanexpr/mechanics/skeleton/orientation_kinematics.hpp>
#include <kanexpr/runtime/inspector.hpp>

namespace kanexpr::runtime {

/// Builds a mechanism from values while the program runs. It owns the expressions and stays where it was
/// made.
///
/// A mistake does not stop the program: the first one is kept as a sentence, and what was wrong is left out.
/// Ask `check()` before deriving anything. `mechanics::equations derived(b.mechanism());` then knows the
/// velocities of which constraints may speak, and `derived.constrain();` takes the constraints up.
class builder {
public:
  explicit builder(std::string_view inertial_frame) : m_(graph_), inspect_(m_) {
    inspect_.fresh("frames", inertial_frame, m_.frames);
    mechanics::add_inertial_frame(m_, inertial_frame);
  }
  builder(const builder&) = delete;
  builder& operator=(const builder&) = delete;

  /// The first mistake made while building, or else the first that the mechanism holds; empty: none.
  problem(check)() const { return mistake() ? mistake() : mechanics::check_mechanism(m_); }
  const problem& mistake() const { return inspect_.mistake(); }

  const mechanics::mechanism& mechanism() const { return m_; }
  symbolic::graph& graph() { return graph_; }

  // ---- scalars

  expression coordinate(std::string_view q) { return inspect_.fresh_symbol(q), m_.coordinate(q); }
  expression speed(std::string_view u) { return inspect_.fresh_symbol(u), m_.speed(u); }
  expression parameter(std::string_view p) { return inspect_.fresh_symbol(p), m_.parameter(p); }
  expression input(std::string_view r) { return inspect_.fresh_symbol(r), m_.input(r); }
  /// A quantity that is known as a function of time: three inputs in a row, r, dot(r) and dot(dot(r)).
  expression prescribed(std::string_view r) {
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
  /// A speed that is zero at all times and brings out a force that does no work.
  expression auxiliary_speed(std::string_view u) { return inspect_.fresh_symbol(u), m_.auxiliary_speed(u); }
  /// Lagrange's method: the rates of the coordinates, which are there already, take the place of speeds.
  void rates_as_speeds() {
    m_.derived_by = mechanics::method::lagrange;
    m_.take_rates_as_speeds();
  }
  /// In place of bodies, after `rates_as_speeds`.
  void lagrangian(expression energy) {
    if (!inspect_.own(energy, "the Lagrangian")) return;
    m_.has_lagrangian = true;
    m_.lagrangian = energy;
  }
  expression time() { return inspect_.take_time(), m_.time; }
  expression number(double value) {
    if (!symbolic::is_finite(value)) inspect_.fail({"a number is given that is not finite"});
    return m_.number(value);
  }

  /// The rate of a coordinate, speed or prescribed quantity.
  expression dot(expression e) {
    if (e.lives_in(graph_)) {
      if (const int q = m_.coordinates.find(e); q >= 0)
        return m_.derived_by == mechanics::method::lagrange ? m_.speeds[q] : m_.coordinate_rates[q];
      if (const int u = m_.speeds.find(e); u >= 0) return m_.speed_rates[u];
      for (const mechanics::prescribed_rate& p : m_.prescribed_rates)
        if (p.quantity == e) return p.rate;
    }
    inspect_.fail(
        {"the rate of something is asked for that is not a coordinate, speed or prescribed quantity"});
    return m_.zero();
  }

  /// An expression that vanishes, linear in the rates of the coordinates: `dot(q) - u`.
  void kinematic_equation(expression vanishes) {
    if (inspect_.own(vanishes, "a kinematic differential equation")) m_.kinematics.push(vanishes);
  }
  /// The equations that say that the angular velocity of a frame which follows from its orientation is the
  /// one that was declared.
  void kinematics_of(frame_id frame, frame_id reference) {
    constexpr std::string_view whose = "kinematics_of";
    if (!inspect_.present(frame, whose) || !inspect_.present(reference, whose)) return;
    if (const problem found = mechanics::check_orientation_kinematics(m_, place(frame), place(reference))) {
      inspect_.fail({found.view()});
      return;
    }
    for (const expression& e : mechanics::orientation_kinematics(m_, place(frame), place(reference)))
      m_.kinematics.push(e);
  }

  // ---- vectors and dyadics

  vector along(frame_id axes, expression x, expression y, expression z) {
    vector v;
    const mechanics::components value{x, y, z};
    if (inspect_.present(axes, "a vector") && inspect_.own(value, "a vector")) v.add(place(axes), value);
    return v;
  }
  vector along(frame_id axes, double x, double y, double z) {
    return along(axes, number(x), number(y), number(z));
  }

  /// Inertia scalars in the axes of a frame; products with the sign of Σ m (r·r E − r r).
  dyadic inertia(frame_id axes, expression xx, expression yy, expression zz, expression xy, expression yz,
                 expression zx) {
    mechanics::symmetric scalars;
    scalars.xx = xx, scalars.yy = yy, scalars.zz = zz;
    scalars.xy = xy, scalars.yz = yz, scalars.zx = zx;
    const dyadic d = mechanics::dyadic_of(place(axes), scalars);
    return inspect_.own(d, "an inertia") ? d : dyadic{};
  }
  dyadic inertia(frame_id axes, expression xx, expression yy, expression zz) {
    return inertia(axes, xx, yy, zz, m_.zero(), m_.zero(), m_.zero());
  }

  // ---- frames

  static constexpr frame_id inertial_frame() { return frame_id{mechanics::mechanism::inertial}; }

  /// Turned by `angle` about an axis that is fixed in the parent.
  frame_id rotated(std::string_view called, frame_id parent, expression angle, const vector& axis) {
    if (!new_frame(called, parent) || !inspect_.own(angle, called) || !inspect_.own(axis, called)) return {};
    const mechanics::components a = mechanics::express(m_, axis, place(parent));
    if (a.is_zero())
      inspect_.fail({"frame ", called, " is turned about an axis of no length"});
    else if (!mechanics::is_fixed(a))
      inspect_.fail({"frame ", called, " is turned about an axis that is not fixed in ", name_of(parent)});
    else
      return frame_id{mechanics::add_rotated_frame(m_, called, place(parent), angle, a)};
    return {};
  }
  frame_id body_fixed(std::string_view called, frame_id parent, std::string_view letters, expression first,
                      expression second, expression third) {
    return by_sequence(called, parent, letters, {first, second, third}, false);
  }
  frame_id space_fixed(std::string_view called, frame_id parent, std::string_view letters, expression first,
                       expression second, expression third) {
    return by_sequence(called, parent, letters, {first, second, third}, true);
  }
  /// Turned by the unit quaternion e0 + e1 i + e2 j + e3 k.
  frame_id quaternion(std::string_view called, frame_id parent, expression e0, expression e1, expression e2,
                      expression e3) {
    if (!new_frame(called, parent) || !inspect_.own({e0, e1, e2, e3}, called)) return {};
    return frame_id{mechanics::add_frame_by_quaternion(m_, called, place(parent), e0, e1, e2, e3)};
  }
  /// v in the parent's axes = to_parent · v in the frame's axes.
  frame_id direction_cosines(std::string_view called, frame_id parent, const mechanics::matrix3& to_parent) {
    if (!new_frame(called, parent) || !inspect_.own(to_parent, called)) return {};
    return frame_id{mechanics::add_frame_by_matrix(m_, called, place(parent), to_parent)};
  }
  /// The angular velocity of a frame in another one, used in place of the derived one. It is that of the
  /// orientation, or that and the spin about an axis by an angle which the orientation leaves out.
  void angular_velocity(frame_id frame, frame_id reference, const vector& value) {
    declare(frame, reference, value, false);
  }
  /// The same of a frame whose orientation does not follow its angular velocity, on purpose.
  void angular_velocity_apart_from_orientation(frame_id frame, frame_id reference, const vector& value) {
    declare(frame, reference, value, true);
  }

  // ---- points

  /// A point that is fixed in the inertial frame.
  point_id origin(std::string_view called) {
    if (!inspect_.fresh("points", called, m_.points)) return {};
    return point_id{mechanics::add_origin(m_, called)};
  }
  point_id offset(std::string_view called, point_id parent, const vector& from_parent) {
    if (!inspect_.fresh("points", called, m_.points) || !inspect_.present(parent, called) ||
        !inspect_.own(from_parent, called))
      return {};
    return point_id{mechanics::add_point(m_, called, place(parent), from_parent)};
  }
  /// The two-point theorem: the point and its parent are both fixed in `frame`.
  void fixed_in(point_id point, frame_id frame) {
    if (inspect_.present(frame, "a fixed point") && unsaid_motion(point))
      mechanics::fix_point(m_, place(point), place(frame));
  }
  /// The velocity of a point in `reference`, used in place of the derived one.
  void velocity(point_id point, frame_id reference, const vector& value) {
    if (inspect_.present(reference, "a declared velocity") && unsaid_motion(point) &&
        inspect_.own(value, name_of(point)))
      mechanics::declare_velocity(m_, place(point), place(reference), value);
  }

  // ---- bodies and loads

  void particle(std::string_view called, point_id at, expression mass) {
    if (inspect_.fresh("bodies", called, m_.bodies) && inspect_.present(at, called) &&
        inspect_.own(mass, called))
      mechanics::add_particle(m_, called, place(at), mass);
  }
  void rigid_body(std::string_view called, point_id center, frame_id frame, expression mass,
                  const dyadic& inertia) {
    rigid_body(called, center, frame, mass, inertia, center);
  }
  /// With the inertia about any other point of the body.
  void rigid_body(std::string_view called, point_id center, frame_id frame, expression mass,
                  const dyadic& inertia, point_id about) {
    if (inspect_.fresh("bodies", called, m_.bodies) && inspect_.present(center, called) &&
        inspect_.present(frame, called) && inspect_.own(mass, called) && inspect_.own(inertia, called) &&
        inspect_.present(about, called))
      mechanics::add_rigid_body(m_, called, place(center), place(frame), mass, inertia, place(about));
  }
  /// The inertia of a rigid body is not the same at all times as the body sees it, on purpose.
  void changing_inertia(std::string_view body) {
    for (mechanics::body& b : m_.bodies)
      if (b.called.view() == body) {
        b.inertia_changes = true;
        return;
      }
    inspect_.fail({"changing_inertia names ", body, ", and there is no such body"});
  }
  /// Of a body with an inertia that no distribution of mass has, on purpose.
  void effective_inertia(std::string_view of) {
    for (mechanics::body& b : m_.bodies)
      if (b.called.view() == of) {
        b.effective = true;
        return;
      }
    inspect_.fail({"there is no body ", of, " whose inertia could be an effective one"});
  }
  void force(point_id at, const vector& value) {
    if (inspect_.present(at, "a force") && inspect_.own(value, "a force"))
      mechanics::add_force(m_, place(at), value);
  }
  void torque(frame_id on, const vector& value) {
    if (inspect_.present(on, "a torque") && inspect_.own(value, "a torque"))
      mechanics::add_torque(m_, place(on), value);
  }
  /// A force on a point, and the opposite on another.
  void force_between(point_id at, point_id other, const vector& value) {
    if (both(at, other, "a force") && inspect_.own(value, "a force"))
      mechanics::add_force(m_, place(at), value, place(other));
  }
  /// A torque on a frame, and the opposite on another.
  void torque_between(frame_id on, frame_id other, const vector& value) {
    if (both(on, other, "a torque") && inspect_.own(value, "a torque"))
      mechanics::add_torque(m_, place(on), value, place(other));
  }
  /// The acceleration of free fall of every body.
  void gravity(const vector& acceleration) {
    if (m_.has_gravity)
      inspect_.fail({"gravity is given twice"});
    else if (inspect_.own(acceleration, "gravity"))
      mechanics::set_gravity(m_, acceleration);
  }
  /// Of coordinates, parameters, time and inputs.
  void potential_energy(expression energy) {
    if (!inspect_.own(energy, "a potential energy")) return;
    if (energy.is_zero()) inspect_.fail({"a potential energy is zero; 1/2 of whole numbers is 0 in C++"});
    m_.potential_energies.push(energy);
  }
  /// A straight spring, which pulls two points to each other with stiffness·(distance − natural length).
  void spring(point_id at, point_id other, expression stiffness, expression natural_length) {
    if (both(at, other, "a spring") && inspect_.own({stiffness, natural_length}, "a spring"))
      mechanics::add_spring(m_, place(at), place(other), stiffness, natural_length);
  }
  void spring(point_id at, point_id other, expression stiffness) { spring(at, other, stiffness, m_.zero()); }
  /// Pulls two points to each other with damping·(rate of their distance).
  void damper(point_id at, point_id other, expression damping) {
    if (both(at, other, "a damper") && inspect_.own(damping, "a damper"))
      mechanics::add_damper(m_, place(at), place(other), damping);
  }
  /// Turns an angle back to where it is at rest, with stiffness·(angle − rest).
  void torsional_spring(expression angle, expression stiffness, expression rest) {
    constexpr std::string_view whose = "a torsional spring";
    if (!inspect_.own(angle, whose) || !inspect_.own({stiffness, rest}, whose)) return;
    if (const problem found = mechanics::check_torsional_spring(m_, angle, stiffness, rest, whose))
      inspect_.fail({found.view()});
    else
      mechanics::add_torsional_spring(m_, angle, stiffness, rest);
  }
  void torsional_spring(expression angle, expression stiffness) {
    torsional_spring(angle, stiffness, m_.zero());
  }
  /// A torque −damping·ω on a frame that turns with ω in another, and the opposite on that.
  void torsional_damper(frame_id on, frame_id other, expression damping) {
    if (both(on, other, "a torsional damper") && inspect_.own(damping, "a torsional damper"))
      mechanics::add_torsional_damper(m_, place(on), place(other), damping);
  }

  // ---- constraints; what vanishes may hold velocities that `mechanics::equations` knew before

  /// An expression of the coordinates that vanishes.
  void configuration_constraint(expression vanishes) {
    if (inspect_.own(vanishes, "a configuration constraint")) m_.configuration_constraints.push(vanishes);
  }
  /// An expression that vanishes, linear in speeds or rates of coordinates.
  void velocity_constraint(expression vanishes) {
    if (inspect_.own(vanishes, "a velocity constraint")) m_.velocity_constraints.push({vanishes, {}, {}});
  }
  /// A velocity that vanishes along a direction.
  void velocity_constraint(const vector& vanishing, const vector& direction) {
    constexpr std::string_view whose = "a velocity constraint";
    if (!inspect_.own(vanishing, whose) || !inspect_.own(direction, whose)) return;
    if (direction.is_zero()) {
      inspect_.fail({whose, " is given a direction of no length"});
      return;
    }
    const int axes = direction.parts[0].frame;
    const expression value =
        mechanics::dot(mechanics::express(m_, vanishing, axes), mechanics::express(m_, direction, axes));
    m_.velocity_constraints.push({value, vanishing, direction});
  }
  /// An expression that vanishes, linear in the rates of the speeds: `dot(u1) + dot(u2)`.
  void acceleration_constraint(expression vanishes) {
    if (inspect_.own(vanishes, "an acceleration constraint")) m_.acceleration_constraints.push(vanishes);
  }
  /// A coordinate or speed that the constraints are to be solved for.
  void dependent(expression e) {
    if (!inspect_.own(e, "what is dependent")) return;
    const int q = m_.coordinates.find(e), u = m_.speeds.find(e);
    symbolic::sequence<int>& places = q >= 0 ? m_.dependent_coordinates : m_.dependent_speeds;
    const int at = q >= 0 ? q : u;
    if (at < 0)
      inspect_.fail({"dependent is given something that is neither a coordinate nor a speed"});
    else if (places.contains(at))
      inspect_.fail({m_.g->symbol_at(e.node()).called.view(), " is made dependent twice"});
    else
      places.push(at);
  }

private:
  void declare(frame_id frame, frame_id reference, const vector& value, bool apart) {
    constexpr std::string_view whose = "a declared angular velocity";
    if (!inspect_.present(frame, whose) || !inspect_.present(reference, whose)) return;
    if (frame == inertial_frame())
      inspect_.fail({"the inertial frame ", name_of(frame), " is given an angular velocity"});
    else if (m_.frames[place(frame)].turns_by_declaration())
      inspect_.fail({"frame ", name_of(frame), " is given two angular velocities"});
    else if (inspect_.own(value, name_of(frame)))
      mechanics::declare_angular_velocity(m_, place(frame), place(reference), value, apart);
  }

  std::string_view name_of(frame_id f) const { return m_.frames[place(f)].called.view(); }
  std::string_view name_of(point_id p) const { return m_.points[place(p)].called.view(); }

  template <class Id>
  bool both(Id first, Id second, std::string_view whom) {
    return inspect_.present(first, whom) && inspect_.present(second, whom);
  }

  bool new_frame(std::string_view called, frame_id parent) {
    return inspect_.fresh("frames", called, m_.frames) && inspect_.present(parent, called);
  }

  /// A point is given one motion.
  bool unsaid_motion(point_id p) {
    if (!inspect_.present(p, "a declared motion")) return false;
    const mechanics::point& at = m_.points[place(p)];
    if (at.parent == mechanics::none)
      return inspect_.fail(
          {"point ", name_of(p), " is an origin, fixed in the inertial frame, and is given a motion"});
    if (at.fixed_in != mechanics::none || at.moves_by_declaration())
      return inspect_.fail({"point ", name_of(p), " is given two motions"});
    return true;
  }

  frame_id by_sequence(std::string_view called, frame_id parent, std::string_view letters,
                       const symbolic::sequence<expression>& angles, bool space_fixed) {
    if (!new_frame(called, parent) || !inspect_.own(angles, called)) return {};
    if (!mechanics::is_sequence(letters)) {
      inspect_.fail({"frame ", called, " is turned by the sequence ", letters,
                     ", which is invalid: take three axes, no two neighbours alike"});
      return {};
    }
    return frame_id{
        mechanics::add_frame_by_sequence(m_, called, place(parent), letters, angles, space_fixed)};
  }

  symbolic::graph graph_;
  mechanics::mechanism m_;
  inspector inspect_;
};

} // namespace kanexpr::runtime
