// Contacts that are incomplete or meaningless, and lengths and forces of loads that do not exist.
#include "joints.hpp"

#include <kanexpr/blocks.hpp>
#include <kanexpr/contact.hpp>
#include <kanexpr/tyres.hpp>

struct Tip : offset<Tip, Arm, l * Arm::x> {};
struct Corner : offset<Corner, Ground, 0.7 * Ground::x + 0.4 * Ground::y> {};
using line = straight<Tip, Corner>;
using rope = linear_spring<line, 3, 0.5>;
using above = sphere_on_plane<Arm, 0.1, Ground, Ground::z>;
using firm = elastic<100, 1.5>;
using thin = smoothed_over<0.001>;
using touch = contact<above, firm, thin>;

template <auto wanted, class System>
void want() {
  using eom = equations_of_motion<System>;
  const auto found =
      function<System, wanted>{}(typename eom::state(), typename eom::parameters(), typename eom::inputs());
  static_cast<void>(found);
}

// expect: loads<...> lists straight<Tip, Corner>, which is a pathway; list a load along it, such as
// expect: force_along<path, tension>
namespace q1 {
struct System : jointed<joints<Arm>, loads<line>> {};
void f() { use<System>(); }
} // namespace q1

// expect: loads<...> lists coulomb_friction<...>, which is a law of friction; list friction<joint or path,
// expect: normal force, law>
namespace q2 {
struct System : jointed<joints<Arm>, loads<coulomb_friction<0.3, 0.1>>> {};
void f() { use<System>(); }
} // namespace q2

// expect: loads<...> lists smoothed_over<1>, which is an argument of contact<...>
namespace q3 {
struct System : jointed<joints<Arm>, loads<smoothed_over<1>>> {};
void f() { use<System>(); }
} // namespace q3

// expect: loads<...> lists sphere_on_plane<...>, which is an argument of contact<...>
namespace q4 {
struct System : jointed<joints<Arm>, loads<above>> {};
void f() { use<System>(); }
} // namespace q4

// expect: an expression uses tension_of<...> of the linear spring between Tip and Corner, which the system
// expect: does not list in loads<...>
namespace q5 {
struct System : jointed<joints<Arm>, loads<motor<Arm, T>>> {};
void f() { want<tension_of<rope>, System>(); }
} // namespace q5

// expect: an expression uses tension_of<...> of the contact between Arm and Ground, which does not act along
// expect: a pathway
namespace q6 {
struct System : jointed<joints<Arm>, loads<motor<Arm, T>, touch>> {};
void f() { want<tension_of<touch>, System>(); }
} // namespace q6

// expect: an expression uses normal_force_of<...> of the linear spring between Tip and Corner, which is not
// expect: a contact
namespace q7 {
struct System : jointed<joints<Arm>, loads<motor<Arm, T>, rope>> {};
void f() { want<normal_force_of<rope>, System>(); }
} // namespace q7

// expect: an expression uses tension_of<...> of straight<Tip, Corner>, which is not a load
namespace q8 {
struct System : jointed<joints<Arm>, loads<motor<Arm, T>, rope>> {};
void f() { want<tension_of<line>, System>(); }
} // namespace q8

// expect: the offset of point Point contains the force of a load, which is not yet known while the model is
// expect: read
namespace q9 {
struct Point : offset<Point, Ground, tension_of<rope> * Ground::x> {};
struct Bob : particle<Bob, Point, 1> {};
struct System : jointed<joints<Arm>, bodies<Bob>, loads<rope>> {};
void f() { use<System>(); }
} // namespace q9

// expect: the potential energy with q_Arm contains a velocity or derivative; it may contain only coordinates
namespace q10 {
struct System : jointed<joints<Arm>, loads<rope, potential_energy<tension_of<rope> * q_of<Arm>>>> {};
void f() { use<System>(); }
} // namespace q10

// expect: the motor between Arm and Ground uses friction_force_of<...> of the contact between Arm and
// expect: Ground, which the system does not list in loads<...>
namespace q11 {
struct System : jointed<joints<Arm>, loads<rope, motor<Arm, friction_force_of<touch>>>> {};
void f() { use<System>(); }
} // namespace q11

