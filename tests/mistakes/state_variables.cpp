// State variables without dynamics, with too many, and where they have no place.
#include "state_variables.hpp"

// expect: state variable z has no dynamics; write one equation, dynamics<dot(z) == rate>
namespace s1 {
struct System : moved<states<z>> {};
void f() { use<System>(); }
} // namespace s1

// expect: state variable z has two dynamics; write one equation, dynamics<dot(z) == rate>
namespace s2 {
struct System : moved<states<z>, dynamics<dot(z) == -z, dot(z) == q>> {};
void f() { use<System>(); }
} // namespace s2

// expect: state variable y, which an equation of dynamics<...> contains, is not in states<...> or in a
// expect: listed block
namespace s3 {
struct System : moved<states<z>, dynamics<dot(z) == -z, dot(y) == q>> {};
void f() { use<System>(); }
} // namespace s3

// expect: state variable z, which the force at P contains, is not in states<...> or in a listed block
namespace s4 {
struct System : moved<loads<force<P, z * N::x>>> {};
void f() { use<System>(); }
} // namespace s4

// expect: an equation of dynamics<...> contains the rate of speed u, but the rate of no state variable;
// expect: declare it as state_variable<...>
namespace s5 {
struct System : moved<states<z>, dynamics<dot(u) == -z>> {};
void f() { use<System>(); }
} // namespace s5

// expect: an equation of dynamics<...> with z contains the rate of no state variable; write dot(z) == rate
namespace s6 {
struct System : moved<states<z>, dynamics<z == q>> {};
void f() { use<System>(); }
} // namespace s6

// expect: dynamics<...> contains something that is not an equation, involving z; write dot(z) == rate
namespace s7 {
struct System : moved<states<z>, dynamics<dot(z) + z>> {};
void f() { use<System>(); }
} // namespace s7

// expect: the dynamics of state variable z are not linear in its rate
namespace s8 {
struct System : moved<states<z>, dynamics<dot(z) * dot(z) == q>> {};
void f() { use<System>(); }
} // namespace s8

// expect: the dynamics of state variable z do not determine its rate
namespace s9 {
struct System : moved<states<z>, dynamics<dot(z) - dot(z) == q>> {};
void f() { use<System>(); }
} // namespace s9

// expect: the rate of state variable z depends on rates that depend on each other
namespace s10 {
struct System : moved<states<z, y>, dynamics<dot(z) == dot(y), dot(y) == dot(z) - y>> {};
void f() { use<System>(); }
} // namespace s10

// expect: the rate of state variable z contains the rate of speed u
namespace s11 {
struct System : moved<states<z>, dynamics<dot(z) == dot(u) - z>> {};
void f() { use<System>(); }
} // namespace s11

// expect: a kinematic differential equation contains the state variable z; state variables may appear only in
// expect: loads, dynamics and results
namespace s12 {
struct System : system_of<kinematics<dot(q) == u + z>, states<z>, dynamics<dot(z) == -z>> {};
void f() { use<System>(); }
} // namespace s12

// expect: velocity constraint 1 contains the state variable z; state variables may appear only in loads,
// expect: dynamics and results
namespace s13 {
struct System : moved<states<z>, dynamics<dot(z) == -z>, velocity_constraints<u == z>> {};
void f() { use<System>(); }
} // namespace s13

// expect: configuration constraint 1 contains the state variable z; it may contain only coordinates
namespace s14 {
struct System : moved<states<z>, dynamics<dot(z) == -z>, configuration_constraints<q == z>> {};
void f() { use<System>(); }
} // namespace s14

// expect: the offset of point R contains the state variable z; it may contain only coordinates
namespace s15 {
struct R : offset<R, P, z * N::x> {};
struct C : particle<C, R, m> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<B, C>,
                            states<z>, dynamics<dot(z) == -z>> {};
void f() { use<System>(); }
} // namespace s15

// expect: potential energy 1 contains the state variable z; it may contain only coordinates
namespace s16 {
struct System : moved<states<z>, dynamics<dot(z) == -z>, loads<potential_energy<z * q>>> {};
void f() { use<System>(); }
} // namespace s16

// expect: state variable z is in the list of speeds
namespace s17 {
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u, z>, kinematics<dot(q) == u>, bodies<B>> {};
void f() { use<System>(); }
} // namespace s17

// expect: speed u is in the list of state variables
namespace s18 {
struct System : moved<states<u>> {};
void f() { use<System>(); }
} // namespace s18

// expect: z is listed twice among the state variables
namespace s19 {
struct System : moved<states<z, z>, dynamics<dot(z) == -z>> {};
void f() { use<System>(); }
} // namespace s19

// expect: the name u is used twice: among the speeds and among the state variables
namespace s20 {
constexpr state_variable<"u"> other;
struct System : moved<states<other>, dynamics<dot(other) == -other>> {};
void f() { use<System>(); }
} // namespace s20

// expect: state_variable<...> is among the words of System, but is a symbol; the word is states<...>
namespace s21 {
struct System : moved<state_variable<"z">> {};
void f() { use<System>(); }
} // namespace s21

// expect: dependent<...> contains something that is neither a coordinate nor a speed, involving z
namespace s22 {
struct System : moved<states<z>, dynamics<dot(z) == -z>, dependent<z>> {};
void f() { use<System>(); }
} // namespace s22

// expect: the Lagrangian contains the state variable z; state variables may appear only in loads,
// expect: dynamics and results
namespace s23 {
struct System : lagrange_system<inertial<N>, coordinates<q>, states<z>, dynamics<dot(z) == -z>,
                                lagrangian<m * dot(q) * dot(q) / 2 - k * z * q>> {};
void f() { use<System>(); }
} // namespace s23

// expect: the system System has no state variable y
namespace s24 {
struct System : moved<states<z>, dynamics<dot(z) == -z>> {};
void f() {
  state<System> x;
  x[y] = 1;
}
} // namespace s24

// expect: the mass of C depends on the state variable z
namespace s25 {
struct C : particle<C, P, m + z> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<C>,
                            states<z>, dynamics<dot(z) == -z>> {};
void f() { use<System>(); }
} // namespace s25

// expect: the Coriolis matrix requires every speed to be a coordinate rate; state variable z is not one
namespace s26 {
struct System : moved<states<z>, dynamics<dot(z) == -z>> {};
void f() {
  using eom = equations_of_motion<System>;
  static_cast<void>(eom::coriolis(eom::state(), eom::parameters()));
}
} // namespace s26

// expect: an equation of dynamics<...> with z equates vectors; equate their dot products with basis vectors
namespace s27 {
struct System : moved<states<z>, dynamics<dot(z) * N::x == z * N::x>> {};
void f() { use<System>(); }
} // namespace s27

// expect: the system System lists states<...> twice; write one list
namespace s28 {
struct System : moved<states<z>, states<y>, dynamics<dot(z) == -z, dot(y) == -y>> {};
void f() { use<System>(); }
} // namespace s28
