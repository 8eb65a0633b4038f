// Contacts and friction that are incomplete or meaningless.
#include "joints.hpp"

#include <kanexpr/contact.hpp>

using above = sphere_on_plane<Arm, 0.1, Ground, Ground::z>;
using firm = elastic<100, 1.5>;
using thin = smoothed_over<0.001>;

// expect: the contact between Arm and Ground needs one elastic<stiffness, exponent>
namespace n1 {
struct System : jointed<joints<Arm>, loads<contact<above, thin>>> {};
void f() { use<System>(); }
} // namespace n1

// expect: the contact between Arm and Ground needs one smoothed_over<width>
namespace n2 {
struct System : jointed<joints<Arm>, loads<contact<above, firm>>> {};
void f() { use<System>(); }
} // namespace n2

// expect: the contact between Arm and Ground has more than one of restitution<...> and dissipation<...>
namespace n3 {
using twice_damped = contact<above, firm, thin, dissipation<1>, restitution<0.5, 1>>;
struct System : jointed<joints<Arm>, loads<twice_damped>> {};
void f() { use<System>(); }
} // namespace n3

// expect: the contact between Arm and Ground has a coefficient of restitution that is not a number in
// expect: (0, 1]
namespace n4 {
struct System : jointed<joints<Arm>, loads<contact<above, firm, thin, restitution<l, 1>>>> {};
void f() { use<System>(); }
} // namespace n4

// expect: the contact between Arm and Ground has coulomb_friction<...> without a slip speed; only a
// expect: contact with restitution<...> has a default
namespace n5 {
struct System : jointed<joints<Arm>, loads<contact<above, firm, thin, coulomb_friction<0.4>>>> {};
void f() { use<System>(); }
} // namespace n5

// expect: the contact between Arm and Ground lacks an argument; write rolling_resistance<lever, angular
// expect: velocity>
namespace n6 {
struct System : jointed<joints<Arm>, loads<contact<above, firm, thin, rolling_resistance<l>>>> {};
void f() { use<System>(); }
} // namespace n6

// expect: the contact between Arm and Ground has an argument that is neither elastic<...>,
// expect: smoothed_over<...>, restitution<...>, dissipation<...>, rolling_resistance<...>,
// expect: spinning_resistance<...>, directional_friction<...> nor a law of friction
namespace n7 {
struct System : jointed<joints<Arm>, loads<contact<above, firm, thin, gravity<Ground::z>>>> {};
void f() { use<System>(); }
} // namespace n7

// expect: the contact begins with neither sphere_on_plane<...>, point_on_plane<...>, torus_on_plane<...>,
// expect: sphere_on_sphere<...> nor point_on_surface<...>
namespace n8 {
struct System : jointed<joints<Arm>, loads<contact<firm, thin>>> {};
void f() { use<System>(); }
} // namespace n8

// expect: the exponent of the contact between Arm and Ground is not a number from 1 to 30
namespace n9 {
struct System : jointed<joints<Arm>, loads<contact<above, elastic<100, l>, thin>>> {};
void f() { use<System>(); }
} // namespace n9

// expect: the contact between Arm and Ground has rolling_resistance<...>, but a point does not roll
namespace n10 {
using no_roll = contact<point_on_plane<Arm, Ground, Ground::z>, firm, thin, rolling_resistance<0.1, 0.1>>;
struct System : jointed<joints<Arm>, loads<no_roll>> {};
void f() { use<System>(); }
} // namespace n10

// expect: the normal of the contact between Arm and Ground is a scalar; it must be a vector
namespace n11 {
struct System : jointed<joints<Arm>, loads<contact<point_on_plane<Arm, Ground, l>, firm, thin>>> {};
void f() { use<System>(); }
} // namespace n11

// expect: the friction between Arm and Ground has coulomb_friction<...> without a slip speed; only a
// expect: contact with restitution<...> has a default
namespace n12 {
struct System : jointed<joints<Arm>, loads<friction<Arm, l, coulomb_friction<0.4>>>> {};
void f() { use<System>(); }
} // namespace n12

// expect: the friction between Arm and Ground lacks an argument; write friction<Joint or Path, normal
// expect: force, law>
namespace n13 {
struct System : jointed<joints<Arm>, loads<friction<Arm, l>>> {};
void f() { use<System>(); }
} // namespace n13

// expect: which is for a pathway, such as straight<P, Q>, or a joint that turns about one axis or slides
// expect: along one
namespace n14 {
struct Link : spherical<Link, Ground, mass> {};
struct System : jointed<joints<Link>, loads<friction<Link, l, viscous_friction<1>>>> {};
void f() { use<System>(); }
} // namespace n14

