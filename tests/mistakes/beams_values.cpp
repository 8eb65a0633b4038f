// Beams with impossible directions and properties, and sections at wrong places.
#include "beams.hpp"

// expect: beam B bends in a direction that is not perpendicular to its axis
namespace v1 {
struct B : beam<B, O, N::x, L, m, bending<N::x + N::y, EI, clamped_free<1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace v1

// expect: beam B bends in two directions that are not perpendicular to each other
namespace v2 {
struct B : beam<B, O, N::x, L, m, bends, bending<N::y + N::z, EI, clamped_free<1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace v2

// expect: beam B has an axis or a direction of bending that is not fixed in its frame
namespace v3 {
struct B : beam<B, O, cos(q) * N::x + sin(q) * N::z, L, m, bends> {};
struct System : system_of<coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<B>> {};
void f() { use<System>(); }
} // namespace v3

// expect: the length of beam B is not positive
namespace v4 {
struct B : beam<B, O, N::x, -2.0, m, bends> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace v4

// expect: the mass per length of beam B is not positive
namespace v5 {
struct B : beam<B, O, N::x, L, 0.0, bends> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace v5

// expect: the bending stiffness of beam B is not positive
namespace v6 {
struct B : beam<B, O, N::x, L, m, bending<N::y, -EI * 0.0, clamped_free<1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace v6

// expect: the bending stiffness of beam B may vary; it may contain only numbers and parameters
namespace v7 {
struct B : beam<B, O, N::x, L, m, bending<N::y, EI * F, clamped_free<1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace v7

// expect: the length of beam B is a vector; it must be a scalar
namespace v8 {
struct B : beam<B, O, N::x, L * N::x, m, bends> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace v8

// expect: the damping of beam B is negative
namespace v9 {
struct B : beam<B, O, N::x, L, m, bends, modal_damping<-0.1>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace v9

// expect: section S is not on beam Rod; its place is a fraction of the length, a number from 0 to 1
namespace v10 {
struct S : section<S, Rod, 1.2> {};
struct P : particle<P, S, m> {};
struct System : system_of<bodies<Rod, P>> {};
void f() { use<System>(); }
} // namespace v10

// expect: section S is not on beam Rod; its place is a fraction of the length, a number from 0 to 1
namespace v11 {
struct S : section<S, Rod, L> {};
struct P : particle<P, S, m> {};
struct System : system_of<bodies<Rod, P>> {};
void f() { use<System>(); }
} // namespace v11

// expect: section S is placed on N, which is not a beam
namespace v12 {
struct S : section<S, N, 1> {};
struct P : particle<P, S, m> {};
struct System : system_of<bodies<Rod, P>> {};
void f() { use<System>(); }
} // namespace v12

// expect: beam B, on which section S is placed, is not listed in bodies<...>
namespace v13 {
struct B : beam<B, O, N::x, L, m, bends> {};
struct S : section<S, B, 1> {};
struct P : particle<P, S, m> {};
struct System : system_of<bodies<Rod, P>> {};
void f() { use<System>(); }
} // namespace v13

// expect: a motion is declared for section S, which moves with its beam
namespace v14 {
struct S : section<S, Rod, 1>, velocity<N, u * N::x> {};
struct P : particle<P, S, m> {};
struct System : system_of<bodies<Rod, P>> {};
void f() { use<System>(); }
} // namespace v14

// expect: body Rod is listed twice
namespace v15 {
struct System : system_of<bodies<Rod, Rod>> {};
void f() { use<System>(); }
} // namespace v15

// expect: body B names itself Rod; the first template argument of its base must be B
namespace v16 {
struct B : beam<Rod, O, N::x, L, m, bends> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace v16

// expect: the potential energy with q_Rod uses q_of for a coordinate that the joint or beam does not have
namespace v17 {
struct System : system_of<bodies<Rod>, loads<potential_energy<q_of<Rod, 2> * q_of<Rod, 1>>>> {};
void f() { use<System>(); }
} // namespace v17

// expect: joint J is attached to Rod, which is a beam; name a place on it by section<Self, Beam, place>
namespace v18 {
struct J : pin<J, Rod, axis<own::z>, body<1>> {};
struct System : system_of<bodies<Rod>, joints<J>> {};
void f() { use<System>(); }
} // namespace v18

// expect: Rod, which a force uses as a point, is a beam; name a place on it by section<Self, Beam, place>
namespace v19 {
struct System : system_of<bodies<Rod>, loads<force<Rod, F * N::y>>> {};
void f() { use<System>(); }
} // namespace v19

// expect: the direction of bending of beam B normalizes a vector of zero length
namespace v20 {
struct B : beam<B, O, N::x, L, m, bending<0.0 * N::y, EI, clamped_free<1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace v20

// expect: section S of beam Rod is at 0, which is also the value of 1/2 in C++; write 0.5, or 0.0 for the
// expect: root
namespace v21 {
struct S : section<S, Rod, 1 / 2> {};
struct P : particle<P, S, m> {};
struct System : system_of<bodies<Rod, P>> {};
void f() { use<System>(); }
} // namespace v21

// expect: beam B has a profile<...> that is negative at some place, or nowhere positive
namespace v22 {
struct B : beam<B, O, N::x, L, m, bending<N::y, EI, clamped_free<1>, profile<polynomial<1, -2>>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace v22

// expect: the numbers of beam B are too large or too small: its mass or its stiffness is not a finite number
// expect: greater than 0
namespace v23 {
struct B : beam<B, O, N::x, 1e-300, m, bends> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace v23
