#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/describe/expression.hpp>
#include <kanexpr/describe/pathway.hpp>
#include <kanexpr/mechanics/loads/add_beam.hpp>
#include <kanexpr/mechanics/loads/contact_geometry.hpp>
#include <kanexpr/mechanics/loads/path_load.hpp>
#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/mechanics/loads/tyre_law.hpp>
#include <kanexpr/mechanics/loads/wheel_on_ground.hpp>
#include <kanexpr/mechanics/model/beam.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/numeric/beams/shape.hpp>
#include <kanexpr/runtime/beam_data.hpp>
#include <kanexpr/runtime/block_data.hpp>
#include <kanexpr/runtime/builder_checks.hpp>
#include <kanexpr/runtime/contact_data.hpp>
#include <kanexpr/runtime/flexible_integrals.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/runtime/number_or_expression.hpp>
#include <kanexpr/runtime/tyre_data.hpp>
#include <kanexpr/runtime/wheel_data.hpp>
#include <kanexpr/symbolic/graph/compose.hpp>
#include <kanexpr/units/unit.hpp>

#include <concepts>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace kanexpr {

namespace runtime {
class builder;
}

/// Derives the system built so far; later calls to the builder do not change the model. A mistake made in the
/// builder also counts as a mistake in the model.
KANEXPR_ENGINE model derive(const runtime::builder& built);

namespace runtime {

/// Derives the system in a separate graph. Its expressions belong only to the model and depend neither on the
/// compiler nor on earlier derivations.
KANEXPR_ENGINE model derive_in_own_graph(const builder& built);

} // namespace runtime

} // namespace kanexpr

namespace kanexpr::runtime {

/// A vector whose components along `directions` vanish.
struct zero_components {
  vector value;
  std::vector<vector> directions;
};

/// A line along which loads act, such as a cable; the functions of a builder return it.
using pathway = mechanics::pathway;

/// A wheel and the ground below it; the functions of a builder return it.
using wheel_on_ground = mechanics::wheel_on_ground;

/// An end of a pathway around a surface: a point, which may lie on the surface.
struct end_of_path {
  point_id point{};
  bool is_on_surface = false;
  end_of_path(point_id p, bool on_surface = false) : point(p), is_on_surface(on_surface) {}
};

/// Builds a system from values at run time. A builder cannot be copied or moved. `derive(b)` returns a model
/// of the system, which has the same results as a system described by types.
///
/// A mistake does not stop the program: the first one is stored as a sentence, and the invalid item is
/// omitted.
///
/// Loads and constraints may contain velocities. After frames and points have been defined,
/// `mechanics::known_motion known(b.mechanism());` provides them.
class builder {
public:
  explicit builder(std::string_view inertial_frame);
  builder(const builder&) = delete;
  builder& operator=(const builder&) = delete;

  /// The first mistake made while building, or the first in the resulting system; empty if there is none.
  sentence(check)() const;
  const sentence& mistake() const { return checks_.mistake(); }

  /// The units of the symbols and constraints of the system built so far, as far as they are determined.
  mechanics::unit_table units() const;
  /// The unit of an expression; nothing if it is not determined.
  mechanics::possible_unit unit_of(expression e) const;

  const mechanics::multibody_system& system() const { return system_; }
  const mechanics::mechanism& mechanism() const { return system_.mechanism; }
  symbolic::graph& graph() { return *graph_; }

  // ---- scalars

  // Each symbol may be given with its unit, such as `units::si::newton*units::si::meter`.