// expect: which is incomplete, because its last argument is not a law of friction
namespace n15 {
struct System : jointed<joints<Arm>, loads<friction<Arm, l, firm>>> {};
void f() { use<System>(); }
} // namespace n15

// expect: the width of the contact between Arm and Ground is not positive
namespace n16 {
struct System : jointed<joints<Arm>, loads<contact<above, firm, smoothed_over<-1.0>>>> {};
void f() { use<System>(); }
} // namespace n16

// expect: the surface of the contact between P and Ground contains the coordinate q_Arm; it may contain
// expect: only parameters
namespace n17 {
struct P : offset<P, Arm, 0.1 * Arm::x> {};
struct System
    : jointed<joints<Arm>,
              loads<contact<point_on_surface<P, Ground, Ground, surface::z - q_of<Arm>>, firm, thin>>> {};
void f() { use<System>(); }
} // namespace n17

// expect: contains surface::x, which is valid only in point_on_surface<...> and uneven_ground<...>
namespace n18 {
struct System : jointed<joints<Arm>, loads<motor<Arm, T * surface::x>>> {};
void f() { use<System>(); }
} // namespace n18

// expect: the coefficient of friction of the friction between Arm and Ground is negative
namespace n19 {
struct System : jointed<joints<Arm>, loads<friction<Arm, l, coulomb_friction<-0.4, 0.1>>>> {};
void f() { use<System>(); }
} // namespace n19

// expect: the bodies of the contact between P and Arm never move relative to each other
namespace n20 {
struct P : offset<P, Arm, 0.1 * Arm::x> {};
struct System : jointed<joints<Arm>, loads<contact<point_on_plane<P, Arm, Arm::z>, firm, thin>>> {};
void f() { use<System>(); }
} // namespace n20

// expect: the approach speed of the contact between Arm and Ground is not positive
namespace n21 {
struct System : jointed<joints<Arm>, loads<contact<above, firm, thin, restitution<0.4, -2>>>> {};
void f() { use<System>(); }
} // namespace n21

// expect: the contact between Arm and Ground is listed twice
namespace n22 {
struct System : jointed<joints<Arm>, loads<contact<above, firm, thin>, contact<above, firm, thin>>> {};
void f() { use<System>(); }
} // namespace n22

// expect: the end P of the force between P and Hook is inside the surface
namespace n23 {
struct P : offset<P, Arm, 0.1 * Arm::x> {};
struct Hook : offset<Hook, Ground, 2.0 * Ground::x> {};
using drum = around_cylinder<Ground, Ground, Ground::z, 0.2, P, Hook, wrapping::clockwise>;
struct System : jointed<joints<Arm>, loads<force_along<drum, T>>> {};
void f() { use<System>(); }
} // namespace n23

// expect: the contact between Arm and Ground has spinning_resistance<...>, but a point does not turn
namespace n24 {
using no_spin = contact<point_on_plane<Arm, Ground, Ground::z>, firm, thin, spinning_resistance<0.1, 0.1>>;
struct System : jointed<joints<Arm>, loads<no_spin>> {};
void f() { use<System>(); }
} // namespace n24

// expect: the contact between Arm and Ground has a direction of friction, but no law of friction
namespace n90 {
using blade = directional_friction<Ground::x, 0.1>;
struct System : jointed<joints<Arm>, loads<contact<sphere_on_plane<Arm, 0.1, Ground, Ground::y>, elastic<100>,
                                                   smoothed_over<0.001>, blade>>> {};
void f() { use<System>(); }
} // namespace n90

// expect: the direction of the friction of the contact between Arm and Ground is parallel to the normal
namespace n91 {
using blade = directional_friction<2 * Ground::y, 0.1>;
struct System : jointed<joints<Arm>, loads<contact<sphere_on_plane<Arm, 0.1, Ground, Ground::y>, elastic<100>,
                                                   smoothed_over<0.001>, viscous_friction<1>, blade>>> {};
void f() { use<System>(); }
} // namespace n91

// expect: the ratio of the directional friction of the contact between Arm and Ground is not positive
namespace n92 {
using blade = directional_friction<Ground::x, -0.1>;
struct System : jointed<joints<Arm>, loads<contact<sphere_on_plane<Arm, 0.1, Ground, Ground::y>, elastic<100>,
                                                   smoothed_over<0.001>, viscous_friction<1>, blade>>> {};
void f() { use<System>(); }
} // namespace n92

// expect: the contact between Arm and Ground lacks an argument; write directional_friction<vector, ratio>
namespace n93 {
using blade = directional_friction<Ground::x>;
struct System : jointed<joints<Arm>, loads<contact<sphere_on_plane<Arm, 0.1, Ground, Ground::y>, elastic<100>,
                                                   smoothed_over<0.001>, viscous_friction<1>, blade>>> {};
void f() { use<System>(); }
} // namespace n93
