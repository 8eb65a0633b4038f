// Joints with arguments given along axes that do not rotate with the parts in which they are fixed.
#include "joints.hpp"

// expect: joint Link is placed along axes that are not fixed in Arm
namespace p1 {
struct Link : pin<Link, Arm, axis<Arm::z>, at<l * Ground::x>, mass> {};
struct System : jointed<joints<Arm, Link>> {};
void f() { use<System>(); }
} // namespace p1

// expect: joint Link is placed along axes that are not fixed in Arm
namespace p2 {
struct Link : weld<Link, Arm, at<Arm::x + q_of<Arm>*(Ground::z + Ground::y), own::x>, mass> {};
struct System : jointed<joints<Arm, Link>> {};
void f() { use<System>(); }
} // namespace p2

// expect: joint Link is placed along axes that are not fixed in Ground
namespace p3 {
struct Link : prismatic<Link, Ground, axis<Ground::z>, at<l * Arm::x>, mass> {};
struct System : jointed<joints<Arm, Link>> {};
void f() { use<System>(); }
} // namespace p3

// expect: joint Link is placed along axes that are not fixed in A
namespace p4 {
struct A : rotated<A, Ground, q, Ground::z> {};
struct Link : spherical<Link, frame_and_point<A, Ground>, at<l * Ground::x>, mass> {};
struct System : jointed<coordinates<q>, speeds<u>, kinematics<dot(q) == u>, joints<Arm, Link>> {};
void f() { use<System>(); }
} // namespace p4

// expect: joint Link is placed along axes that are not fixed in Arm
namespace p5 {
struct P : offset<P, Arm, l * Ground::x> {};
struct Link : floating<Link, Arm, at<position_of<P, Ground>>, mass> {};
struct System : jointed<joints<Arm, Link>> {};
void f() { use<System>(); }
} // namespace p5

// expect: joint Link has a position in the child given in the axes of a different frame; write at<vector in
// expect: the parent, vector in its own axes>
namespace p6 {
struct P : offset<P, Arm, l * Ground::x> {};
struct Link : cylindrical<Link, Arm, up, at<l * Arm::x, position_of<P, Ground>>, mass> {};
struct System : jointed<joints<Arm, Link>> {};
void f() { use<System>(); }
} // namespace p6

// expect: joint Link has a mass center given in the axes of a different frame; write body<mass, vector in its
// expect: own axes, inertia>
namespace p7 {
struct P : offset<P, Arm, l * Ground::x> {};
struct Link : planar<Link, Arm, axis<own::x, own::y>, body<2, position_of<P, Ground>>> {};
struct System : jointed<joints<Arm, Link>> {};
void f() { use<System>(); }
} // namespace p7

// expect: frame Link_home is rotated about an axis that is not fixed in Arm
namespace p8 {
struct Link : screw<Link, Arm, up, pitch<l>, home<1, Ground::x>, mass> {};
struct System : jointed<joints<Arm, Link>> {};
void f() { use<System>(); }
} // namespace p8

// expect: joint Link has a second axis given in the axes of a frame other than its own; write universal<Self,
// expect: Parent, axis<vector in the parent, vector in the child>, by<two angles, two speeds>>
namespace p9 {
struct Link : universal<Link, Arm, axis<Arm::x, Arm::y>, mass> {};
struct System : jointed<joints<Arm, Link>> {};
void f() { use<System>(); }
} // namespace p9

// expect: joint Link has an axis that is not fixed in Arm
namespace p10 {
struct Link : planar<Link, Arm, axis<Arm::x, Ground::y>, mass> {};
struct System : jointed<joints<Arm, Link>> {};
void f() { use<System>(); }
} // namespace p10

// expect: a velocity constraint has a wheel axis that is not fixed in Wheel
namespace p11 {
struct Wheel : floating<Wheel, Ground, mass> {};
struct System : jointed<joints<Wheel>, velocity_constraints<rolls_on<Wheel, Ground, Ground::y, l>>> {};
void f() { use<System>(); }
} // namespace p11

// expect: a configuration constraint has a wheel axis that is not fixed in Wheel
namespace p12 {
struct Wheel : floating<Wheel, Ground, mass> {};
struct System
    : jointed<joints<Wheel>, configuration_constraints<touches<Wheel, Ground, Ground::y + Wheel::x, l>>> {};
void f() { use<System>(); }
} // namespace p12
