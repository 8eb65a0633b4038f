// Loads with too few, too many or wrong arguments.
#include "shapes.hpp"

// expect: the force at P lacks an argument; write force<Point, vector>
namespace n1 {
struct System : loaded<force<P>> {};
void f() { use<System>(); }
} // namespace n1

// expect: the force at P has too many arguments; write force<Point, vector>
namespace n2 {
struct System : loaded<force<P, F, N::x>> {};
void f() { use<System>(); }
} // namespace n2

// expect: the torque on A lacks an argument; write torque<Frame, vector>
namespace n3 {
struct System : loaded<torque<A>> {};
void f() { use<System>(); }
} // namespace n3

// expect: the torque on A has too many arguments; write torque<Frame, vector>
namespace n4 {
struct System : loaded<torque<A, T, N::z>> {};
void f() { use<System>(); }
} // namespace n4

// expect: gravity lacks an argument; write gravity<vector>
namespace n5 {
struct System : loaded<gravity<>> {};
void f() { use<System>(); }
} // namespace n5

// expect: gravity has too many arguments; write gravity<vector>
namespace n6 {
struct System : loaded<gravity<g, N::x>> {};
void f() { use<System>(); }
} // namespace n6

// expect: gravity is a scalar; it must be a vector
namespace n7 {
struct System : loaded<gravity<g>> {};
void f() { use<System>(); }
} // namespace n7

// expect: the spring between P and O lacks an argument; write spring<Point, Other, stiffness, natural
// expect: length>
namespace n8 {
struct System : loaded<spring<P, O>> {};
void f() { use<System>(); }
} // namespace n8

// expect: the spring between P and O has too many arguments; write spring<Point, Other, stiffness, natural
// expect: length>
namespace n9 {
struct System : loaded<spring<P, O, k, l, c>> {};
void f() { use<System>(); }
} // namespace n9

// expect: the damper between P and O lacks an argument; write damper<Point, Other, damping>
namespace n10 {
struct System : loaded<damper<P, O>> {};
void f() { use<System>(); }
} // namespace n10

// expect: the damper between P and O has too many arguments; write damper<Point, Other, damping>
namespace n11 {
struct System : loaded<damper<P, O, c, 0>> {};
void f() { use<System>(); }
} // namespace n11

// expect: the force between P and O lacks an argument; write force_between<Point, Other, vector>
namespace n12 {
struct System : loaded<force_between<P, O>> {};
void f() { use<System>(); }
} // namespace n12

// expect: the torque between A and N lacks an argument; write torque_between<Frame, Other, vector>
namespace n13 {
struct System : loaded<torque_between<A, N>> {};
void f() { use<System>(); }
} // namespace n13

// expect: the torque between A and N has too many arguments; write torque_between<Frame, Other, vector>
namespace n14 {
struct System : loaded<torque_between<A, N, T, N::z>> {};
void f() { use<System>(); }
} // namespace n14

// expect: the torsional spring with q lacks an argument; write torsional_spring<angle, stiffness, rest>
namespace n15 {
struct System : loaded<torsional_spring<q>> {};
void f() { use<System>(); }
} // namespace n15

// expect: the torsional spring with q has too many arguments; write torsional_spring<angle, stiffness, rest>
namespace n16 {
struct System : loaded<torsional_spring<q, k, 0, c>> {};
void f() { use<System>(); }
} // namespace n16

// expect: the torsional damper between A and N lacks an argument; write torsional_damper<Frame, Other,
// expect: damping>
namespace n17 {
struct System : loaded<torsional_damper<A, N>> {};
void f() { use<System>(); }
} // namespace n17

// expect: the potential energy lacks an argument; write potential_energy<scalar>
namespace n18 {
struct System : loaded<potential_energy<>> {};
void f() { use<System>(); }
} // namespace n18

// expect: the potential energy with k has too many arguments; write potential_energy<scalar>
namespace n19 {
struct System : loaded<potential_energy<k, q>> {};
void f() { use<System>(); }
} // namespace n19

// expect: loads<...> lists Bob, which is a body; list it in bodies<...>
namespace n20 {
struct System : loaded<weight, Bob> {};
void f() { use<System>(); }
} // namespace n20

// expect: loads<...> lists particle<...>, which is a body; list it in bodies<...>
namespace n21 {
struct System : loaded<particle<Bob, P, m>> {};
void f() { use<System>(); }
} // namespace n21

// expect: loads<...> lists N, which is a frame; frames need not be listed
namespace n22 {
struct System : loaded<N> {};
void f() { use<System>(); }
} // namespace n22

// expect: loads<...> lists P, which is a point; points need not be listed
namespace n23 {
struct System : loaded<P> {};
void f() { use<System>(); }
} // namespace n23

// expect: loads<...> lists loads<...>, which is a word of the system
namespace n24 {
struct System : loaded<loads<weight>> {};
void f() { use<System>(); }
} // namespace n24

// expect: Bob, which a force uses as a point, is a body; its point is P
namespace n25 {
struct System : loaded<force<Bob, F * N::x>> {};
void f() { use<System>(); }
} // namespace n25

// expect: O, which a torque uses as a frame, is a point
namespace n26 {
struct System : loaded<torque<O, T * N::z>> {};
void f() { use<System>(); }
} // namespace n26

// expect: the drag at P lacks an argument; write drag<Point, coefficient>
namespace n27 {
struct System : loaded<drag<P>> {};
void f() { use<System>(); }
} // namespace n27

// expect: the drag at Q has too many arguments; write drag<Point, coefficient>
namespace n28 {
struct System : loaded<drag<Q, c, k>> {};
void f() { use<System>(); }
} // namespace n28

// expect: A, which the drag at A uses as a point, is a frame
namespace n29 {
struct System : loaded<drag<A, c>> {};
void f() { use<System>(); }
} // namespace n29
