#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/describe/expression.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/runtime/inspector.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/graph/compose.hpp>

#include <concepts>
#include <memory>
#include <type_traits>
#include <variant>
#include <vector>

namespace kanexpr {

namespace runtime {
class builder;
}

/// Derives what was built so far; what is built afterwards does not change the model. A mistake of the
/// builder is one of the model.
KANEXPR_ENGINE model derive(const runtime::builder& built);

namespace runtime {

/// The same in a graph that is not the builder's: its expressions belong to the model alone, and are the same
/// in the programs of all compilers, whatever was derived before.
KANEXPR_ENGINE model derive_in_own_graph(const builder& built);

} // namespace runtime

} // namespace kanexpr

namespace kanexpr::runtime {

/// A number as it was given: to C++ 1/2 is the whole number 0, which nobody gives on purpose.
class given_number {
public:
  template <class Number>
    requires std::is_arithmetic_v<Number> && (!numeric::letter<Number>) // i == 0 is 1 or 0
  given_number(Number value)
      : value_(static_cast<double>(value)), is_whole_zero_(describe::is_whole_zero(value)) {}

  double value() const { return value_; }
  bool is_whole_zero() const { return is_whole_zero_; }

private:
  double value_;
  bool is_whole_zero_;
};

/// A number among expressions.
class number_or_expression {
public:
  template <class Number>
    requires std::is_arithmetic_v<Number> && (!numeric::letter<Number>)
  number_or_expression(Number value) : held_(given_number(value)) {}
  number_or_expression(expression e) : held_(e) {}

  const std::variant<given_number, expression>& held() const { return held_; }
  bool is_whole_zero() const {
    const given_number* const number = std::get_if<given_number>(&held_);
    return number != nullptr && number->is_whole_zero();
  }

private:
  std::variant<given_number, expression> held_;
};

/// A vector that has no part along some directions.
struct vanishing {
  vector value;
  std::vector<vector> directions;
};

/// Builds a system from values while the program runs. It stays where it was made; `derive(b)` gives a
/// model of it, with the results of a system that was described as types.
///
/// A mistake does not stop the program: the first one is kept as a sentence, and what was wrong is left out.
///
/// Loads and constraints may speak of velocities, which `mechanics::known_motion known(b.mechanism());` knows
/// once frames and points are there.
class builder {
public:
  explicit builder(std::string_view inertial_frame);
  builder(const builder&) = delete;
  builder& operator=(const builder&) = delete;

  /// The first mistake made while building, or else the first that the system holds; empty: none.
  sentence(check)() const;
  const sentence& mistake() const { return inspect_.mistake(); }

  const mechanics::multibody_system& system() const { return system_; }
  const mechanics::mechanism& mechanism() const { return system_.mechanism; }
  symbolic::graph& graph() { return *graph_; }

  // ---- scalars

  expression coordinate(std::string_view q);
  expression speed(std::string_view u);
  expression parameter(std::string_view p);
  expression input(std::string_view r);
  /// A quantity that is known as a function of time: three inputs in a row, r, dot(r) and dot(dot(r)).
  expression prescribed(std::string_view r);
  /// A parameter or an input is there for expressions that are asked for later: any other that nothing in the
  /// system uses is a mistake.
  void used_elsewhere(expression parameter_or_input);
  /// A speed that is zero at all times and brings out a force that does no work.
  expression auxiliary_speed(std::string_view u);
  /// Lagrange's method: the rates of the coordinates, which are there already, take the place of speeds.
  void rates_as_speeds();
  /// In place of bodies, after `rates_as_speeds`.
  void lagrangian(expression energy);
  expression time() { return inspect_.take_time(), m_.time; }
  /// 0.0 where it is 0.
  expression number(given_number value);

  /// The rate of a coordinate, speed or prescribed quantity.
  expression dot(expression e);

  /// An expression that vanishes, linear in the rates of the coordinates: `dot(q) - u`.
  void kinematic_equation(expression vanishes);
  /// The equations that say that the angular velocity of a frame which follows from its orientation is the
  /// one that was declared.
  void kinematics_of(frame_id frame, frame_id reference);

