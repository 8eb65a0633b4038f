// Numbers that differ from what they appear to be.
#include "shapes.hpp"

// expect: the potential energy with k contains the factor 0, which is also the value of 1/2 in C++; write q/2
// expect: or rational<1, 2>*q, or 0.0 if you mean zero
namespace n1 {
struct System : loaded<potential_energy<1 / 2 * k * q * q>> {};
void f() { use<System>(); }
} // namespace n1

// expect: an inertia scalar of Rod contains the factor 0, which is also the value of 1/2 in C++; write q/2 or
// expect: rational<1, 2>*q, or 0.0 if you mean zero
namespace n2 {
struct Rod : rigid_body<Rod, P, A, m, inertia<A, 0, 1 / 12 * m * l * l, 1 / 12 * m * l * l>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n2

// expect: the offset of point Tip contains the factor 0, which is also the value of 1/2 in C++; write q/2 or
// expect: rational<1, 2>*q, or 0.0 if you mean zero
namespace n3 {
struct Tip : offset<Tip, O, 1 / 2 * l * A::x> {};
struct System : loaded<force<Tip, F * N::x>> {};
void f() { use<System>(); }
} // namespace n3

// expect: the offset of point Tip contains the factor 0, which is also the value of 1/2 in C++; write q/2 or
// expect: rational<1, 2>*q, or 0.0 if you mean zero
namespace n3v {
struct Tip : offset<Tip, O, 1 / 2 * A::x> {};
struct System : loaded<force<Tip, F * N::x>> {};
void f() { use<System>(); }
} // namespace n3v

// expect: the inertia of Rod contains the factor 0, which is also the value of 1/2 in C++; write q/2 or
// expect: rational<1, 2>*q, or 0.0 if you mean zero
namespace n3d {
struct Rod : rigid_body<Rod, P, A, m, inertia_dyadic<1 / 2 * outer(A::z, A::z)>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n3d

// expect: the force at P contains the factor 0, which is also the value of 1/2 in C++; write q/2 or
// expect: rational<1, 2>*q, or 0.0 if you mean zero
namespace n4 {
struct System : loaded<force<P, F * (1 / 2) * N::x>> {};
void f() { use<System>(); }
} // namespace n4

// expect: the torque on A contains the factor 0, which is also the value of 1/2 in C++; write q/2 or
// expect: rational<1, 2>*q, or 0.0 if you mean zero
namespace n5 {
struct System : loaded<torque<A, 1 / 2 / l * N::z>> {};
void f() { use<System>(); }
} // namespace n5

// expect: the torque on A contains the exponent 0, which is also the value of 1/2 in C++; write pow(x, 0.5)
namespace n6 {
struct System : loaded<torque<A, pow(T, 1 / 2) * N::z>> {};
void f() { use<System>(); }
} // namespace n6

// expect: the inertia of Rod is zero, which is also the value of 1/2 in C++; a body without inertia is a
// expect: particle<...>
namespace n7 {
struct Rod : rigid_body<Rod, P, A, m, inertia<A, 0, 1 / 12, 1 / 12>> {};
struct System : pendulum_with<Rod> {};
void f() { use<System>(); }
} // namespace n7

// expect: the potential energy is zero
namespace n8 {
struct System : loaded<potential_energy<1 / 2.0 - 0.5>> {};
void f() { use<System>(); }
} // namespace n8

// expect: the offset of point Tip uses ^; write pow(x, n) for a power
namespace n9 {
struct Tip : offset<Tip, O, l * q ^ 2 * A::x> {};
struct System : loaded<force<Tip, F * N::x>> {};
void f() { use<System>(); }
} // namespace n9

// expect: values<...> takes equations such as m == 2.5 for parameters, but contains a different expression
namespace n10 {
struct System : told<values<2.5>> {};
void f() { use<System>(); }
} // namespace n10

// expect: the mass of Bead is negative
namespace n11 {
struct Bead : particle<Bead, P, -abs(m)> {};
struct System : pendulum_with<Bead> {};
void f() { use<System>(); }
} // namespace n11

// expect: the mass of Bead is negative
namespace n12 {
struct Bead : particle<Bead, P, -m * exp(-l)> {};
struct System : pendulum_with<Bead> {};
void f() { use<System>(); }
} // namespace n12

// expect: a name that begins with a_parameter_with_a_n is longer than 60 characters
namespace n13 {
constexpr parameter<"a_parameter_with_a_name_of_58_letters_and_of_an_index_too_", 1234567> much;
struct Bead : particle<Bead, P, much> {};
struct System : pendulum_with<Bead> {};
void f() { use<System>(); }
} // namespace n13

// Cases in which the other side is a parameter.
namespace n14 {
struct System : told<loads<weight>, values<2 == m, 9.81 - 0.01 == g>> {};
using eom = equations_of_motion<System>;
static_assert(eom::parameters::SizeAtCompileTime == 1);
} // namespace n14

// expect: the value of parameter l is not a number: it contains m
namespace n15 {
struct System : told<loads<weight>, values<l == m>> {};
void f() { use<System>(); }
} // namespace n15

// expect: the potential energy contains the integer 0, which is also the value of 1/2 in C++; write 0.5 or
// expect: rational<1, 2>, or 0.0 if you mean zero
namespace n16 {
struct System : loaded<potential_energy<1 / 2>> {};
void f() { use<System>(); }
} // namespace n16

// expect: the stiffness of the torsional spring with q contains the integer 0, which is also the value of 1/2
// expect: in C++; write 0.5 or rational<1, 2>, or 0.0 if you mean zero
namespace n17 {
struct System : loaded<torsional_spring<q, 1 / 2>> {};
void f() { use<System>(); }
} // namespace n17

// expect: the rest angle of the torsional spring with q contains the integer 0, which is also the value of
// expect: 1/2 in C++; write 0.5 or rational<1, 2>, or 0.0 if you mean zero
namespace n18 {
struct System : loaded<torsional_spring<q, k, 1 / 2>> {};
void f() { use<System>(); }
} // namespace n18

// expect: the natural length of the spring between P and O contains the integer 0, which is also the value of
// expect: 1/2 in C++; write 0.5 or rational<1, 2>, or 0.0 if you mean zero
namespace n19 {
struct System : loaded<spring<P, O, k, 1 / 2>> {};
void f() { use<System>(); }
} // namespace n19

// expect: the damping of the damper between P and O contains the integer 0, which is also the value of 1/2 in
// expect: C++; write 0.5 or rational<1, 2>, or 0.0 if you mean zero
namespace n20 {
struct System : loaded<damper<P, O, 1 / 2>> {};
void f() { use<System>(); }
} // namespace n20

// expect: the torque on A contains the integer 0, which is also the value of 1/2 in C++; write 0.5 or
// expect: rational<1, 2>, or 0.0 if you mean zero
namespace n21 {
struct System : loaded<torque<A, clamp(T, -1 / 2, 1 / 2) * N::z>> {};
void f() { use<System>(); }
} // namespace n21

// expect: the torque on A contains the integer 0, which is also the value of 1/2 in C++; write 0.5 or
// expect: rational<1, 2>, or 0.0 if you mean zero
namespace n22 {
struct System : loaded<torque<A, tabulated<0, 1 / 2, 1, 1 / 3>(q) * N::z>> {};
void f() { use<System>(); }
} // namespace n22

// expect: the torque on A contains the integer 0, which is also the value of 1/2 in C++; write 0.5 or
// expect: rational<1, 2>, or 0.0 if you mean zero
namespace n23 {
struct System : loaded<torque<A, sin(q + 1 / 2) * N::z>> {};
void f() { use<System>(); }
} // namespace n23

// expect: the torque on A contains the integer 0, which is also the value of 1/2 in C++; write 0.5 or
// expect: rational<1, 2>, or 0.0 if you mean zero
namespace n24 {
struct System : loaded<torque<A, atan2(q, 1 / 2) * N::z>> {};
void f() { use<System>(); }
} // namespace n24

// expect: the value of parameter k contains the integer 0, which is also the value of 1/2 in C++; write 0.5
// expect: or rational<1, 2>, or 0.0 if you mean zero
namespace n25 {
struct System : told<loads<weight>, values<k == 1 / 2>> {};
void f() { use<System>(); }
} // namespace n25

// expect: the mass of Bead contains the integer 0, which is also the value of 1/2 in C++; write 0.5 or
// expect: rational<1, 2>, or 0.0 if you mean zero
namespace n26 {
struct Bead : particle<Bead, P, 1 / 2> {};
struct System : pendulum_with<Bead> {};
void f() { use<System>(); }
} // namespace n26

// expect: the angle of frame B contains the integer 0, which is also the value of 1/2 in C++; write 0.5 or
// expect: rational<1, 2>, or 0.0 if you mean zero
namespace n27 {
struct B : rotated<B, A, 1 / 2, A::z> {};
struct System : loaded<torque<B, T * N::z>> {};
void f() { use<System>(); }
} // namespace n27

// expect: the angle of frame B contains the integer 0, which is also the value of 1/2 in C++; write 0.5 or
// expect: rational<1, 2>, or 0.0 if you mean zero
namespace n28 {
struct B : body_fixed<B, A, "zyx", 1.5, 1 / 2, 0.0> {};
struct System : loaded<torque<B, T * N::z>> {};
void f() { use<System>(); }
} // namespace n28

// expect: the torque on A contains the integer 0, which is also the value of 1/2 in C++; write 0.5 or
// expect: rational<1, 2>, or 0.0 if you mean zero
namespace n29 {
struct System : loaded<torque<A, T * hypot(q, 1 / 2) * N::z>> {};
void f() { use<System>(); }
} // namespace n29

// expect: the potential energy with q contains a quoted character, which is not a number
namespace n30 {
struct System : loaded<potential_energy<'2' * k * q * q>> {};
void f() { use<System>(); }
} // namespace n30

// expect: the mass of Bead contains a quoted character, which is not a number
namespace n31 {
struct Bead : particle<Bead, P, '2'> {};
struct System : pendulum_with<Bead> {};
void f() { use<System>(); }
} // namespace n31

// expect: values<...> with k contains a quoted character, which is not a number
namespace n32 {
struct System : told<loads<torsional_spring<q, k>>, values<k == '2'>> {};
void f() { use<System>(); }
} // namespace n32

// expect: the force at P contains a quoted character, which is not a number
namespace n33 {
struct System : loaded<force<P, 'F' * N::x>> {};
void f() { use<System>(); }
} // namespace n33

// expect: the torque on A contains a quoted character, which is not a number
namespace n34 {
struct System : loaded<torque<A, T * pow(cos(q), '2') * N::z>> {};
void f() { use<System>(); }
} // namespace n34

// expect: the force at P contains true or false, which is not a number
namespace n35 {
struct System : loaded<force<P, true * N::x>> {};
void f() { use<System>(); }
} // namespace n35

// expect: the torque on A contains clamp with limits out of order; write clamp(x, least, most)
namespace n36 {
struct System : loaded<torque<A, clamp(T, 1.0, -1.0) * N::z>> {};
void f() { use<System>(); }
} // namespace n36

// expect: the torque on A contains clamp with limits out of order; write clamp(x, least, most)
namespace n37 {
struct System : told<loads<torque<A, clamp(T, -0.5, k) * N::z>>, values<k == -2>> {};
void f() { use<System>(); }
} // namespace n37
