// Motors, constraints, reactions and kinematic equations of joints that are meaningless.
#include "joints.hpp"

// expect: which is for a joint that turns about one axis or slides along one
namespace n1 {
struct Link : spherical<Link, Ground, mass> {};
struct System : jointed<joints<Link>, loads<motor<Link>>> {};
void f() { use<System>(); }
} // namespace n1

// expect: the motor between Arm and Ground multiplies a vector by a vector; write dot, cross or
// expect: outer
namespace n2 {
struct System : jointed<joints<Arm>, loads<motor<Arm, T * Arm::z>>> {};
void f() { use<System>(); }
} // namespace n2

// expect: the motor between Arm and Ground has too many arguments; write motor<Joint, torque or force>
namespace n3 {
struct System : jointed<joints<Arm>, loads<motor<Arm, T, T>>> {};
void f() { use<System>(); }
} // namespace n3

// expect: the friction between Arm and Ground lacks an argument; write joint_friction<Joint, damping>
namespace n4 {
struct System : jointed<joints<Arm>, loads<joint_friction<Arm>>> {};
void f() { use<System>(); }
} // namespace n4

// expect: loads<...> lists motor<Ground>, which is for a joint that turns about one axis or slides
// expect: along one
namespace n5 {
struct System : jointed<joints<Arm>, loads<motor<Ground>>> {};
void f() { use<System>(); }
} // namespace n5

// expect: a configuration constraint with Link couples something other than two joints that each turn
// expect: about one axis or slide along one
namespace n6 {
struct Link : spherical<Link, Ground, mass> {};
struct System : jointed<joints<Arm, Link>, configuration_constraints<gear<Link, Arm, 2>>> {};
void f() { use<System>(); }
} // namespace n6

// expect: a configuration constraint couples something other than two joints that each turn about one axis
// expect: or slide along one
namespace n7 {
struct System : jointed<joints<Arm>, configuration_constraints<rack_and_pinion<Ground, Arm, l>>> {};
void f() { use<System>(); }
} // namespace n7

// expect: zero_along<...> of a configuration constraint with Arm has no direction
namespace n8 {
struct System : jointed<joints<Arm>, configuration_constraints<coincident<Arm, Ground>>> {};
void f() { use<System>(); }
} // namespace n8

// expect: reactions are requested for Ground, which is not a joint
namespace n9 {
struct System : jointed<joints<Arm>, reactions<Ground>> {};
void f() { use<System>(); }
} // namespace n9

// expect: reactions are requested for joint Link, which is not listed in joints<...>
namespace n10 {
struct Link : pin<Link, Ground, up, mass> {};
struct System : jointed<joints<Arm>, reactions<Link>> {};
void f() { use<System>(); }
} // namespace n10

// expect: kinematics<simple> finds 1 coordinate and 2 speeds that appear in no other kinematic differential
// expect: equation; the numbers must be equal
namespace n11 {
struct P : offset<P, Ground, s * Ground::x> {};
struct Bob : particle<Bob, P, m> {};
struct System : jointed<coordinates<s>, speeds<v, u>, kinematics<simple>, bodies<Bob>> {};
void f() { use<System>(); }
} // namespace n11

// expect: kinematics<simple> has no coordinate left; all coordinates already have equations
namespace n12 {
struct System : jointed<joints<Arm>, kinematics<simple>> {};
void f() { use<System>(); }
} // namespace n12

// expect: kinematics<...> contains simple twice
namespace n13 {
struct P : offset<P, Ground, s * Ground::x> {};
struct Bob : particle<Bob, P, m> {};
struct System : jointed<coordinates<s>, speeds<v>, kinematics<simple, simple>, bodies<Bob>> {};
void f() { use<System>(); }
} // namespace n13

// expect: velocity_constraints<...> contains something that is not an equation; write an equation or
// expect: zero_along<...>
namespace n14 {
struct System : jointed<joints<Arm>, velocity_constraints<simple>> {};
void f() { use<System>(); }
} // namespace n14

// expect: the system System has reactions<...>; the only speeds of a lagrange_system are the rates of its
// expect: coordinates
namespace n15 {
struct System : lagrange_system<inertial<Ground>, joints<Arm>, reactions<Arm>> {};
void f() { use<System>(); }
} // namespace n15

// expect: the friction between Arm and Ground contains the speed u_Arm; the only speeds of a lagrange_system
// expect: are the rates of its coordinates
namespace n16 {
struct System : lagrange_system<inertial<Ground>, joints<Arm>, loads<joint_friction<Arm, l>>> {};
void f() { use<System>(); }
} // namespace n16

// expect: a configuration constraint with Arm couples a joint with itself
namespace n17 {
struct System : jointed<joints<Arm>, configuration_constraints<gear<Arm, Arm, 2>>> {};
void f() { use<System>(); }
} // namespace n17

