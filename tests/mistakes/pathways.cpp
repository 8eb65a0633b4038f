// Pathways and the loads along them that are incomplete or meaningless.
#include "joints.hpp"

#include <kanexpr/contact.hpp>

struct Tip : offset<Tip, Arm, l * Arm::x> {};
struct Corner : offset<Corner, Ground, 0.7 * Ground::x + 0.4 * Ground::y> {};
using line = straight<Tip, Corner>;

// expect: the force between Tip and Corner lacks an argument; write force_along<Path, tension>
namespace p1 {
struct System : jointed<joints<Arm>, loads<force_along<line>>> {};
void f() { use<System>(); }
} // namespace p1

// expect: the linear spring between Tip and Corner has too many arguments; write linear_spring<Path,
// expect: stiffness, natural length>
namespace p2 {
struct System : jointed<joints<Arm>, loads<linear_spring<line, 1, 2, 3>>> {};
void f() { use<System>(); }
} // namespace p2

// expect: the damping of the linear damper between Tip and Corner is a vector; it must be a scalar
namespace p3 {
struct System : jointed<joints<Arm>, loads<linear_damper<line, Ground::x>>> {};
void f() { use<System>(); }
} // namespace p3

// expect: the stop between Tip and Corner lacks an argument; write stop<Path, least, greatest, stiffness,
// expect: damping, width>
namespace p4 {
struct System : jointed<joints<Arm>, loads<stop<line, 0.5, 1.5, 100>>> {};
void f() { use<System>(); }
} // namespace p4

// expect: the width of the stop between Tip and Corner is not positive
namespace p5 {
struct System : jointed<joints<Arm>, loads<stop<line, 0.5, 1.5, 100, 0.1, 0.0>>> {};
void f() { use<System>(); }
} // namespace p5

// expect: the surface of the force between Tip and Corner has no positive radius
namespace p6 {
using around = around_sphere<Ground, -0.2, Tip, Corner>;
struct System : jointed<joints<Arm>, loads<force_along<around, T>>> {};
void f() { use<System>(); }
} // namespace p6

// expect: the surface of the force between Tip and Corner has no positive angle
namespace p7 {
using around = around_cone<Ground, Ground, Ground::z, 0.0, Tip, Corner, wrapping::clockwise>;
struct System : jointed<joints<Arm>, loads<force_along<around, T>>> {};
void f() { use<System>(); }
} // namespace p7

// expect: the axis of the force between Tip and Corner is a scalar; it must be a vector
namespace p8 {
using around = around_cylinder<Ground, Ground, l, 0.2, Tip, Corner, wrapping::clockwise>;
struct System : jointed<joints<Arm>, loads<force_along<around, T>>> {};
void f() { use<System>(); }
} // namespace p8

// expect: the force between Tip and Corner is wrapped around an axis of zero length
namespace p9 {
using around = around_cylinder<Ground, Ground, Ground::z - Ground::z, 0.2, Tip, Corner, wrapping::clockwise>;
struct System : jointed<joints<Arm>, loads<force_along<around, T>>> {};
void f() { use<System>(); }
} // namespace p9

// expect: the surface of the force between Tip and Corner contains the coordinate q_Arm; it may contain only
// expect: parameters
namespace p10 {
using around = around_cylinder<Ground, Ground, Ground::z, 0.1 * q_of<Arm>, Tip, Corner, wrapping::clockwise>;
struct System : jointed<joints<Arm>, loads<force_along<around, T>>> {};
void f() { use<System>(); }
} // namespace p10

// expect: the pathway of the force lacks an argument; write given_length<scalar>
namespace p11 {
struct System : jointed<joints<Arm>, loads<force_along<given_length<>, T>>> {};
void f() { use<System>(); }
} // namespace p11

// expect: the linear spring acts along Link, which is a joint with more than one coordinate or none, not a
// expect: pathway; write straight<P, Q>, for example
namespace p12 {
struct Link : spherical<Link, Ground, mass> {};
struct System : jointed<joints<Link>, loads<linear_spring<Link, 3>>> {};
void f() { use<System>(); }
} // namespace p12

