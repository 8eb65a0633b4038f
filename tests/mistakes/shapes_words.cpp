// Invalid words of a system, or words with the wrong contents.
#include "shapes.hpp"

// expect: speed<...> is among the words of System, but is a symbol; the word is speeds<...>
namespace n1 {
struct System : kane_system<inertial<N>, coordinates<q>, speed<u>, kinematics<dot(q) == u>, bodies<Bob>> {};
void f() { use<System>(); }
} // namespace n1

// expect: coordinate<...> is among the words of System, but is a symbol; the word is coordinates<...>
namespace n2 {
struct System : kane_system<inertial<N>, coordinate<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};
void f() { use<System>(); }
} // namespace n2

// expect: parameter<...> is among the words of System, but is a symbol; the word is parameters<...>
namespace n3 {
struct System : told<parameter<m>> {};
void f() { use<System>(); }
} // namespace n3

// expect: input<...> is among the words of System, but is a symbol; the word is inputs<...>
namespace n4 {
struct System : told<loads<torque<A, T * N::z>>, input<T>> {};
void f() { use<System>(); }
} // namespace n4

// expect: the force at P is among the words of System; list it in loads<...>
namespace n5 {
struct System : told<weight> {};
void f() { use<System>(); }
} // namespace n5

// expect: frame N is among the words of System; write inertial<N>
namespace n6 {
struct System : kane_system<N, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};
void f() { use<System>(); }
} // namespace n6

// expect: point O is among the words of System; points need not be listed
namespace n7 {
struct System : told<O> {};
void f() { use<System>(); }
} // namespace n7

// expect: inertial<...> takes one frame
namespace n8 {
struct System : kane_system<inertial<>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};
void f() { use<System>(); }
} // namespace n8

// expect: kinematics_of is used with the wrong number of frames for A; write kinematics_of<Frame, Reference>
namespace n9 {
struct System : moved_by<kinematics_of<A>> {};
void f() { use<System>(); }
} // namespace n9

// expect: velocity_constraints<...> contains something that is not an equation; write an equation or
// expect: zero_along<...>
namespace n10 {
struct System : bound_by<zero_along<>> {};
void f() { use<System>(); }
} // namespace n10

// expect: the Lagrangian is not an expression; it must be a scalar
namespace n11 {
struct System : rates_of_pendulum<lagrangian<>> {};
void f() { use_rates<System>(); }
} // namespace n11

// expect: lagrangian<...> takes one expression
namespace n12 {
struct System : rates_of_pendulum<lagrangian<m * dot(q) * dot(q), m>> {};
void f() { use_rates<System>(); }
} // namespace n12

// expect: the list of coordinates contains something that is not a symbol, involving q
namespace n13 {
struct System
    : kane_system<inertial<N>, coordinates<q * 2>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};
void f() { use<System>(); }
} // namespace n13

// expect: the list of speeds contains something that is not a symbol
namespace n14 {
struct System : kane_system<inertial<N>, coordinates<q>, speeds<2>, kinematics<dot(q) == u>, bodies<Bob>> {};
void f() { use<System>(); }
} // namespace n14

// expect: the rate of coordinate q is in the list of speeds
namespace n15 {
struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<dot(q)>, kinematics<dot(q) == u>, bodies<Bob>> {};
void f() { use<System>(); }
} // namespace n15

// expect: kinematics<...> contains something that is not an equation, involving q; write dot(q) == u
namespace n16 {
struct System : moved_by<dot(q) - u> {};
void f() { use<System>(); }
} // namespace n16

// expect: the list of inputs contains something that is not a symbol
namespace n17 {
struct System : told<inputs<N::x>> {};
void f() { use<System>(); }
} // namespace n17

// expect: the list of parameters contains something that is not a symbol, involving m
namespace n18 {
struct System : told<parameters<m == 2>> {};
void f() { use<System>(); }
} // namespace n18

// expect: bodies<...> lists force<...>, which is a load; list it in loads<...>
namespace n19 {
struct System : pendulum_with<Bob, weight> {};
void f() { use<System>(); }
} // namespace n19

// expect: bodies<...> lists A, which is a frame; frames need not be listed
namespace n20 {
struct System : pendulum_with<A> {};
void f() { use<System>(); }
} // namespace n20

// expect: one of the coordinates has no name
namespace n21 {
constexpr coordinate<1> x;
struct System : kane_system<inertial<N>, coordinates<x>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};
void f() { use<System>(); }
} // namespace n21
