// Beams with words that they do not take, and with shapes that do not fit.
#include "beams.hpp"

// expect: beam B has no shapes; write beam<Self, Root, axis, length, mass per length, bending<direction,
// expect: EI, shapes>>
namespace b1 {
struct B : beam<B, O, N::x, L, m> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b1

// expect: beam B has an axis that is not a vector; write beam<Self, Root, axis, length, mass per length,
// expect: bending<direction, EI, shapes>>
namespace b2 {
struct B : beam<B, O, L, L, m, bends> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b2

// expect: beam B has an axis that is not given in the axes of one frame
namespace b3 {
struct B : beam<B, O, N::x + A::x, L, m, bends> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b3

// expect: beam B has an argument that is not a word of a beam; the words are bending<...>, torsion<...>,
// expect: extension<...>, profile<...>, proportional_damping<...>, modal_damping<...> and by<...>
namespace b4 {
struct B : beam<B, O, N::x, L, m, bends, axis<N::z>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b4

// expect: beam B has bending<...> without a shape
namespace b5 {
struct B : beam<B, O, N::x, L, m, bending<N::y, EI>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b5

// expect: beam B has bending<...> with an argument that is neither a shape nor a profile<...>
namespace b6 {
struct B : beam<B, O, N::x, L, m, bending<N::y, EI, clamped_free<1>, O>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b6

// expect: beam B has torsion<...> without one polar_inertia<...>; write torsion<GJ, polar_inertia<J>,
// expect: shapes>
namespace b7 {
struct B : beam<B, O, N::x, L, m, torsion<1, clamped_free<1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b7

// expect: beam B has natural modes without their number; write clamped_free<2>
namespace b8 {
struct B : beam<B, O, N::x, L, m, bending<N::y, EI, clamped_free<0>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b8

// expect: beam B has a tip_body<...> with a negative ratio
namespace b9 {
struct B : beam<B, O, N::x, L, m, bending<N::y, EI, clamped_free<1, tip_body<-0.5>>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b9

// expect: beam B has natural modes with an argument that is not a tip_body<...>
namespace b10 {
struct B : beam<B, O, N::x, L, m, bending<N::y, EI, clamped_free<1, O>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b10

// expect: beam B has a shape of bending that displaces or turns the root; write unclamped<...> if this is
// expect: intended
namespace b11 {
struct B : beam<B, O, N::x, L, m, bending<N::y, EI, polynomial<0, 1, 1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b11

// expect: beam B has a shape that displaces the root; write unclamped<...> if this is intended
namespace b12 {
struct B : beam<B, O, N::x, L, m, extension<EI, polynomial<1, 1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b12

// expect: beam B has a polynomial<> without coefficients
namespace b13 {
struct B : beam<B, O, N::x, L, m, bending<N::y, EI, polynomial<>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b13

// expect: beam B has a polynomial<...> whose coefficients are not numbers
namespace b14 {
struct B : beam<B, O, N::x, L, m, bending<N::y, EI, polynomial<0, 0, L>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b14

// expect: beam B has stations that are not in increasing order
namespace b15 {
struct B : beam<B, O, N::x, L, m, bending<N::y, EI, stations<0, 0, 0.7, 0.4, 0.3, 0.6, 1, 1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b15

// expect: beam B has stations that do not begin at 0 and end at 1, the fractions of the length at root and
// expect: tip
namespace b16 {
struct B : beam<B, O, N::x, L, m, bending<N::y, EI, stations<0, 0, 3, 1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b16

// expect: beam B has stations with an incomplete or single pair of numbers; write stations<0, value, ...,
// expect: 1, value>
namespace b17 {
struct B : beam<B, O, N::x, L, m, bending<N::y, EI, stations<0, 0, 1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b17

// expect: beam B has stations_with_slopes<...> with an incomplete or single triple of numbers; write
// expect: stations_with_slopes<0, value, slope, ..., 1, value, slope>
namespace b18 {
struct B : beam<B, O, N::x, L, m, bending<N::y, EI, stations_with_slopes<0, 0, 1, 1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b18

// expect: beam B has stations that are not numbers
namespace b19 {
struct B : beam<B, O, N::x, L, m, bends, profile<stations<0, L, 1, L>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b19

// expect: beam B has a profile that is neither a polynomial<...> nor stations<...>
namespace b20 {
struct B : beam<B, O, N::x, L, m, bends, profile<clamped_free<1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b20

// expect: beam B has two profiles of its mass
namespace b21 {
struct B : beam<B, O, N::x, L, m, bends, profile<polynomial<1>>, profile<polynomial<1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b21

// expect: beam B has a deformation with two profiles
namespace b22 {
struct B : beam<B, O, N::x, L, m,
                bending<N::y, EI, clamped_free<1>, profile<polynomial<1>>, profile<polynomial<1>>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b22

// expect: beam B bends in three directions; a beam bends in one direction or in two perpendicular ones
namespace b23 {
struct B : beam<B, O, N::x, L, m, bends, bends, bends> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b23

// expect: beam B has torsion<...> twice; write one list of shapes
namespace b24 {
using twist = torsion<1, polar_inertia<m>, clamped_free<1>>;
struct B : beam<B, O, N::x, L, m, twist, twist> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b24

// expect: beam B has extension<...> twice; write one list of shapes
namespace b25 {
using stretch = extension<1, clamped_free<1>>;
struct B : beam<B, O, N::x, L, m, stretch, stretch> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b25

// expect: beam B has two kinds of damping; write either proportional_damping<...> or modal_damping<...>
namespace b26 {
struct B : beam<B, O, N::x, L, m, bends, modal_damping<0.1>, proportional_damping<0.1, 0>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b26

// expect: beam B has by<...> with too few or too many symbols; write a coordinate for each shape, followed
// expect: by a speed for each
namespace b27 {
struct B : beam<B, O, N::x, L, m, bends, by<q>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b27

// expect: beam B bends in a direction that is not a vector; write bending<direction, EI, shapes>
namespace b28 {
struct B : beam<B, O, N::x, L, m, bending<EI, EI, clamped_free<1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b28

// expect: beam B has modal_damping<...> with neither one ratio nor a ratio for each shape
namespace b29 {
struct B : beam<B, O, N::x, L, m, bends, modal_damping<0.1, 0.2>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b29

// expect: beam B has polar_inertia<...> with an argument other than the inertia per length and one
// expect: profile<...>
namespace b30 {
struct B : beam<B, O, N::x, L, m, torsion<1, polar_inertia<m, clamped_free<1>>, clamped_free<1>>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace b30

// expect: q is listed twice among the coordinates: by beam B and by beam C
namespace b31 {
struct B : beam<B, O, N::x, L, m, bends, by<q, u>> {};
struct C : beam<C, O, N::x, L, m, bends, by<q, u>> {};
struct System : system_of<bodies<B, C>> {};
void f() { use<System>(); }
} // namespace b31

// expect: q is listed twice among the coordinates: by the system and by beam B
namespace b32 {
struct B : beam<B, O, N::x, L, m, bends, by<q, u>> {};
struct System : system_of<coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<B>> {};
void f() { use<System>(); }
} // namespace b32

// expect: beam Rod, on which section Tip is placed, is not listed in bodies<...>
namespace b33 {
struct Tip : section<Tip, Rod, 1> {};
struct Bob : particle<Bob, Tip, m> {};
struct System : system_of<bodies<Bob>> {};
void f() { use<System>(); }
} // namespace b33