  expression coordinate(std::string_view q) { return checks_.is_new_symbol(q), m_.coordinate(q); }
  expression coordinate(std::string_view q, const units::unit& u) { return with_unit(coordinate(q), u); }
  expression speed(std::string_view u) { return checks_.is_new_speed(u), m_.speed(u); }
  expression speed(std::string_view u, const units::unit& of) { return with_unit(speed(u), of); }
  /// A scalar that is neither a coordinate nor a speed; `dynamics` gives its rate. State variables follow all
  /// speeds.
  expression state_variable(std::string_view z) { return checks_.is_new_symbol(z), m_.state_variable(z); }
  expression state_variable(std::string_view z, const units::unit& u) {
    return with_unit(state_variable(z), u);
  }
  expression parameter(std::string_view p) { return checks_.is_new_symbol(p), m_.parameter(p); }
  expression parameter(std::string_view p, const units::unit& u) { return with_unit(parameter(p), u); }
  expression input(std::string_view r) { return checks_.is_new_symbol(r), m_.input(r); }
  expression input(std::string_view r, const units::unit& u) { return with_unit(input(r), u); }
  /// A quantity that is a known function of time. It adds three consecutive inputs: r, dot(r) and
  /// dot(dot(r)).
  expression prescribed(std::string_view r);
  expression prescribed(std::string_view r, const units::unit& u) { return with_unit(prescribed(r), u); }
  /// Declares that a parameter or an input is used by expressions that are requested later; any other unused
  /// parameter or input is a mistake.
  void used_elsewhere(expression parameter_or_input);
  /// A speed that is always zero; it brings a force that does no work into evidence.
  expression auxiliary_speed(std::string_view u) { return checks_.is_new_symbol(u), m_.auxiliary_speed(u); }
  expression auxiliary_speed(std::string_view u, const units::unit& of) {
    return with_unit(auxiliary_speed(u), of);
  }
  /// Selects Lagrange's method: the rates of the coordinates declared so far are used as speeds.
  void rates_as_speeds();
  /// Specifies a Lagrangian instead of bodies; call it after `rates_as_speeds`.
  void lagrangian(expression energy);
  expression time() { return checks_.take_time(), m_.time; }
  /// A constant; write zero as 0.0.
  expression number(given_number value);

  /// The rate of a coordinate, speed, state variable or prescribed quantity.
  expression dot(expression e);

  /// A kinematic differential equation: an expression that vanishes and is linear in the rates of the
  /// coordinates, such as `dot(q) - u`.
  void kinematic_equation(expression vanishes) {
    if (checks_.owns("a kinematic differential equation", vanishes)) m_.kinematics.push(vanishes);
  }
  /// The rate of a state variable. It may depend on everything except the rates of the speeds.
  void dynamics(expression state_variable, expression rate);
  /// The equations that equate the angular velocity derived from the orientation of a frame with the declared
  /// one.
  void kinematics_of(frame_id frame, frame_id reference);

  // ---- vectors and dyadics

  /// A vector with the given components, which are numbers or expressions: `b.along(A, l, 0, 0)`. The zero
  /// vector is `{}`.
  vector along(frame_id axes, const number_or_expression& x, const number_or_expression& y,
               const number_or_expression& z);
  expression dot(const vector& a, const vector& b);

  /// An inertia dyadic with the given entries in the axes of a frame; the products of inertia have the sign
  /// of Σ m (r·r E − r r).
  dyadic inertia(frame_id axes, const number_or_expression& xx, const number_or_expression& yy,
                 const number_or_expression& zz, const number_or_expression& xy = 0,
                 const number_or_expression& yz = 0, const number_or_expression& zx = 0);

  // ---- frames

  static constexpr frame_id inertial_frame() { return frame_id{mechanics::mechanism::inertial}; }

  /// A frame rotated by `angle` about an axis that is fixed in the parent.
  frame_id rotated(std::string_view called, frame_id parent, expression angle, const vector& axis);
  frame_id body_fixed(std::string_view called, frame_id parent, std::string_view letters, expression first,
                      expression second, expression third) {
    return rotated_by_sequence(called, parent, letters, {first, second, third}, false);
  }
  frame_id space_fixed(std::string_view called, frame_id parent, std::string_view letters, expression first,
                       expression second, expression third) {
    return rotated_by_sequence(called, parent, letters, {first, second, third}, true);
  }
  /// A frame rotated by the unit quaternion e0 + e1 i + e2 j + e3 k.
  frame_id quaternion(std::string_view called, frame_id parent, expression e0, expression e1, expression e2,
                      expression e3);
  /// A frame rotated by φ about the unit vector a; the modified Rodrigues parameters are the components of a
  /// tan(φ/4).
  frame_id modified_rodrigues(std::string_view called, frame_id parent, expression s1, expression s2,
                              expression s3);
  /// A frame specified by its direction cosines: v in the parent's axes = to_parent · v in the frame's axes.
  frame_id direction_cosines(std::string_view called, frame_id parent, const mechanics::matrix3& to_parent);
  /// Declares the angular velocity of a frame in `reference`, used in place of the derived one. It must agree
  /// with the orientation, except for a spin about an axis whose angle the orientation omits.
  void angular_velocity(frame_id frame, frame_id reference, const vector& value) {
    declare_angular_velocity(frame, reference, value, false);
  }
  /// The same for a frame whose orientation intentionally does not follow its angular velocity.
  void angular_velocity_apart_from_orientation(frame_id frame, frame_id reference, const vector& value) {
    declare_angular_velocity(frame, reference, value, true);
  }

