// Functions of arguments that they do not take.
#include "shapes.hpp"

// expect: the torque on A takes the cross product of a scalar and a scalar
namespace n1 {
struct System : loaded<torque<A, cross(q, u)>> {};
void f() { use<System>(); }
} // namespace n1

// expect: the torque between A and N takes the cross product of a vector and a scalar
namespace n2 {
struct System : loaded<torque_between<A, N, cross(N::x, q)>> {};
void f() { use<System>(); }
} // namespace n2

// expect: the force at P takes the dot product of a scalar and a scalar; write *
namespace n3 {
struct System : loaded<force<P, dot(q, u) * N::x>> {};
void f() { use<System>(); }
} // namespace n3

// expect: the force at O takes the dot product of a vector and a scalar
namespace n4 {
struct System : loaded<force<O, dot(N::x, 2) * N::x>> {};
void f() { use<System>(); }
} // namespace n4

// expect: the force between P and O takes the magnitude of a scalar; write abs
namespace n5 {
struct System : loaded<force_between<P, O, magnitude(q) * N::x>> {};
void f() { use<System>(); }
} // namespace n5

// expect: the force between P and Q normalizes a scalar
namespace n6 {
struct System : loaded<force_between<P, Q, normalized(q)>> {};
void f() { use<System>(); }
} // namespace n6

// expect: the stiffness of the spring between P and O applies sin to a vector
namespace n7 {
struct System : loaded<spring<P, O, sin(N::x)>> {};
void f() { use<System>(); }
} // namespace n7

// expect: the stiffness of the spring between P and Q applies sqrt to a vector
namespace n8 {
struct System : loaded<spring<P, Q, sqrt(q* N::x)>> {};
void f() { use<System>(); }
} // namespace n8

// expect: the stiffness of the spring between Q and O raises a vector to the power of a scalar; write dot(v,
// expect: v)
namespace n9 {
struct System : loaded<spring<Q, O, pow(N::x, 2)>> {};
void f() { use<System>(); }
} // namespace n9

// expect: the damping of the damper between P and O applies atan2 to a vector and a scalar
namespace n10 {
struct System : loaded<damper<P, O, atan2(N::x, q)>> {};
void f() { use<System>(); }
} // namespace n10

// expect: the potential energy with k applies dot to something that is not a coordinate, speed or prescribed
// expect: quantity
namespace n11 {
struct System : loaded<potential_energy<k * dot(q* q)>> {};
void f() { use<System>(); }
} // namespace n11

// expect: the damping of the damper between P and Q applies dot to something that is not a coordinate, speed
// expect: or prescribed quantity
namespace n12 {
struct System : loaded<damper<P, Q, dot(m)>> {};
void f() { use<System>(); }
} // namespace n12

// expect: the torque on N applies dot to something that is not a coordinate, speed or prescribed quantity
namespace n13 {
struct System : loaded<torque<N, dot(A::x) * N::z>> {};
void f() { use<System>(); }
} // namespace n13

// expect: a kinematic differential equation with q applies dot to something that is not a coordinate, speed
// expect: or prescribed quantity
namespace n14 {
struct System : moved_by<dot(q* q) == u> {};
void f() { use<System>(); }
} // namespace n14

// expect: the damping of the damper between Q and O uses an unsupported function; models support sqrt,
// expect: sin, cos, tan, asin, acos, atan, exp, log, sinh, cosh, tanh, abs, sign, cbrt, erf,
// expect: wrap_to_pi, atan2, pow, hypot, min, max and clamp
namespace n15 {
struct System : loaded<damper<Q, O, exp2(u)>> {};
void f() { use<System>(); }
} // namespace n15

// expect: the damping of the torsional damper between A and N uses an unsupported function
namespace n16 {
struct System : loaded<torsional_damper<A, N, fmod(u, c)>> {};
void f() { use<System>(); }
} // namespace n16

// expect: the damping of the torsional damper between N and A applies hypot to a vector
namespace n22 {
struct System : loaded<torsional_damper<N, A, hypot(u, A::x)>> {};
void f() { use<System>(); }
} // namespace n22

// expect: the torque on A calls clamp with 2 arguments; it takes 3
namespace n23 {
struct System : loaded<torque<A, clamp(q, u) * N::z>> {};
void f() { use<System>(); }
} // namespace n23