// expect: the force between Tip and Corner uses tension_of<...> of the force between Tip and Corner, which
// expect: the system does not list in loads<...>
namespace q12 {
struct System : jointed<joints<Arm>, loads<force_along<line, tension_of<force_along<line, T>>>>> {};
void f() { use<System>(); }
} // namespace q12

// expect: the normal force of the friction between Tip and Corner uses normal_force_of<...> of the contact
// expect: between Arm and Ground, which the system does not list in loads<...>
namespace q13 {
using self = friction<line, normal_force_of<touch>, viscous_friction<1>>;
struct System : jointed<joints<Arm>, loads<self>> {};
void f() { use<System>(); }
} // namespace q13

// expect: a contact between Arm and Arm is between a body and itself
namespace q14 {
struct System : jointed<joints<Arm>, loads<contact<sphere_on_sphere<Arm, 0.1, Arm, 0.2>, firm, thin>>> {};
void f() { use<System>(); }
} // namespace q14

// expect: the contact between Tip and Corner has a sphere_on_sphere<...> with neither no frame nor two
namespace q15 {
struct System
    : jointed<joints<Arm>, loads<contact<sphere_on_sphere<Tip, 0.1, Corner, 0.2, Arm>, firm, thin>>> {};
void f() { use<System>(); }
} // namespace q15

// expect: the contact between Arm and Ground has two laws of friction
namespace q16 {
struct System : jointed<joints<Arm>,
                        loads<contact<above, firm, thin, coulomb_friction<0.1, 0.1>, viscous_friction<1>>>> {
};
void f() { use<System>(); }
} // namespace q16

// expect: the contact between Arm and Ground has two rolling_resistance<...>
namespace q17 {
struct System
    : jointed<joints<Arm>,
              loads<contact<above, firm, thin, rolling_resistance<0.1, 0.1>, rolling_resistance<0.1, 0.1>>>> {
};
void f() { use<System>(); }
} // namespace q17

// expect: the contact between Arm and Ground has a coefficient of restitution that is not a number in (0, 1]
namespace q18 {
struct System : jointed<joints<Arm>, loads<contact<above, firm, thin, restitution<1.2, 0.5>>>> {};
void f() { use<System>(); }
} // namespace q18

// expect: the approach speed of the contact between Arm and Ground is not positive
namespace q19 {
struct System : jointed<joints<Arm>, loads<contact<above, firm, thin, restitution<0.5, 0.0>>>> {};
void f() { use<System>(); }
} // namespace q19

// expect: the stiffness of the contact between Arm and Ground is not positive
namespace q20 {
struct System : jointed<joints<Arm>, loads<contact<above, elastic<-5>, thin>>> {};
void f() { use<System>(); }
} // namespace q20

// expect: the normal of the contact between Tip and Ground is given in the axes of two frames; write it in
// expect: the axes of one
namespace q21 {
struct System
    : jointed<joints<Arm>, loads<contact<point_on_plane<Tip, Ground, Ground::z + Arm::x>, firm, thin>>> {};
void f() { use<System>(); }
} // namespace q21

// expect: the normal of the contact between Tip and Ground is zero
namespace q22 {
struct System
    : jointed<joints<Arm>, loads<contact<point_on_plane<Tip, Ground, 0.0 * Ground::z>, firm, thin>>> {};
void f() { use<System>(); }
} // namespace q22

// expect: the surface of the contact between Tip and Ground is a vector; it must be a scalar
namespace q23 {
struct System
    : jointed<joints<Arm>, loads<contact<point_on_surface<Tip, Ground, Ground, Ground::z>, firm, thin>>> {};
void f() { use<System>(); }
} // namespace q23

// expect: a contact between Corner and Ground is between a body and itself
namespace q24 {
struct System : jointed<joints<Arm>,
                        loads<contact<sphere_on_plane<Corner, 0.1, Ground, Ground::z, Ground>, firm, thin>>> {
};
void f() { use<System>(); }
} // namespace q24