  // ---- points

  /// A point that is fixed in the inertial frame.
  point_id origin(std::string_view called);
  point_id offset(std::string_view called, point_id parent, const vector& from_parent);
  /// Derives the velocity by the two-point theorem: the point and its parent are both fixed in `frame`.
  void fixed_in(point_id point, frame_id frame);
  /// The position of `point` relative to `from`.
  vector position_of(point_id point, point_id from);
  /// Declares the velocity of a point in `reference`, used in place of the derived one. In the inertial frame
  /// it is the full velocity; in any other frame the motion of the parent, which is fixed there, is added
  /// (one-point theorem).
  void velocity(point_id point, frame_id reference, const vector& value);
  /// The same for a point whose position intentionally does not follow its velocity.
  void velocity_apart_from_position(point_id point, frame_id reference, const vector& value);
  /// Like `velocity`, but always adds the motion of the parent, whatever the frame.
  void velocity_from_parent(point_id point, frame_id reference, const vector& value);

  // ---- bodies and loads

  void particle(std::string_view called, point_id at, expression mass);
  void rigid_body(std::string_view called, point_id center, frame_id frame, expression mass,
                  const dyadic& inertia) {
    rigid_body(called, center, frame, mass, inertia, center);
  }
  /// A rigid body with its inertia about any point of the body.
  void rigid_body(std::string_view called, point_id center, frame_id frame, expression mass,
                  const dyadic& inertia, point_id about);
  /// A body that deforms relative to `frame`, which moves with the point `reference`. The amplitudes of its
  /// deformation are coordinates of the system and belong to no other body.
  void flexible_body(std::string_view called, point_id reference, frame_id frame,
                     const std::vector<expression>& amplitudes, const flexible_integrals& data);
  /// The same with numbers, such as those that `flexible::read_sid` reads.
  flexible_body_id flexible_body(std::string_view called, point_id reference, frame_id frame,
                                 const std::vector<expression>& amplitudes,
                                 const mechanics::flexible_data& data);
  /// The point and the frame of a node of a body that was added with numbers. The frame is rotated by the
  /// rotation vector that the shapes give at the node, to the second order.
  section_ids node(std::string_view called, flexible_body_id of, std::string_view node);
  /// A beam that begins at `root` and deforms relative to `frame`. Each shape has one amplitude, a
  /// coordinate: those of the directions of bending come first, then those of torsion and of extension.
  beam_id beam(std::string_view called, point_id root, frame_id frame,
               const std::vector<expression>& amplitudes, const beam_data& data);
  /// The section of a beam at the fraction ξ of its length; write 0.0 for the root.
  section_ids section(std::string_view called, beam_id on, given_number xi);
  /// Declares that the inertia of a rigid body intentionally varies in body-fixed axes.
  void changing_inertia(std::string_view body);
  /// Declares that the inertia of a body is intentionally not that of a mass distribution.
  void effective_inertia(std::string_view body);
  void force(point_id at, const vector& value);
  void torque(frame_id on, const vector& value);
  /// A force on the point `at` and the opposite force on `other`.
  void force_between(point_id at, point_id other, const vector& value);
  /// A torque on the frame `on` and the opposite torque on `other`.
  void torque_between(frame_id on, frame_id other, const vector& value);
  /// The gravitational acceleration of all bodies.
  void gravity(const vector& acceleration);
  /// A potential energy as a function of coordinates, parameters, time and inputs.
  void potential_energy(expression energy);
  /// A straight spring that pulls two points together with the force stiffness·(distance − natural length).
  void spring(point_id at, point_id other, expression stiffness, expression natural_length);
  void spring(point_id at, point_id other, expression stiffness) { spring(at, other, stiffness, m_.zero()); }
  /// A damper that pulls two points together with the force damping·(rate of change of their distance).
  void damper(point_id at, point_id other, expression damping);
  /// A torsional spring that returns an angle to its rest position with the torque stiffness·(angle − rest).
  void torsional_spring(expression angle, expression stiffness, expression rest);
  void torsional_spring(expression angle, expression stiffness) {
    torsional_spring(angle, stiffness, m_.zero());
  }
  /// A torque −damping·ω on the frame `on` and the opposite torque on `other`, where ω is the angular
  /// velocity of `on` relative to `other`.
  void torsional_damper(frame_id on, frame_id other, expression damping);