  // ---- vectors and dyadics

  /// By its components, numbers or expressions: `b.along(A, l, 0, 0)`. That of no length is `{}`.
  vector along(frame_id axes, const number_or_expression& x, const number_or_expression& y,
               const number_or_expression& z);
  expression dot(const vector& a, const vector& b);

  /// Inertia scalars in the axes of a frame; products with the sign of Σ m (r·r E − r r).
  dyadic inertia(frame_id axes, const number_or_expression& xx, const number_or_expression& yy,
                 const number_or_expression& zz, const number_or_expression& xy,
                 const number_or_expression& yz, const number_or_expression& zx);
  dyadic inertia(frame_id axes, const number_or_expression& xx, const number_or_expression& yy,
                 const number_or_expression& zz);

  // ---- frames

  static constexpr frame_id inertial_frame() { return frame_id{mechanics::mechanism::inertial}; }

  /// Turned by `angle` about an axis that is fixed in the parent.
  frame_id rotated(std::string_view called, frame_id parent, expression angle, const vector& axis);
  frame_id body_fixed(std::string_view called, frame_id parent, std::string_view letters, expression first,
                      expression second, expression third);
  frame_id space_fixed(std::string_view called, frame_id parent, std::string_view letters, expression first,
                       expression second, expression third);
  /// Turned by the unit quaternion e0 + e1 i + e2 j + e3 k.
  frame_id quaternion(std::string_view called, frame_id parent, expression e0, expression e1, expression e2,
                      expression e3);
  /// Turned by φ about the unit vector a, with the modified Rodrigues parameters a tan φ/4.
  frame_id modified_rodrigues(std::string_view called, frame_id parent, expression s1, expression s2,
                              expression s3);
  /// v in the parent's axes = to_parent · v in the frame's axes.
  frame_id direction_cosines(std::string_view called, frame_id parent, const mechanics::matrix3& to_parent);
  /// The angular velocity of a frame in another one, used in place of the derived one. It is that of the
  /// orientation, or that and the spin about an axis by an angle which the orientation leaves out.
  void angular_velocity(frame_id frame, frame_id reference, const vector& value);
  /// The same of a frame whose orientation does not follow its angular velocity, on purpose.
  void angular_velocity_apart_from_orientation(frame_id frame, frame_id reference, const vector& value);

  // ---- points

  /// A point that is fixed in the inertial frame.
  point_id origin(std::string_view called);
  point_id offset(std::string_view called, point_id parent, const vector& from_parent);
  /// The two-point theorem: the point and its parent are both fixed in `frame`.
  void fixed_in(point_id point, frame_id frame);
  /// The position of a point from another.
  vector position_of(point_id point, point_id from);
  /// The velocity of a point in `reference`, used in place of the derived one: in the inertial frame as it
  /// is, in any other with the motion of its parent, which is fixed there (one-point theorem).
  void velocity(point_id point, frame_id reference, const vector& value);
  /// The same of a point whose position does not follow its velocity, on purpose.
  void velocity_apart_from_position(point_id point, frame_id reference, const vector& value);
  /// `velocity` with the motion of the parent in any frame.
  void velocity_from_parent(point_id point, frame_id reference, const vector& value);

  // ---- bodies and loads

