#pragma once

#include <kanexpr/describe/load.hpp>
#include <kanexpr/describe/path_load.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

/// The length of a pathway and the forces of loads, as expressions for results, plots and other loads.
namespace kanexpr {

namespace describe {

enum class load_quantity : unsigned char {
  length,
  penetration, ///< of a wheel into the ground
  tension,
  normal_force,
  longitudinal_force, ///< of a tyre, as the following ones
  lateral_force,
  aligning_moment,
  longitudinal_slip,
  lateral_slip,
  camber,
  friction_force,
  contact_force, ///< the sum of the normal force and the friction, on the first body
  contact_place, ///< from the point of the first body to the contact
  lowest_point,  ///< from the center of a wheel to its lowest point
};

/// Whether a quantity is one that only tyres have.
constexpr bool is_of_tyre(load_quantity what) {
  return what >= load_quantity::longitudinal_force && what <= load_quantity::camber;
}

/// Whether a quantity depends only on positions, so that it is known while a model is read.
constexpr bool is_of_position(load_quantity what) {
  return what == load_quantity::length || what == load_quantity::penetration ||
         what == load_quantity::lowest_point;
}

/// The unit of a quantity; of a tension, if the ends of its pathway are points.
constexpr units::unit unit_of(load_quantity what) {
  using enum load_quantity;
  if (is_of_position(what) || what == contact_place) return units::si::meter;
  if (what == aligning_moment) return units::si::newton * units::si::meter;
  return what == longitudinal_slip || what == lateral_slip || what == camber ? units::unit{}
                                                                             : units::si::newton;
}

/// Whether a quantity is a vector.
constexpr bool is_vector(load_quantity what) { return what >= load_quantity::friction_force; }

constexpr token of_load(load_quantity what, const load_record* load, bool is_of_one_file) {
  token t = with(token_kind::of_load);
  t.index = static_cast<int>(what);
  t.load = load;
  t.is_of_one_file = is_of_one_file;
  return t;
}

/// A pathway in place of a load, of which only the length is of interest.
template <class Path>
inline constexpr load_record length_along = load_along<Path>(load_word::none, "the length", {}, nullptr, 0);

} // namespace describe

/// The length of a pathway, in m: `length_of<straight<P, Q>>`. That of a joint with one coordinate is this
/// coordinate; that of a `given_length` has the unit of the given expression. It depends only on coordinates
/// and parameters, so it may appear in constraints and potential energies, too.
template <class Path>
inline constexpr scalar<1> length_of{{describe::of_load(
    describe::load_quantity::length, &describe::length_along<Path>, !is_known_to_all_files<Path>)}};

/// The tension of a load along a pathway, in N: `tension_of<linear_spring<straight<P, Q>, k, l0>>`, also of a
/// `spring<P, Q, k, l0>` or a `damper<P, Q, c>`. It is positive if the load pulls the ends together. Along a
/// joint that turns it is a torque, in N m. The system must list the load.
template <class Load>
inline constexpr scalar<1> tension_of{{describe::of_load(
    describe::load_quantity::tension, &describe::load_of<Load>, !is_known_to_all_files<Load>)}};

/// The normal force of a contact, in N; it is zero while the contact is open and never negative:
/// `normal_force_of<contact<...>>`. Of a tyre, it is the load F_z. The system must list the contact.
template <class Contact>
inline constexpr scalar<1> normal_force_of{{describe::of_load(
    describe::load_quantity::normal_force, &describe::load_of<Contact>, !is_known_to_all_files<Contact>)}};

/// The longitudinal force F_x of the ground on a tyre, in N; it is positive if it drives the wheel forward:
/// `longitudinal_force_of<tyre<...>>`. The system must list the tyre.
template <class Tyre>
inline constexpr scalar<1> longitudinal_force_of{{describe::of_load(
    describe::load_quantity::longitudinal_force, &describe::load_of<Tyre>, !is_known_to_all_files<Tyre>)}};

/// The lateral force F_y of the ground on a tyre, in N; it is positive to the left (ISO 8855):
/// `lateral_force_of<tyre<...>>`. The system must list the tyre.
template <class Tyre>
inline constexpr scalar<1> lateral_force_of{{describe::of_load(
    describe::load_quantity::lateral_force, &describe::load_of<Tyre>, !is_known_to_all_files<Tyre>)}};

/// The aligning moment M_z of the ground on a tyre about the normal of the ground, in N m; it is positive if
/// it turns the wheel to the left: `aligning_moment_of<tyre<...>>`. The system must list the tyre.
template <class Tyre>
inline constexpr scalar<1> aligning_moment_of{{describe::of_load(
    describe::load_quantity::aligning_moment, &describe::load_of<Tyre>, !is_known_to_all_files<Tyre>)}};

/// The longitudinal slip κ on which the law of a tyre depends: `longitudinal_slip_of<tyre<...>>`. With
/// relaxation lengths, it lags behind the slip of the wheel. It is positive if the wheel is driven. Of a
/// `brush_tyre`, it is the theoretical slip σ_x. The system must list the tyre.
template <class Tyre>
inline constexpr scalar<1> longitudinal_slip_of{{describe::of_load(
    describe::load_quantity::longitudinal_slip, &describe::load_of<Tyre>, !is_known_to_all_files<Tyre>)}};

/// The lateral slip tan α on which the law of a tyre depends: `lateral_slip_of<tyre<...>>`. With relaxation
/// lengths, it lags behind the slip of the wheel. It is positive if the wheel moves to the left. Of a
/// `brush_tyre`, it is −σ_y, minus the theoretical slip. The system must list the tyre.
template <class Tyre>
inline constexpr scalar<1> lateral_slip_of{{describe::of_load(
    describe::load_quantity::lateral_slip, &describe::load_of<Tyre>, !is_known_to_all_files<Tyre>)}};

/// The sine of the camber of a tyre, which is positive if the top of the wheel leans to the right:
/// `sine_of_camber_of<tyre<...>>`. The system must list the tyre.
template <class Tyre>
inline constexpr scalar<1> sine_of_camber_of{{describe::of_load(
    describe::load_quantity::camber, &describe::load_of<Tyre>, !is_known_to_all_files<Tyre>)}};

/// The friction force of a contact on its first body, a vector in N: `friction_force_of<contact<...>>`. The
/// system must list the contact.
template <class Contact>
inline constexpr vector<1> friction_force_of{{describe::of_load(
    describe::load_quantity::friction_force, &describe::load_of<Contact>, !is_known_to_all_files<Contact>)}};

} // namespace kanexpr