  // ---- pathways and the loads along them; a positive tension shortens a pathway

  pathway straight(point_id from, point_id to) { return through({from, to}); }
  /// Straight lines from point to point, between which a cable slides without friction.
  pathway through(const std::vector<point_id>& points);
  /// A pathway of which only the length is given, such as the coordinate of a joint.
  pathway given_length(expression length);
  /// An end of a pathway that lies on the surface around which the pathway is wrapped.
  static end_of_path on_surface(point_id p) { return {p, true}; }
  /// The shortest line around a cylinder that is fixed in the frame `in`.
  pathway around_cylinder(frame_id in, point_id on_axis, const vector& axis, expression radius,
                          end_of_path first, end_of_path last, wrapping sense);
  pathway around_sphere(point_id center, expression radius, end_of_path first, end_of_path last);
  /// The shortest line around a cone with the given angle between the axis, which points from the tip into
  /// the cone, and the surface.
  pathway around_cone(frame_id in, point_id tip, const vector& axis, expression angle, end_of_path first,
                      end_of_path last, wrapping sense);
  /// The length of a pathway.
  expression length_of(const pathway& along);

  void force_along(const pathway& along, expression tension);
  /// A spring with the tension stiffness·(length − natural length).
  void linear_spring(const pathway& along, expression stiffness, expression natural_length);
  void linear_spring(const pathway& along, expression stiffness) {
    linear_spring(along, stiffness, m_.zero());
  }
  /// A spring with the tension k x + k₃ x³, where x is the length minus the natural length.
  void cubic_spring(const pathway& along, expression k, expression k3, expression natural_length);
  void cubic_spring(const pathway& along, expression k, expression k3) {
    cubic_spring(along, k, k3, m_.zero());
  }
  void linear_damper(const pathway& along, expression damping);
  /// Friction against the rate of the length.
  void friction_along(const pathway& along, expression normal_force, const mechanics::friction_law& law);
  /// Stops at a least and at a greatest length, as `stop<Path, …>`.
  void stop(const pathway& along, expression least, expression greatest, expression stiffness,
            expression damping) {
    stop(along, least, greatest, stiffness, damping, mechanics::default_width_of_stop(least, greatest));
  }
  void stop(const pathway& along, expression least, expression greatest, expression stiffness,
            expression damping, expression width);

  /// An elastic mount between the frame `on` at the point `at` and the frame `base` at the point
  /// `base_point`, with stiffnesses along and about the axes of `base`, as `bushing<Body, Base, …>`; dampings
  /// may be omitted.
  void bushing(frame_id on, point_id at, frame_id base, point_id base_point,
               const std::vector<expression>& stiffnesses, const std::vector<expression>& dampings = {});

  // ---- filters, controllers and muscles; their state variables are named after them, so they follow all
  // speeds

