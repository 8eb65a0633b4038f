// Joints and constraints in which an argument is missing, or of the wrong kind.
#include "joints.hpp"

struct Fore : pin<Fore, Arm, up, mass> {};
struct Wheel : floating<Wheel, Ground, mass> {};
struct P : offset<P, Arm, l * Arm::x> {};
struct Bob : particle<Bob, P, m> {};

template <auto... constraints>
using placed = jointed<joints<Arm, Fore, Wheel>, configuration_constraints<constraints...>>;
template <auto... constraints>
using moving = jointed<joints<Arm, Fore, Wheel>, velocity_constraints<constraints...>>;

// expect: joint Link names itself Ground; the first template argument of its base must be Link
namespace n1 {
struct Link : pin<Ground, up, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n1

// expect: joint Link names itself Ground; the first template argument of its base must be Link
namespace n2 {
struct Link : weld<Ground, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n2

// expect: joint Link names itself Ground; the first template argument of its base must be Link
namespace n3 {
struct Link : pin<Ground, up, home<1, Ground::x>, at<l * Ground::x, l * own::x>, mass> {};
struct Next : floating<Next, Link, mass> {};
struct System : jointed<joints<Link, Next>, loads<motor<Link>, joint_friction<Link, l>>, reactions<Link>,
                        configuration_constraints<gear<Link, Arm, 2>>> {};
void f() { use<System>(); }
} // namespace n3

// expect: joint Link lacks a parent; write pin<Self, Parent, axis<vector>, by<coordinate, speed>>
namespace n4 {
struct Link : pin<Link, up, home<1, Ground::x>, at<l * Ground::x, l * own::x>, mass> {};
struct System : jointed<joints<Link>, loads<motor<Link>>, reactions<Link>> {};
void f() { use<System>(); }
} // namespace n4

// expect: joint Link lacks a parent; write weld<Self, Parent>, without axes or symbols
namespace n5 {
struct Link : weld<Link, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n5

// expect: two joints are called Link
namespace n6 {
namespace left {
struct Link : pin<Link, Ground, up, mass> {};
} // namespace left
namespace right {
struct Link : pin<Link, Ground, up, mass> {};
} // namespace right
struct System : jointed<joints<left::Link, right::Link>> {};
void f() { use<System>(); }
} // namespace n6

// expect: a configuration constraint with Arm uses q_of for a coordinate that the joint or beam does not have
namespace n7 {
struct System : placed<q_of<Arm, 2> == 0> {};
void f() { use<System>(); }
} // namespace n7

// expect: a velocity constraint with Arm uses u_of for a speed that the joint or beam does not have
namespace n8 {
struct System : moving<u_of<Arm, 2> == 0> {};
void f() { use<System>(); }
} // namespace n8

// expect: a configuration constraint uses q_of or u_of with something that is neither a joint nor a beam
namespace n9 {
struct System : placed<q_of<Ground> == 0> {};
void f() { use<System>(); }
} // namespace n9

// expect: a velocity constraint uses q_of or u_of with something that is neither a joint nor a beam
namespace n10 {
struct System : moving<u_of<P> == 0> {};
void f() { use<System>(); }
} // namespace n10

// expect: P, which a configuration constraint uses as a frame, is a point
namespace n11 {
struct System : placed<same_axes<Arm, P>> {};
void f() { use<System>(); }
} // namespace n11

// expect: Bob, which a configuration constraint uses as a frame, is a body
namespace n12 {
struct System : placed<same_axes<Bob, Arm>> {};
void f() { use<System>(); }
} // namespace n12

// expect: a configuration constraint with Arm lacks a frame; write same_axes<Frame, Other>
namespace n13 {
struct System : placed<same_axes<Arm>> {};
void f() { use<System>(); }
} // namespace n13

// expect: a configuration constraint with Arm has too few or too many arguments; write gear<Joint, Other,
// expect: ratio>
namespace n14 {
struct System : placed<gear<Arm, Fore>> {};
void f() { use<System>(); }
} // namespace n14

// expect: a configuration constraint with Arm has too few or too many arguments; write belt<Joint, Other,
// expect: radius, other radius>
namespace n15 {
struct System : placed<belt<Arm>> {};
void f() { use<System>(); }
} // namespace n15

// expect: a configuration constraint with Arm has too few or too many arguments; write
// expect: rack_and_pinion<Rack, Pinion, radius>
namespace n16 {
struct System : placed<rack_and_pinion<Arm, Fore, l, l>> {};
void f() { use<System>(); }
} // namespace n16

// expect: a velocity constraint with Wheel has too few or too many arguments; write rolls_on<Wheel, Ground,
// expect: axis, radius>
namespace n17 {
struct System : moving<rolls_on<Wheel, Ground, Wheel::y>> {};
void f() { use<System>(); }
} // namespace n17

// expect: a velocity constraint with Wheel has too few or too many arguments; write rolls_on<Wheel, Ground,
// expect: axis, radius>
namespace n18 {
struct System : moving<rolls_on<Wheel, Ground, Wheel::y, l, l, l>> {};
void f() { use<System>(); }
} // namespace n18

// expect: P, which a velocity constraint uses as a frame, is a point
namespace n19 {
struct System : moving<rolls_on<Wheel, P, Wheel::y, l>> {};
void f() { use<System>(); }
} // namespace n19

// expect: a configuration constraint with Wheel has too few or too many arguments; write touches<Wheel,
// expect: Ground, axis, radius>
namespace n20 {
struct System : placed<touches<Wheel, Ground>> {};
void f() { use<System>(); }
} // namespace n20

// expect: a configuration constraint with Arm has too few or too many arguments; write rod_of_length<Point,
// expect: Other, length>
namespace n21 {
struct System : placed<rod_of_length<Arm, Ground>> {};
void f() { use<System>(); }
} // namespace n21

// expect: a configuration constraint with Arm lacks a point; write coincident<Point, Other, directions>
namespace n22 {
struct System : placed<coincident<Arm>> {};
void f() { use<System>(); }
} // namespace n22

// expect: a configuration constraint has too few or too many arguments; write parallel<direction, axis of
// expect: a frame>
namespace n23 {
struct System : placed<parallel<Arm::z>> {};
void f() { use<System>(); }
} // namespace n23

// expect: velocity constraint 1 contains the coordinate q_Arm but no speed; move it to
// expect: configuration_constraints<...>
namespace n24 {
struct System : moving<gear<Arm, Fore, 2>> {};
void f() { use<System>(); }
} // namespace n24

// expect: velocity constraint 1 contains the coordinate p3_Wheel but no speed; move it to
// expect: configuration_constraints<...>
namespace n25 {
struct System : moving<touches<Wheel, Ground, Wheel::y, l>> {};
void f() { use<System>(); }
} // namespace n25