// expect: joint Link has stops, but not exactly one coordinate
namespace p13 {
struct Link : spherical<Link, Ground, mass, stops<-1, 1, 10.0, 0.1>> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace p13

// expect: the greatest length of the stop with q_Link does not exceed the least length
namespace p14 {
struct Link : pin<Link, Ground, up, mass, stops<1, -1, 10.0, 0.1>> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace p14

// expect: joint Link has stops<...> with too few or too many values; write stops<least, greatest, stiffness,
// expect: damping, width>
namespace p15 {
struct Link : pin<Link, Ground, up, mass, stops<-1, 1>> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace p15

// expect: joint Link has rotor<...> with no inertia or too many values; write rotor<inertia, gear ratio>
namespace p16 {
struct Link : pin<Link, Ground, up, mass, rotor<>> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace p16

// expect: the rotor inertia of joint Link changes; it may contain only numbers and parameters
namespace p17 {
struct Link : pin<Link, Ground, up, mass, rotor<q_of<Arm>, 10>> {};
struct System : jointed<joints<Arm, Link>> {};
void f() { use<System>(); }
} // namespace p17

// expect: the friction between Tip and Corner has coulomb_friction<...> without a slip speed; only a contact
// expect: with restitution<...> has a default
namespace p18 {
struct System : jointed<joints<Arm>, loads<friction<line, 20, coulomb_friction<0.1>>>> {};
void f() { use<System>(); }
} // namespace p18

// expect: the normal force of the friction between Tip and Corner is a vector; it must be a scalar
namespace p19 {
struct System : jointed<joints<Arm>, loads<friction<line, Ground::x, viscous_friction<0.1>>>> {};
void f() { use<System>(); }
} // namespace p19

// expect: the slip speed of the friction between Tip and Corner is not positive
namespace p20 {
struct System : jointed<joints<Arm>, loads<friction<line, 2, coulomb_friction<0.1, -0.01>>>> {};
void f() { use<System>(); }
} // namespace p20

// expect: the slip speed of the friction between Tip and Corner contains the coordinate q_Arm; it may
// expect: contain only parameters, inputs and time
namespace p21 {
struct System : jointed<joints<Arm>, loads<friction<line, 2, coulomb_friction<0.1, q_of<Arm>>>>> {};
void f() { use<System>(); }
} // namespace p21

// expect: the friction between Arm and Ground lacks an argument; write stribeck_friction<static, dynamic,
// expect: slip speed, viscous>
namespace p22 {
struct System : jointed<joints<Arm>, loads<friction<Arm, 2, stribeck_friction<0.1, 0.2>>>> {};
void f() { use<System>(); }
} // namespace p22

// expect: the force between Tip and Corner contains the rate of speed u_Arm
namespace p23 {
struct System : jointed<joints<Arm>, loads<force_along<line, dot(u_of<Arm>)>>> {};
void f() { use<System>(); }
} // namespace p23

// expect: straight<Tip, Corner> is not a word of a system, but System lists it
namespace p24 {
struct System : jointed<joints<Arm>, line> {};
void f() { use<System>(); }
} // namespace p24

// expect: loads<...> lists straight<Tip, Corner>, which is a pathway; list a load along it, such as
// expect: force_along<path, tension>
namespace p25 {
struct System : jointed<joints<Arm>, loads<line>> {};
void f() { use<System>(); }
} // namespace p25

// expect: Tip, which the bushing between Arm and Tip uses as a frame, is a point
namespace p26 {
struct System : jointed<joints<Arm>, loads<bushing<Arm, Tip, 1, 1, 1, 2, 2, 2>>> {};
void f() { use<System>(); }
} // namespace p26

// expect: a stiffness of the bushing between Arm and Ground is a vector; it must be a scalar
namespace p27 {
struct System : jointed<joints<Arm>, loads<bushing<Arm, Ground, 1, 1, 1, 2, 2, Ground::x>>> {};
void f() { use<System>(); }
} // namespace p27