  /// A first-order lag with the state variable y_called, as `lag<Self, …>`. Returns its output.
  expression lag(std::string_view called, expression input, const number_or_expression& time);
  /// Follows an input with a limited rate, as `slew_limit<Self, …>`. Returns its output.
  expression slew_limit(std::string_view called, expression input, const number_or_expression& rate,
                        const number_or_expression& time);
  /// Delays an input approximately, with `order` state variables from 1 to 20, as `delay<Self, …>`. Returns
  /// its output.
  expression delay(std::string_view called, int order, expression input, const number_or_expression& time);
  /// A PID controller of a deviation, as `pid<Self, …>`. Returns its output.
  expression pid(std::string_view called, expression deviation, const number_or_expression& kp,
                 const number_or_expression& ki, const number_or_expression& kd,
                 const number_or_expression& Td);
  /// The same without a derivative.
  expression pid(std::string_view called, expression deviation, const number_or_expression& kp,
                 const number_or_expression& ki);
  /// The same with limits of the output and the time constant Tt with which the integral part returns.
  expression pid(std::string_view called, expression deviation, const number_or_expression& kp,
                 const number_or_expression& ki, const number_or_expression& least,
                 const number_or_expression& greatest, const number_or_expression& Tt);
  expression pid(std::string_view called, expression deviation, const number_or_expression& kp,
                 const number_or_expression& ki, const number_or_expression& kd,
                 const number_or_expression& Td, const number_or_expression& least,
                 const number_or_expression& greatest, const number_or_expression& Tt);
  /// The activation of a muscle by an excitation, as `muscle_activation<Self, …>`. Returns the activation.
  expression muscle_activation(std::string_view called, expression excitation, const number_or_expression& Ta,
                               const number_or_expression& Td);
  /// A DC motor that turns n times as fast as a joint with the given speed, as `dc_motor<Joint, …>`. Returns
  /// its current, the state variable i_called, and the torque, which the caller applies: `b.torque_between(A,
  /// N, b.along(N, 0, 0, motor.torque))`.
  dc_motor_states dc_motor(std::string_view called, expression speed, const dc_motor_data& data);
  /// A rotor that turns `gear_ratio` times as fast as an angle, such as the coordinate of a joint, with the
  /// energy ½ J (n dq/dt)², as `rotor<J, n>` of a joint. The inertia and the ratio are constants. Requires a
  /// point.
  void rotor(std::string_view called, expression angle, const number_or_expression& inertia,
             const number_or_expression& gear_ratio = 1.0);
  /// A muscle with its tendon, as `muscle<Self, Path, …>`: `b.muscle("Biceps", path, e,
  /// {.peak_isometric_force = 500, .optimal_fiber_length = 0.1, .tendon_slack_length = 0.2})`. Returns its
  /// state variables.
  muscle_states muscle(std::string_view called, const pathway& along, expression excitation,
                       const muscle_data& data);

  /// A contact of a sphere that is fixed in the frame `of` with the plane through `in_plane`, whose normal
  /// points to the sphere; the plane is fixed in the frame in whose axes the normal is given.
  void sphere_on_plane(point_id center, frame_id of, const number_or_expression& radius, point_id in_plane,
                       const vector& normal, const contact_data& data);
  /// The same for a point.
  void point_on_plane(point_id point, point_id in_plane, const vector& normal, const contact_data& data);
  /// The same for a torus: the centers of its tube are on a circle about the axis. The contact is undefined
  /// if the axis is parallel to the normal.
  void torus_on_plane(point_id center, frame_id of, const vector& axis, const number_or_expression& circle,
                      const number_or_expression& tube, point_id in_plane, const vector& normal,
                      const contact_data& data);
  /// A contact of two spheres outside of each other, each of which is fixed in a frame.
  void sphere_on_sphere(point_id center, frame_id of, const number_or_expression& radius,
                        point_id other_center, frame_id other, const number_or_expression& other_radius,
                        const contact_data& data);

  /// A contact of a point with a surface that is fixed in a frame. `level` is a function of three
  /// coordinates, which are measured from `origin` in the axes of the frame; it vanishes on the surface and
  /// is positive on the side of the point: `[&](expression x, expression y, expression z) { return z - h *
  /// sin(x); }`.
  template <class Level>
  void point_on_surface(point_id point, point_id origin, frame_id of, const Level& level,
                        const contact_data& data) {
    const mechanics::components at = mechanics::surface_coordinates(*graph_);
    add_surface_contact(point, origin, of, level(at.x, at.y, at.z), data);
  }

  /// The normal force of a contact, numbered from 1 in the order in which contacts were added.
  expression normal_force_of(int contact, mechanics::known_motion& known);
  /// The friction force of a contact on its first body.
  vector friction_force_of(int contact, mechanics::known_motion& known);

