// Operators that C++ provides but models do not support.
#include "shapes.hpp"

// expect: a kinematic differential equation with q uses =; write equations with ==
namespace n1 {
struct System : moved_by<(dot(q) = u)> {};
void f() { use<System>(); }
} // namespace n1

// expect: values<...> with m uses =; write equations with ==
namespace n2 {
struct System : told<values<(m = 2)>> {};
void f() { use<System>(); }
} // namespace n2

// expect: the force at P uses ^; write pow(x, n) for a power
namespace n3 {
struct System : loaded<force<P, (q ^ 2) * N::x>> {};
void f() { use<System>(); }
} // namespace n3

// expect: the torque on A uses ^; write pow(x, n) for a power
namespace n4 {
struct System : loaded<torque<A, -c*(u ^ 3) * N::z>> {};
void f() { use<System>(); }
} // namespace n4

// expect: the force between P and O uses %; models have no remainder operator
namespace n5 {
struct System : loaded<force_between<P, O, (q % 2) * N::x>> {};
void f() { use<System>(); }
} // namespace n5

// expect: the stiffness of the spring between P and O uses !; a model contains numbers and vectors, not truth
// expect: values
namespace n6 {
struct System : loaded<spring<P, O, !q>> {};
void f() { use<System>(); }
} // namespace n6

// expect: a kinematic differential equation with q uses !; a model contains numbers and vectors, not truth
// expect: values
namespace n7 {
struct System : moved_by<!(dot(q) == u)> {};
void f() { use<System>(); }
} // namespace n7

// expect: the damping of the damper between P and O uses !=, <, >, <= or >=; models have only equations,
// expect: written with ==
namespace n8 {
struct System : loaded<damper<P, O, (u > 0)>> {};
void f() { use<System>(); }
} // namespace n8

// expect: a kinematic differential equation with q uses !=, <, >, <= or >=; models have only equations,
// expect: written with ==
namespace n9 {
struct System : moved_by<(dot(q) != u)> {};
void f() { use<System>(); }
} // namespace n9

// expect: a configuration constraint with s uses !=, <, >, <= or >=; models have only equations, written with
// expect: ==
namespace n10 {
struct System : bound_pendulum<configuration_constraints<(s >= 0)>> {};
void f() { use<System>(); }
} // namespace n10

// expect: a velocity constraint with u uses && or ||; list equations separately, with commas between them
namespace n11 {
struct System : bound_by<u == 0 && v == 0> {};
void f() { use<System>(); }
} // namespace n11

// expect: the torque on A contains == inside an expression; use it only once, at the outermost level
namespace n12 {
struct System : loaded<torque<A, (q == 0) * T * N::z>> {};
void f() { use<System>(); }
} // namespace n12

// expect: a kinematic differential equation with q contains == inside an expression; use it only once, at the
// expect: outermost level
namespace n13 {
struct System : moved_by<dot(q) == u == 0> {};
void f() { use<System>(); }
} // namespace n13

// expect: the torque between A and N uses an unsupported operator
namespace n14 {
struct System : loaded<torque_between<A, N, (T | 1) * N::z>> {};
void f() { use<System>(); }
} // namespace n14

// expect: a kinematic differential equation with q uses an operator that modifies a symbol, such as +=
namespace n15 {
struct System : moved_by<(q += u)> {};
void f() { use<System>(); }
} // namespace n15

// expect: the damping of the damper between P and Q uses an operator that modifies a symbol, such as +=
namespace n16 {
struct System : loaded<damper<P, Q, ++c>> {};
void f() { use<System>(); }
} // namespace n16

// expect: the force at O contains true or false, which is not a number
namespace n17 {
struct System : loaded<force<O, (F + true) * N::x>> {};
void f() { use<System>(); }
} // namespace n17

// expect: a velocity constraint with v uses =; write equations with ==
namespace n18 {
struct System : bound_by<(v = u)> {};
void f() { use<System>(); }
} // namespace n18

// expect: the mass of Ball uses ^; write pow(x, n) for a power
namespace n19 {
struct Ball : particle<Ball, P, m ^ 2> {};
struct System : pendulum_with<Ball> {};
void f() { use<System>(); }
} // namespace n19

// expect: the angle of frame B uses =; write equations with ==
namespace n20 {
struct B : rotated<B, N, (q = 2), N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n20

// expect: the offset of point G uses !=, <, >, <= or >=; models have only equations, written with ==
namespace n21 {
struct G : offset<G, O, (q < l) * A::x> {};
struct Ball : particle<Ball, G, m> {};
struct System : pendulum_with<Ball> {};
void f() { use<System>(); }
} // namespace n21

// expect: the force at P uses [ ]; the quantities of a model have no entries
namespace n22 {
struct System : loaded<force<P, q[0] * N::x>> {};
void f() { use<System>(); }
} // namespace n22

// expect: the force at P calls an expression like a function, as in q(t); write q
namespace n23 {
struct System : loaded<force<P, q(t) * N::x>> {};
void f() { use<System>(); }
} // namespace n23

// expect: the torque on A calls an expression like a function, as in q(t); write q
namespace n24 {
struct System : loaded<torque<A, N::z(q)>> {};
void f() { use<System>(); }
} // namespace n24

// expect: the force at Q calls dot or cross with more than two arguments
namespace n25 {
struct System : loaded<force<Q, cross(N::x, N::y, N::z)>> {};
void f() { use<System>(); }
} // namespace n25

// expect: the damping of the damper between P and O uses !=, <, >, <= or >=; models have only equations,
// expect: written with ==
namespace n26 {
struct System : loaded<damper<P, O, (u <=> q)>> {};
void f() { use<System>(); }
} // namespace n26
