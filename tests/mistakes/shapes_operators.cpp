// Operators that C++ has and models do not.
#include "shapes.hpp"

// expect: a kinematic differential equation with q is written with =; an equation is written with ==
namespace n1 {
struct System : moved_by<(dot(q) = u)> {};
void f() { use<System>(); }
} // namespace n1

// expect: values<...> with m is written with =; an equation is written with ==
namespace n2 {
struct System : told<values<(m = 2)>> {};
void f() { use<System>(); }
} // namespace n2

// expect: the force at P is written with ^; a power is written pow(x, n)
namespace n3 {
struct System : loaded<force<P, (q ^ 2) * N::x>> {};
void f() { use<System>(); }
} // namespace n3

// expect: the torque on A is written with ^; a power is written pow(x, n)
namespace n4 {
struct System : loaded<torque<A, -c*(u ^ 3) * N::z>> {};
void f() { use<System>(); }
} // namespace n4

// expect: the force between P and O is written with %; models have no remainders
namespace n5 {
struct System : loaded<force_between<P, O, (q % 2) * N::x>> {};
void f() { use<System>(); }
} // namespace n5

// expect: the stiffness of the spring between P and O is written with !; a model holds numbers and vectors,
// expect: not truth values
namespace n6 {
struct System : loaded<spring<P, O, !q>> {};
void f() { use<System>(); }
} // namespace n6

// expect: a kinematic differential equation with q is written with !; a model holds numbers and vectors, not
// expect: truth values
namespace n7 {
struct System : moved_by<!(dot(q) == u)> {};
void f() { use<System>(); }
} // namespace n7

// expect: the damping of the damper between P and O is written with !=, <, >, <= or >=; models have
// expect: equations only, with ==
namespace n8 {
struct System : loaded<damper<P, O, (u > 0)>> {};
void f() { use<System>(); }
} // namespace n8

// expect: a kinematic differential equation with q is written with !=, <, >, <= or >=; models have equations
// expect: only, with ==
namespace n9 {
struct System : moved_by<(dot(q) != u)> {};
void f() { use<System>(); }
} // namespace n9

// expect: a configuration constraint with s is written with !=, <, >, <= or >=; models have equations only,
// expect: with ==
namespace n10 {
struct System : bound_pendulum<configuration_constraints<(s >= 0)>> {};
void f() { use<System>(); }
} // namespace n10

// expect: a velocity constraint with u is written with && or ||; equations are written one by one, between
// expect: commas
namespace n11 {
struct System : bound_by<u == 0 && v == 0> {};
void f() { use<System>(); }
} // namespace n11

// expect: the torque on A holds == inside an expression; write it once, outermost
namespace n12 {
struct System : loaded<torque<A, (q == 0) * T * N::z>> {};
void f() { use<System>(); }
} // namespace n12

// expect: a kinematic differential equation with q holds == inside an expression; write it once,
// expect: outermost
namespace n13 {
struct System : moved_by<dot(q) == u == 0> {};
void f() { use<System>(); }
} // namespace n13

// expect: the torque between A and N is written with an operator that models do not have
namespace n14 {
struct System : loaded<torque_between<A, N, (T | 1) * N::z>> {};
void f() { use<System>(); }
} // namespace n14

// expect: a kinematic differential equation with q is written with an operator that changes a symbol, such
// expect: as +=
namespace n15 {
struct System : moved_by<(q += u)> {};
void f() { use<System>(); }
} // namespace n15

// expect: the damping of the damper between P and Q is written with an operator that changes a symbol, such
// expect: as +=
namespace n16 {
struct System : loaded<damper<P, Q, ++c>> {};
void f() { use<System>(); }
} // namespace n16

// expect: the force at O holds true or false, which is not a number
namespace n17 {
struct System : loaded<force<O, (F + true) * N::x>> {};
void f() { use<System>(); }
} // namespace n17

// expect: a velocity constraint with v is written with =; an equation is written with ==
namespace n18 {
struct System : bound_by<(v = u)> {};
void f() { use<System>(); }
} // namespace n18

// expect: the mass of Ball is written with ^; a power is written pow(x, n)
namespace n19 {
struct Ball : particle<Ball, P, m ^ 2> {};
struct System : pendulum_with<Ball> {};
void f() { use<System>(); }
} // namespace n19

// expect: the angle of frame B is written with =; an equation is written with ==
namespace n20 {
struct B : rotated<B, N, (q = 2), N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n20

// expect: the offset of point G is written with !=, <, >, <= or >=; models have equations only, with ==
namespace n21 {
struct G : offset<G, O, (q < l) * A::x> {};
struct Ball : particle<Ball, G, m> {};
struct System : pendulum_with<Ball> {};
void f() { use<System>(); }
} // namespace n21

// expect: the force at P is written with [ ]; what a model holds has no entries
namespace n22 {
struct System : loaded<force<P, q[0] * N::x>> {};
void f() { use<System>(); }
} // namespace n22

// expect: the force at P is written with arguments, as in q(t); symbols are written alone
namespace n23 {
struct System : loaded<force<P, q(t) * N::x>> {};
void f() { use<System>(); }
} // namespace n23

// expect: the torque on A is written with arguments, as in q(t); symbols are written alone
namespace n24 {
struct System : loaded<torque<A, N::z(q)>> {};
void f() { use<System>(); }
} // namespace n24

// expect: the force at Q takes a product of more than two vectors at once
namespace n25 {
struct System : loaded<force<Q, cross(N::x, N::y, N::z)>> {};
void f() { use<System>(); }
} // namespace n25

// expect: the damping of the damper between P and O is written with !=, <, >, <= or >=; models have
// expect: equations only, with ==
namespace n26 {
struct System : loaded<damper<P, O, (u <=> q)>> {};
void f() { use<System>(); }
} // namespace n26