  /// A wheel on the plane through `in_plane`, whose normal points to the wheel; the plane is fixed in the
  /// frame in whose axes the normal is given.
  wheel_on_ground wheel_on_plane(const wheel_data& wheel, point_id in_plane, const vector& normal);
  /// A wheel on the ground z = f(x, y), with coordinates from `origin` in the axes of a frame:
  /// `[&](expression x, expression y) { return h * cos(k * x); }`. The lowest point follows from `steps` of
  /// Newton's method.
  template <class Height>
  wheel_on_ground wheel_on_surface(const wheel_data& wheel, point_id origin, frame_id of,
                                   const Height& height, int steps = 2) {
    const mechanics::components at = mechanics::surface_coordinates(*graph_);
    return wheel_on_height(wheel, origin, of, height(at.x, at.y), steps);
  }
  /// A conical wheel on a straight rail.
  wheel_on_ground wheel_on_rail(const wheel_data& wheel, const rail_data& rail);
  /// The lowest point of a wheel, as the material point of the wheel at the contact: it rolls without slip if
  /// the velocity of this point is zero.
  point_id contact_point(std::string_view called, const wheel_on_ground& wheel);

  /// A tyre on a wheel, as `tyre<…>`.
  void tyre(const wheel_on_ground& wheel, const tyre_data& data);

  // ---- constraints; their expressions may contain velocities of a `mechanics::known_motion`

  /// A vector whose components along the given directions vanish, with one constraint per direction:
  /// `b.configuration_constraint(b.zero_along(b.position_of(P, Q), b.along(N, 1, 0, 0), b.along(N, 0, 1,
  /// 0)))`.
  template <std::same_as<vector>... Directions>
  static zero_components zero_along(const vector& v, const Directions&... directions) {
    return {v, {directions...}};
  }

  /// An expression in the coordinates that must vanish.
  void configuration_constraint(expression vanishes);
  /// Requires the components of a position along given directions to vanish; see `zero_along`.
  void configuration_constraint(const zero_components& v);
  /// An expression that must vanish; it depends on the speeds or the rates of the coordinates, linearly or
  /// not.
  void velocity_constraint(expression vanishes);
  /// Requires the component of a velocity along `direction` to vanish.
  void velocity_constraint(const vector& vanishes, const vector& direction);
  /// Requires the components of a velocity along given directions to vanish; see `zero_along`.
  void velocity_constraint(const zero_components& v);
  /// An expression that must vanish and is linear in the rates of the speeds, such as `dot(u1) + dot(u2)`.
  void acceleration_constraint(expression vanishes);
  /// Selects a coordinate or speed for which the constraints are solved.
  void dependent(expression e);
  /// Declares that a configuration constraint, numbered from 1, follows from the others at every position
  /// that satisfies them all.
  void redundant(int configuration_constraint) {
    system_.constraints.redundant.push(configuration_constraint);
  }

protected:
  /// Gives the unit of an expression that follows from its definition; the units of the system are not
  /// checked because of it.
  void imply_unit(expression e, const units::unit& u) { m_.stated_units.push({e, u, true}); }
  /// Declares that the quantities of all parts built so far are in SI units by definition.
  void trust_units_of_present_parts() { system_.trust_units_of_present_parts(); }

private:
  friend model kanexpr::derive(const builder& built);

  expression with_unit(expression symbol, const units::unit& u) {
    m_.stated_units.push({symbol, u});
    return symbol;
  }
  expression as_expression(const number_or_expression& given);
  bool is_new_body(std::string_view called);
  mechanics::components as_components(const flexible_integrals::vector_entries& given);
  symbolic::matrix as_matrix(const flexible_integrals::matrix& given);
  bool has_shapes_of(std::string_view body, std::size_t amplitudes, const flexible_integrals& data);
  /// A pathway around a surface of revolution, or around a sphere if the axis is zero.
  pathway around_surface(mechanics::pathway_form form, frame_id in, point_id center, const vector& axis,
                         expression size, end_of_path first, end_of_path last, wrapping sense);
  bool owns_pathway(std::string_view whose, const pathway& along);
  expression state_of_block(std::string_view letter, std::string_view block, int number = 0);
  void equate(expression state, expression left, expression right);
  void must_be_positive(std::string_view what, std::string_view whose, expression value);
  /// A number or an expression; the integer 0 is a mistake.
  expression as_nonzero(const number_or_expression& given, std::string_view what);
  base::sequence<expression> arguments_of_block(std::string_view block,
                                                std::initializer_list<number_or_expression> given);
  bool owns_path_load(std::string_view whose, const pathway& along, const base::sequence<expression>& terms);
  bool has_elasticity(std::string_view called, const base::sequence<expression>& amplitudes,
                      const symbolic::matrix& stiffness, const symbolic::matrix& damping);
  bool owns_flexible_body(const mechanics::flexible_body& b);