// expect: a configuration constraint contains the velocity of Wheel; move it to velocity_constraints<...>
namespace n18 {
struct Wheel : floating<Wheel, Ground, mass> {};
struct System : jointed<joints<Wheel>, configuration_constraints<rolls_on<Wheel, Ground, Wheel::y, l>>> {};
void f() { use<System>(); }
} // namespace n18

// expect: the motor between Arm and Ground is listed twice
namespace n19 {
struct System : jointed<joints<Arm>, loads<motor<Arm, T>, motor<Arm, T>>> {};
void f() { use<System>(); }
} // namespace n19

// expect: a configuration constraint keeps a direction parallel to something other than an axis of a frame;
// expect: write parallel<A::z, B::z>
namespace n20 {
struct System : jointed<joints<Arm>, configuration_constraints<parallel<Arm::x, l * Ground::x>>> {};
void f() { use<System>(); }
} // namespace n20

// expect: a velocity constraint with Wheel contains a negative radius or length
namespace n21 {
struct Wheel : floating<Wheel, Ground, mass> {};
struct System : jointed<joints<Wheel>, velocity_constraints<rolls_on<Wheel, Ground, Wheel::y, -0.3>>> {};
void f() { use<System>(); }
} // namespace n21

// expect: a velocity constraint with Wheel contains the integer 0, which is also the value of 1/2 in C++;
// expect: write 0.5 or rational<1, 2>, or 0.0 if you mean zero
namespace n22 {
struct Wheel : floating<Wheel, Ground, mass> {};
struct System : jointed<joints<Wheel>, velocity_constraints<rolls_on<Wheel, Ground, Wheel::y, 1 / 2>>> {};
void f() { use<System>(); }
} // namespace n22

// expect: the velocity of point P is declared in Ground, across joint Cart, whose reactions are requested;
// expect: declare it in Cart
namespace n23 {
struct Cart : prismatic<Cart, Ground, axis<own::x>, mass> {};
struct P : offset<P, Cart, s * Ground::y>, velocity<Ground, u_of<Cart> * Ground::x + v * Ground::y> {};
struct Bob : particle<Bob, P, m> {};
struct System : jointed<joints<Cart>, coordinates<s>, speeds<v>, kinematics<dot(s) == v>, bodies<Bob>,
                        reactions<Cart>> {};
void f() { use<System>(); }
} // namespace n23

// expect: the angular velocity of frame A is declared in Ground, across joint Arm, whose reactions are
// expect: requested; declare it in Arm
namespace n24 {
struct A : rotated<A, Arm, q, Arm::z>, angular_velocity<Ground, (u + u_of<Arm>)*Arm::z> {};
struct Rotor : rigid_body<Rotor, Ground, A, m, inertia<A, 1, 1, 1>> {};
struct System : jointed<joints<Arm>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Rotor>,
                        reactions<Arm>> {};
void f() { use<System>(); }
} // namespace n24

// expect: the torque on Arm repeats the torque between Arm and Ground
namespace n25 {
struct System : jointed<joints<Arm>, loads<motor<Arm, T>, torque<Arm, T * Arm::z>>> {};
void f() { use<System>(); }
} // namespace n25

// expect: the force at Sled repeats the force between Sled and Ground
namespace n26 {
struct Sled : prismatic<Sled, Ground, axis<Ground::x>, mass> {};
struct System : jointed<joints<Sled>, loads<motor<Sled, T>, force<Sled, T * Ground::x>>> {};
void f() { use<System>(); }
} // namespace n26

// expect: a velocity constraint with Wheel contains a negative radius or length
namespace n27 {
struct Wheel : floating<Wheel, Ground, mass> {};
struct System
    : jointed<joints<Wheel>, velocity_constraints<rolls_on<Wheel, Ground, Wheel::y, rational<-1, 2>>>> {};
void f() { use<System>(); }
} // namespace n27

// expect: a configuration constraint with l contains a negative radius or length
namespace n28 {
struct Wheel : floating<Wheel, Ground, mass> {};
struct System : jointed<joints<Wheel>, configuration_constraints<touches<Wheel, Ground, Wheel::y, l>>,
                        values<l == -0.3>> {};
void f() { use<System>(); }
} // namespace n28

// expect: a configuration constraint with P contains a negative radius or length
namespace n29 {
struct P : offset<P, Arm, 0.4 * Arm::x> {};
struct Sled : prismatic<Sled, Ground, axis<Ground::x>, mass> {};
struct System
    : jointed<joints<Arm, Sled>, configuration_constraints<rod_of_length<P, Sled, -rational<1, 2>>>> {};
void f() { use<System>(); }
} // namespace n29

// expect: the stiffness of the stop with q_Link is k [N/m], but must be in N m/rad
namespace n30 {
constexpr parameter<"k", units::si::newton / units::si::meter> k;
struct Link : pin<Link, Ground, up, stops<-1.0, 2.0, k, 0.1>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n30

// expect: the angle of frame Link_rotor is r*q_Link [m rad], but must be in rad
namespace n31 {
constexpr parameter<"r", units::si::meter> r;
struct Link : pin<Link, Ground, up, rotor<0.1, r>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n31