// expect: the force at P calls min with 1 argument; it takes 2
namespace n24 {
struct System : loaded<force<P, (min)(q)*N::x>> {};
void f() { use<System>(); }
} // namespace n24

// expect: the force at O contains == inside an expression; use it only once, at the outermost level
namespace n25 {
struct System : loaded<force<O, if_positive(q == 1, u, 2) * N::x>> {};
void f() { use<System>(); }
} // namespace n25

// expect: the stiffness of the spring between P and O applies if_positive to a dyadic
namespace n26 {
struct System : loaded<spring<P, O, if_positive(outer(N::x, N::x), q, 1)>> {};
void f() { use<System>(); }
} // namespace n26

// expect: the force between P and O applies smooth_step to a vector
namespace n28 {
struct System : loaded<force_between<P, O, smooth_step(N::x, 0, 1) * N::x>> {};
void f() { use<System>(); }
} // namespace n28

// expect: the force between P and Q calls softplus with 1 argument; it takes 2
namespace n29 {
struct System : loaded<force_between<P, Q, softplus(q) * N::x>> {};
void f() { use<System>(); }
} // namespace n29

// expect: the force at Q contains smooth_step of numbers for which it is undefined
namespace n30 {
struct System : loaded<force<Q, smooth_step(q, 1, 1) * N::x>> {};
void f() { use<System>(); }
} // namespace n30

// expect: the force at P contains tabulated<...> with 3 scalars; it takes two or more points, each an
// expect: argument and a value
namespace n31 {
struct System : loaded<force<P, tabulated<0, 1, 2>(q) * N::x>> {};
void f() { use<System>(); }
} // namespace n31

// expect: the force at O contains tabulated<...> whose arguments do not increase at point 3
namespace n32 {
struct System : loaded<force<O, tabulated<0, 1, 2, 1, 2, 0>(q) * N::x>> {};
void f() { use<System>(); }
} // namespace n32

// expect: the force at O contains periodic<...> whose last value differs from the first
namespace n34 {
struct System : loaded<force<O, periodic<0, 1, 2, 3, 4, 2>(q) * N::x>> {};
void f() { use<System>(); }
} // namespace n34

// expect: the force at P contains periodic<...> whose arguments do not increase at point 2
namespace n35 {
struct System : loaded<force<P, periodic<2, 1, 0, 3, 4, 1>(q) * N::x>> {};
void f() { use<System>(); }
} // namespace n35

// expect: the force at Q applies tabulated to a vector
namespace n33 {
struct System : loaded<force<Q, tabulated<0, 1, 2, 1>(N::x) * N::x>> {};
void f() { use<System>(); }
} // namespace n33

// expect: the stiffness of the spring between P and Q applies max to a vector
namespace n27 {
struct System : loaded<spring<P, Q, (max)(q, N::x)>> {};
void f() { use<System>(); }
} // namespace n27

// expect: the damping of the torsional damper between N and A applies tanh to a vector
namespace n21 {
struct System : loaded<torsional_damper<N, A, tanh(A::x)>> {};
void f() { use<System>(); }
} // namespace n21

// expect: the inertia of Rod takes the outer product of a vector and a scalar
namespace n17 {
struct Rod : rigid_body<Rod, P, A, m, inertia_dyadic<m * outer(A::x, l)>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n17

// expect: the inertia of Plate multiplies a dyadic by a dyadic; write dot, cross or outer
namespace n18 {
struct Plate : rigid_body<Plate, P, A, m, inertia_dyadic<outer(A::x, A::x) * outer(A::x, A::x)>> {};
struct System : pendulum_with<Plate> {};
void f() { use<System>(); }
} // namespace n18

// expect: the force at Q takes the dot product of a vector and a dyadic
namespace n19 {
struct System : loaded<force<Q, dot(N::x, outer(N::x, N::y))>> {};
void f() { use<System>(); }
} // namespace n19

// expect: the torsional spring with q takes the dot product of a scalar and a vector
namespace n20 {
struct System : loaded<torsional_spring<dot(q, N::x), k>> {};
void f() { use<System>(); }
} // namespace n20