  /// A beam and its shapes, from which its sections are formed.
  struct built_beam {
    numeric::beams::beam_shapes shapes{};
    mechanics::beam beam{};
  };
  void deform(built_beam& to, mechanics::deformation what, const beam_deformation& by);
  void deform(built_beam& to, const beam_data& data);
  void check_profile(std::string_view beam, const numeric::beams::shape& profile);
  mechanics::components unit_direction(const vector& given, int frame);
  mechanics::beam_damping damping_of(std::string_view beam, const beam_data& data);
  bool owns_beam(const built_beam& made, const mechanics::beam_damping& damped);
  bool set_direction(mechanics::components& unit, int& frame, const vector& given,
                     std::string_view whose = "a contact");
  void add_surface_contact(point_id point, point_id origin, frame_id of, expression level,
                           const contact_data& data);
  wheel_on_ground wheel_on(const wheel_data& wheel, point_id ground);
  wheel_on_ground wheel_on_height(const wheel_data& wheel, point_id origin, frame_id of, expression height,
                                  int steps);
  bool owns_wheel(std::string_view whose, const wheel_on_ground& wheel);
  void add_contact(const mechanics::contact_geometry& between, const contact_data& data);
  bool has_contact(int numbered, const mechanics::known_motion& known);
  expression value_of(const tyre_data::value& given);
  mechanics::tyre_law law_of(const tyre_data& data);
  int deflection(expression state_variable);
  /// Whether at least one of the arguments is not the integer 0.
  bool not_all_zero(std::initializer_list<const number_or_expression*> given, std::string_view whose);

  std::string_view name_of(frame_id f) const { return m_.frames[place(f)].called.view(); }
  std::string_view name_of(point_id p) const { return m_.points[place(p)].called.view(); }

  template <class... Arguments>
  bool is_new_frame(std::string_view called, frame_id parent, const Arguments&... orientation) {
    return checks_.is_new("frames", called, m_.frames) && checks_.owns(called, parent, orientation...);
  }
  frame_id rotated_by_sequence(std::string_view called, frame_id parent, std::string_view letters,
                               const base::sequence<expression>& angles, bool space_fixed);
  void declare_angular_velocity(frame_id frame, frame_id reference, const vector& value, bool apart);

  bool is_motion_undeclared(point_id p);
  bool may_declare_velocity(point_id point, frame_id reference, const vector& velocity);
  void mark_body(std::string_view body, bool mechanics::body::* mark, std::string_view whose);
  bool is_valid_direction(const vector& v, const vector& direction, std::string_view whose);

  std::shared_ptr<symbolic::graph> graph_ = std::make_shared<symbolic::graph>(); ///< shared with models
  mechanics::multibody_system system_;
  mechanics::mechanism& m_ = system_.mechanism;
  builder_checks checks_;
  base::sequence<expression> used_elsewhere_{};
  /// A flexible body that was added with numbers; its nodes are formed from them.
  struct body_with_data {
    mechanics::flexible_body body{};
    mechanics::flexible_data data{};
  };
  std::vector<body_with_data> bodies_with_data_{};
  std::vector<built_beam> beams_{};
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/builder.ipp>
#include <kanexpr/runtime/builder_beam.ipp>
#include <kanexpr/runtime/builder_blocks.ipp>
#include <kanexpr/runtime/builder_constraints.ipp>
#include <kanexpr/runtime/builder_contact.ipp>
#include <kanexpr/runtime/builder_flexible_body.ipp>
#include <kanexpr/runtime/builder_flexible_data.ipp>
#include <kanexpr/runtime/builder_loads.ipp>
#include <kanexpr/runtime/builder_pathways.ipp>
#include <kanexpr/runtime/builder_tyres.ipp>
#include <kanexpr/runtime/builder_wheels.ipp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#endif