// expect: the damping of the contact between Arm and Ground contains the speed u_Arm; it may contain only
// expect: parameters, inputs and time
namespace q25 {
struct System : jointed<joints<Arm>, loads<contact<above, firm, thin, dissipation<u_of<Arm>>>>> {};
void f() { use<System>(); }
} // namespace q25

// expect: the DC motor between Arm and Ground lacks an argument; write dc_motor<Joint, V, R, L, k, n, b,
// expect: J>
namespace q26 {
struct System : jointed<joints<Arm>, loads<dc_motor<Arm, T, 1, 1>>> {};
void f() { use<System>(); }
} // namespace q26

// expect: loads<...> lists dc_motor<...>, which is for a joint that turns about one axis or slides along one
namespace q27 {
struct Link : spherical<Link, Ground, mass> {};
struct System : jointed<joints<Link>, loads<dc_motor<Link, T, 1, 1, 1>>> {};
void f() { use<System>(); }
} // namespace q27

// expect: an expression uses length_of<...> of linear_spring<...>, which is a load, not a pathway
namespace q28 {
struct System : jointed<joints<Arm>, loads<motor<Arm, T>, rope>> {};
void f() { want<length_of<rope>, System>(); }
} // namespace q28

// expect: a pathway acts between point Tip and itself
namespace q29 {
struct System : jointed<joints<Arm>, loads<motor<Arm, T>, rope>> {};
void f() { want<length_of<straight<Tip, Tip>>, System>(); }
} // namespace q29

// expect: the contact between Arm and Ground is listed twice
namespace q30 {
struct System : jointed<joints<Arm>, loads<touch, touch>> {};
void f() { use<System>(); }
} // namespace q30

// expect: a configuration constraint uses length_of, which systems with reactions<...> do not support in
// expect: constraints; write magnitude(position_of<P, Q>)
namespace q31 {
struct Fore : pin<Fore, Arm, up, mass> {};
struct System : jointed<joints<Arm, Fore>, reactions<Arm>,
                        configuration_constraints<length_of<straight<Fore, Corner>> == 1.0>> {};
void f() { use<System>(); }
} // namespace q31

// expect: an expression uses lateral_force_of<...> of the contact between Arm and Ground, which is not a tyre
namespace q32 {
struct System : jointed<joints<Arm>, loads<motor<Arm, T>, touch>> {};
void f() { want<lateral_force_of<touch>, System>(); }
} // namespace q32

// expect: an expression uses friction_force_of<...> of the tyre between Arm and Ground, which is not a
// expect: contact
namespace q33 {
using rolls =
    tyre<thin_wheel<Arm, Arm::z, 0.3>, flat_ground<Ground, Ground::x>, linear_tyre<9, 9>, standstill<1>>;
struct System : jointed<joints<Arm>, loads<motor<Arm, T>, rolls>> {};
void f() { want<friction_force_of<rolls>, System>(); }
} // namespace q33

// expect: loads<...> lists stops<-1, 1, 50, 2>, which is an argument of a joint, such as pin<...>
namespace q34 {
struct System : jointed<joints<Arm>, loads<stops<-1, 1, 50, 2>>> {};
void f() { use<System>(); }
} // namespace q34

// expect: which is for a pathway, such as straight<P, Q>, or a joint that turns about one axis or slides
// expect: along one
namespace q35 {
struct System : jointed<joints<Arm>, loads<friction<Tip, 1, viscous_friction<2>>>> {};
void f() { use<System>(); }
} // namespace q35

// expect: the contact between Tip and Ground has a sphere whose center is a point; write its frame last, as
// expect: in sphere_on_plane<Center, radius, Place, normal, Frame>
namespace q36 {
using small = sphere_on_plane<Tip, 0.1, Ground, Ground::z>;
struct System : jointed<joints<Arm>, loads<contact<small, firm, thin>>> {};
void f() { use<System>(); }
} // namespace q36

// expect: joint Ball, which the contact between Ball and Ground uses, is not listed in joints<...>
namespace q37 {
struct Ball : floating<Ball, Ground, mass> {};
using small = sphere_on_plane<Ball, 0.1, Ground, Ground::z>;
struct System : jointed<joints<Arm>, loads<contact<small, firm, thin>>> {};
void f() { use<System>(); }
} // namespace q37