  void particle(std::string_view called, point_id at, expression mass);
  void rigid_body(std::string_view called, point_id center, frame_id frame, expression mass,
                  const dyadic& inertia);
  /// With the inertia about any other point of the body.
  void rigid_body(std::string_view called, point_id center, frame_id frame, expression mass,
                  const dyadic& inertia, point_id about);
  /// The inertia of a rigid body is not the same at all times as the body sees it, on purpose.
  void changing_inertia(std::string_view body);
  /// Of a body with an inertia that no distribution of mass has, on purpose.
  void effective_inertia(std::string_view of);
  void force(point_id at, const vector& value);
  void torque(frame_id on, const vector& value);
  /// A force on a point, and the opposite on another.
  void force_between(point_id at, point_id other, const vector& value);
  /// A torque on a frame, and the opposite on another.
  void torque_between(frame_id on, frame_id other, const vector& value);
  /// The acceleration of free fall of every body.
  void gravity(const vector& acceleration);
  /// Of coordinates, parameters, time and inputs.
  void potential_energy(expression energy);
  /// A straight spring, which pulls two points to each other with stiffness·(distance − natural length).
  void spring(point_id at, point_id other, expression stiffness, expression natural_length);
  void spring(point_id at, point_id other, expression stiffness);
  /// Pulls two points to each other with damping·(rate of their distance).
  void damper(point_id at, point_id other, expression damping);
  /// Turns an angle back to where it is at rest, with stiffness·(angle − rest).
  void torsional_spring(expression angle, expression stiffness, expression rest);
  void torsional_spring(expression angle, expression stiffness);
  /// A torque −damping·ω on a frame that turns with ω in another, and the opposite on that.
  void torsional_damper(frame_id on, frame_id other, expression damping);

  // ---- constraints; what vanishes may hold velocities of a `mechanics::known_motion`

  /// What one constraint along each direction says of a vector: `b.configuration_constraint(b.zero_along(
  /// b.position_of(P, Q), b.along(N, 1, 0, 0), b.along(N, 0, 1, 0)))`.
  template <std::same_as<vector>... Directions>
  static vanishing zero_along(const vector& v, const Directions&... directions) {
    return {v, {directions...}};
  }

  /// An expression of the coordinates that vanishes.
  void configuration_constraint(expression vanishes);
  /// A position that vanishes along each of some directions.
  void configuration_constraint(const vanishing& v);
  /// An expression that vanishes, linear in speeds or rates of coordinates.
  void velocity_constraint(expression vanishes);
  /// A velocity that vanishes along a direction.
  void velocity_constraint(const vector& vanishes, const vector& direction);
  /// The same along each of some directions.
  void velocity_constraint(const vanishing& v);
  /// An expression that vanishes, linear in the rates of the speeds: `dot(u1) + dot(u2)`.
  void acceleration_constraint(expression vanishes);
  /// A coordinate or speed that the constraints are to be solved for.
  void dependent(expression e);
  /// Configuration constraints are counted from 1 on; this one follows from the others wherever all hold.
  void redundant(int configuration_constraint);

private:
  friend model kanexpr::derive(const builder& built);

  expression of(const number_or_expression& given);
  /// Whether not all of some numbers are a whole 0.
  bool not_all_zero(std::initializer_list<const number_or_expression*> given, std::string_view whose);
  bool may_vanish(const vector& v, const vector& direction, std::string_view whose);
  void declare(frame_id frame, frame_id reference, const vector& value, bool apart);

  std::string_view name_of(frame_id f) const { return m_.frames[place(f)].called.view(); }
  std::string_view name_of(point_id p) const { return m_.points[place(p)].called.view(); }

  template <class Id>
  bool both(Id first, Id second, std::string_view whom) {
    return inspect_.present(first, whom) && inspect_.present(second, whom);
  }

  bool new_frame(std::string_view called, frame_id parent);

  /// How a point moves is said once.
  bool unsaid_motion(point_id p);
  bool may_move(point_id point, frame_id reference, const vector& velocity);

  frame_id by_sequence(std::string_view called, frame_id parent, std::string_view letters,
                       const symbolic::sequence<expression>& angles, bool space_fixed);

  std::shared_ptr<symbolic::graph> graph_ = std::make_shared<symbolic::graph>(); ///< shared with models
  mechanics::multibody_system system_;
  mechanics::mechanism& m_ = system_.mechanism;
  inspector inspect_;
  symbolic::sequence<expression> used_elsewhere_{};
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/engine/builder.hpp>
#include <kanexpr/runtime/engine/builder_constraints.hpp>
#include <kanexpr/runtime/engine/builder_loads.hpp>
#endif
