// Joints with arguments that they do not take, or in places where joints do not belong.
#include "joints.hpp"

// expect: joint Link lacks an axis; write pin<Self, Parent, axis<vector>, by<coordinate, speed>>
namespace n1 {
struct Link : pin<Link, Ground, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n1

// expect: joint Link has too many axes; write pin<Self, Parent, axis<vector>, by<coordinate, speed>>
namespace n2 {
struct Link : pin<Link, Ground, axis<own::x, own::y>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n2

// expect: joint Link has too few or too many symbols; write pin<Self, Parent, axis<vector>, by<coordinate,
// expect: speed>>
namespace n3 {
struct Link : pin<Link, Ground, up, by<q>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n3

// expect: joint Link has too few or too many symbols; write cylindrical<Self, Parent, axis<vector>, by<angle,
// expect: displacement, their two speeds>>
namespace n4 {
struct Link : cylindrical<Link, Ground, up, by<q, u>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n4

// expect: joint Link has two positions; write at<vector in the parent, vector in its own axes>
namespace n5 {
struct Link : pin<Link, Ground, up, at<l * Ground::x>, at<l * own::x>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n5

// expect: joint Link has two homes
namespace n6 {
struct Link : pin<Link, Ground, up, home<1, Ground::x>, home<2, Ground::y>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n6

// expect: joint Link has axis<...> twice; write one list
namespace n7 {
struct Link : pin<Link, Ground, up, up, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n7

// expect: joint Link has by<...> twice; write one list
namespace n8 {
struct Link : pin<Link, Ground, up, by<q, u>, by<s, v>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n8

// expect: joint Link has two bodies; attach the second one with weld<...>
namespace n9 {
struct Link : pin<Link, Ground, up, mass, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n9

// expect: joint Link has at<...> with no vector or more than two; write at<vector in the parent, vector in
// expect: its own axes>
namespace n10 {
struct Link : pin<Link, Ground, up, at<l * Ground::x, l * own::x, l * own::y>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n10

// expect: joint Link has a home that is neither an angle and an axis, nor nine direction cosines, nor three
// expect: angles
namespace n11 {
struct Link : pin<Link, Ground, up, home<1, 2, 3>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n11

// expect: joint Link has a body with two inertias
namespace n12 {
struct Link : pin<Link, Ground, up, body<2, l * own::x, inertia<own, 1, 1, 1>, inertia<own, 1, 1, 1>>> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n12

// expect: joint Link has angles<...>, which belongs to a freely turning joint, spherical<...> or
// expect: floating<...>
namespace n13 {
struct Link : pin<Link, Ground, up, angles<"zxz">, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n13

// expect: joint Link has two sequences of angles
namespace n14 {
struct Link : spherical<Link, Ground, angles<"zxz">, angles<"xyz">, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n14

// expect: joint Link has too many axes; write spherical<Self, Parent, by<e1, e2, e3, e0, three speeds>>,
// expect: without an axis
namespace n15 {
struct Link : spherical<Link, Ground, up, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n15

// expect: joint Link has an argument that is not a word of a joint; the words are at<...>, axis<...>,
// expect: home<...>, by<...>, body<...>, stops<...> and rotor<...>
namespace n16 {
struct Link : pin<Link, Ground, up, inertia<own, 1, 1, 1>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n16

// expect: joint Link has an axis that is not a vector; write pin<Self, Parent, axis<vector>, by<coordinate,
// expect: speed>>
namespace n17 {
struct Link : pin<Link, Ground, axis<l>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n17

// expect: joint Link has an axis of zero length
namespace n18 {
struct Link : pin<Link, Ground, axis<0.0 * own::z>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n18

// expect: joint Link has a position that is not a vector; write at<vector in the parent, vector in
// expect: its own axes>
namespace n19 {
struct Link : pin<Link, Ground, up, at<l>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n19

// expect: joint Link has a mass center that is not a vector; write body<mass, vector in its own axes,
// expect: inertia>
namespace n20 {
struct Link : pin<Link, Ground, up, body<2, l>> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n20

// expect: frame Link_home has an invalid rotation sequence; use three axes, no two consecutive ones equal:
// expect: zxz
namespace n21 {
struct Link : pin<Link, Ground, up, home_angles<"zz", 1, 2, 3>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n21

// expect: the direction cosines of frame Link_home are not right-handed: they describe a reflection
namespace n22 {
struct Link : pin<Link, Ground, up, home<1, 0, 0, 0, 1, 0, 0, 0, -1>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n22

// expect: speed u is in the list of coordinates
namespace n23 {
struct Link : pin<Link, Ground, up, by<u, q>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n23

// expect: Link is declared as two joints; give each its own name
namespace n24 {
struct Link : pin<Link, Ground, up, mass>, weld<Link, Ground> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n24

// expect: a motion is declared for joint Link, whose kind determines how it moves
namespace n25 {
struct Link : pin<Link, Ground, up, mass>, angular_velocity<Ground, u * own::z> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n25

// expect: frame Link has two orientations
namespace n26 {
struct Link : pin<Link, Ground, up, mass>, rotated<Link, Ground, q, Ground::z> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n26

// expect: point Link has two positions
namespace n27 {
struct Link : pin<Link, Ground, up, mass>, offset<Link, Ground, l * Ground::x> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n27

// expect: Link inherits privately; declare it as a struct
namespace n28 {
class Link : pin<Link, Ground, up, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n28

// expect: joint Link names itself Arm; the first template argument of its base must be Link
namespace n29 {
struct Link : pin<Arm, Ground, up, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n29

// expect: joint Link is attached to itself
namespace n30 {
struct Link : pin<Link, Link, up, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n30

// expect: joint Arm, which Link uses, is not listed in joints<...>
namespace n31 {
struct Link : pin<Link, Arm, up, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n31

// expect: joint Link has an axis that is not fixed in Ground
namespace n32 {
struct Link : pin<Link, Ground, axis<Arm::x>, mass> {};
struct System : jointed<joints<Arm, Link>> {};
void f() { use<System>(); }
} // namespace n32

// expect: joint Arm is listed twice
namespace n33 {
struct System : jointed<joints<Arm, Arm>> {};
void f() { use<System>(); }
} // namespace n33

// expect: joints<...> lists Bob, which is a body; list it in bodies<...>
namespace n34 {
struct P : offset<P, Ground, l * Ground::x> {};
struct Bob : particle<Bob, P, m> {};
struct System : jointed<joints<Arm, Bob>> {};
void f() { use<System>(); }
} // namespace n34

// expect: joints<...> lists A, which is a frame; frames need not be listed
namespace n35 {
struct A : rotated<A, Ground, 1, Ground::x> {};
struct System : jointed<joints<Arm, A>> {};
void f() { use<System>(); }
} // namespace n35

// expect: joint Arm is among the words of System; write joints<Arm>
namespace n36 {
struct System : jointed<joints<Arm>, Arm> {};
void f() { use<System>(); }
} // namespace n36

// expect: bodies<...> lists Arm, which is a joint; list it in joints<...>
namespace n37 {
struct System : jointed<joints<Arm>, bodies<Arm>> {};
void f() { use<System>(); }
} // namespace n37

// expect: the system System has no bodies<...>
namespace n38 {
struct Link : pin<Link, Ground, up> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n38

// expect: the system System lists joints<...> twice; write one list
namespace n39 {
struct System : jointed<joints<Arm>, joints<Arm>> {};
void f() { use<System>(); }
} // namespace n39

// expect: joint Link is attached to A, which is a frame; write frame_and_point<frame, point>
namespace n40 {
struct A : rotated<A, Ground, 1, Ground::x> {};
struct Link : pin<Link, A, up, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n40

// expect: frame Other, which Link uses, is not connected to the inertial frame Ground
namespace n41 {
struct Other : inertial_ground<Other> {};
struct Link : pin<Link, Other, up, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n41

// expect: q is listed twice among the coordinates: by joint Link and by joint Next
namespace n42 {
struct Link : pin<Link, Ground, up, by<q, u>, mass> {};
struct Next : pin<Next, Link, up, by<q, v>, mass> {};
struct System : jointed<joints<Link, Next>> {};
void f() { use<System>(); }
} // namespace n42

// expect: joint Link lacks a pitch; write screw<Self, Parent, axis<vector>, pitch<advance per radian>,
// expect: by<coordinate, speed>>
namespace n43 {
struct Link : screw<Link, Ground, up, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n43

// expect: joint Link has pitch<...>, which belongs to a screw<...>
namespace n44 {
struct Link : pin<Link, Ground, up, pitch<l>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n44

// expect: joint Link has two pitches
namespace n45 {
struct Link : screw<Link, Ground, up, pitch<l>, pitch<l>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n45

// expect: joint Link has a position in the parent given in own axes; write at<vector in axes of the parent,
// expect: vector in its own axes>
namespace n46 {
struct Link : pin<Link, Ground, up, at<l * own::x>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n46

// expect: joint Link has a home given in own axes, which turn with it; write home<angle, axis of the parent>
namespace n47 {
struct Link : pin<Link, Ground, up, home<1, own::x>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n47

// expect: joint Link has a position in the child given in the axes of a different frame; write at<vector in
// expect: the parent, vector in its own axes>
namespace n48 {
struct Link : pin<Link, Ground, up, at<l * Ground::x, l * Ground::y>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n48

// expect: joint Link has a mass center given in the axes of a different frame; write body<mass, vector in its
// expect: own axes, inertia>
namespace n49 {
struct Link : pin<Link, Ground, up, body<2, l * Ground::x>> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n49

// expect: joint Link has a second parent; a joint has one, and a loop is closed by a constraint such as
// expect: coincident<...>
namespace n50 {
struct Link : pin<Link, Ground, Arm, up, mass> {};
struct System : jointed<joints<Arm, Link>> {};
void f() { use<System>(); }
} // namespace n50

// expect: joint Link has two parallel axes
namespace n51 {
struct Link : universal<Link, Ground, axis<Ground::z, 2 * own::z>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n51

// expect: joint Link has two parallel axes
namespace n52 {
struct Link : planar<Link, Ground, axis<own::x + own::y, l * own::x + l * own::y>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n52

// expect: joint Link has an axis of zero length
namespace n53 {
struct Link : prismatic<Link, Ground, axis<0.0 * Ground::x>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n53

// expect: joint Link has an axis that is not fixed in Ground
namespace n54 {
struct Link : prismatic<Link, Ground, axis<Arm::x>, mass> {};
struct System : jointed<joints<Arm, Link>> {};
void f() { use<System>(); }
} // namespace n54

// expect: joint Link is attached to P, which is a point; write frame_and_point<frame, point>
namespace n55 {
struct P : offset<P, Ground, l * Ground::x> {};
struct Link : pin<Link, P, up, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n55

// expect: joint Link is attached to Later, which is not a joint, or is defined later
namespace n56 {
struct Later;
struct Link : pin<Link, Later, axis<own::z>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n56

// expect: joint Link is attached to itself
namespace n57 {
struct Other;
struct Link : pin<Link, Other, up, mass> {};
struct Other : pin<Other, Link, up, mass> {};
struct System : jointed<joints<Link, Other>> {};
void f() { use<System>(); }
} // namespace n57

// expect: bodies<...> lists Arm, which is a joint; list it in joints<...>
namespace n58 {
struct System : jointed<bodies<Arm>> {};
void f() { use<System>(); }
} // namespace n58

// expect: speed u_Link moves no mass
namespace n59 {
struct Link : pin<Link, Arm, up> {}; // and nothing is attached to it
struct System : jointed<joints<Arm, Link>> {};
void f() { use<System>(); }
} // namespace n59

// expect: the mass of Link contains the integer 0, which is also the value of 1/2 in C++; write 0.5 or
// expect: rational<1, 2>, or 0.0 if you mean zero
namespace n60 {
struct Link : pin<Link, Ground, axis<Ground::z>, body<1 / 2>> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n60

// expect: the angle of frame Link_home contains the integer 0, which is also the value of 1/2 in C++; write
// expect: 0.5 or rational<1, 2>, or 0.0 if you mean zero
namespace n61 {
struct Link : pin<Link, Ground, axis<Ground::z>, home<1 / 2, Ground::z>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n61

// expect: the offset of point Link contains the integer 0, which is also the value of 1/2 in C++; write 0.5
// expect: or rational<1, 2>, or 0.0 if you mean zero
namespace n62 {
struct Link : screw<Link, Ground, axis<Ground::z>, pitch<1 / 2>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n62

// expect: joint Link has stops, but not exactly one coordinate
namespace n63 {
struct Link : universal<Link, Ground, axis<own::z, own::x>, stops<-1, 1, 100, 0.1>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n63

// expect: joint Link has stops<...> twice; write one list
namespace n64 {
struct Link : pin<Link, Ground, up, stops<-1, 1, 100, 0.1>, stops<-1, 1, 100, 0.1>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n64

// expect: joint Link has stops<...> with too few or too many values; write stops<least, greatest, stiffness,
// expect: damping, width>
namespace n65 {
struct Link : pin<Link, Ground, up, stops<-1, 1, 100>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n65

// expect: the greatest length of the stop with q_Link does not exceed the least length
namespace n66 {
struct Link : pin<Link, Ground, up, stops<1, -1, 100, 0.1>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n66

// expect: joint Link has two rotors
namespace n67 {
struct Link : pin<Link, Ground, up, rotor<0.1>, rotor<0.2>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n67

// expect: joint Link has rotor<...> with no inertia or too many values; write rotor<inertia, gear ratio>
namespace n68 {
struct Link : pin<Link, Ground, up, rotor<0.1, 50, 2>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n68

// expect: joint Link has a rotor, but not exactly one coordinate
namespace n69 {
struct Link : planar<Link, Ground, axis<own::x, own::y>, rotor<0.1, 50>, mass> {};
struct System : jointed<joints<Link>> {};
void f() { use<System>(); }
} // namespace n69

// expect: the linear spring acts along Link, which is a joint with more than one coordinate or none, not a
// expect: pathway; write straight<P, Q>, for example
namespace n70 {
struct Link : planar<Link, Ground, axis<own::x, own::y>, mass> {};
struct System : jointed<joints<Link>, loads<linear_spring<Link, 3>>> {};
void f() { use<System>(); }
} // namespace n70
