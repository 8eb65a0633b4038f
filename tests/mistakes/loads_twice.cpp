// Forces that act twice, and weights in place of accelerations.
#include "shapes.hpp"

// expect: gravity contains m, the mass of Bob; it must be the free-fall acceleration, not a weight
namespace n1 {
struct System : loaded<gravity<-m * g * N::y>> {};
void f() { use<System>(); }
} // namespace n1

// expect: the force at P is the weight of Bob, which gravity already applies
namespace n2 {
struct System : loaded<gravity<-g * N::y>, force<P, -m * g * N::y>> {};
void f() { use<System>(); }
} // namespace n2

// expect: the force at P is listed twice
namespace n3 {
struct System : loaded<force<P, -m * u * N::y>, force<O, u * N::x>, force<P, -u * m * N::y>> {};
void f() { use<System>(); }
} // namespace n3

// expect: the torque on A is listed twice
namespace n4 {
struct System : loaded<torque<A, u * N::z>, torque<A, u * N::z>> {};
void f() { use<System>(); }
} // namespace n4

// expect: the force between P and O is listed twice
namespace n5 {
struct System : loaded<force_between<P, O, u * N::x>, force_between<P, O, u * N::x>> {};
void f() { use<System>(); }
} // namespace n5

// expect: gravity contains mr, the mass of Rocket; it must be the free-fall acceleration, not a weight
namespace n6 {
constexpr prescribed<"mr"> mr;
struct Rocket : particle<Rocket, P, mr> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Rocket>,
                            loads<gravity<-mr * g * N::y>>> {};
void f() { use<System>(); }
} // namespace n6

// expect: gravity contains m, as does the mass of Heavy; it must be the free-fall acceleration, not a weight
namespace n7 {
struct Heavy : particle<Heavy, P, 2 * m> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Heavy>,
                            loads<gravity<-2 * m * g * N::y>>> {};
void f() { use<System>(); }
} // namespace n7

// expect: the force at P contains the weight of Bob, which gravity already applies
namespace n8 {
struct System : loaded<gravity<-g * N::y>, force<P, F * A::y - m * g * N::y>> {};
void f() { use<System>(); }
} // namespace n8

// expect: the force between P and O contains the weight of Bob, which gravity already applies
namespace n9 {
struct System : loaded<gravity<-g * N::y>, force_between<P, O, -m * g * N::y>> {};
void f() { use<System>(); }
} // namespace n9

// expect: the force between O and P contains the weight of Bob, which gravity already applies
namespace n10 {
struct System : loaded<gravity<-g * N::y>, force_between<O, P, m * g * N::y - k * N::x>> {};
void f() { use<System>(); }
} // namespace n10

// expect: the force at P contains the weight of Bob, which gravity already applies
namespace n11 {
struct System : loaded<gravity<-g * N::y>, force<P, (F - m * g * sin(q)) * A::x - m * g * cos(q) * A::y>> {};
void f() { use<System>(); }
} // namespace n11

// expect: potential energy 1 includes the energy of the weight of Bob, which gravity already applies
namespace n12 {
struct System : loaded<gravity<-g * N::y>, potential_energy<m * g * l * sin(q)>> {};
void f() { use<System>(); }
} // namespace n12

// expect: potential energy 2 includes the energy of the weight of Bob, which gravity already applies
namespace n13 {
struct System
    : loaded<gravity<g * N::x>, torsional_spring<q, k>, potential_energy<m * g * l * (1 - cos(q))>> {};
void f() { use<System>(); }
} // namespace n13

// expect: the force at P contains the weight of Bob, which gravity already applies
namespace n14 {
struct System : loaded<gravity<-g * N::y>, force<P, -c * velocity_of<P> - m * g * N::y>> {};
void f() { use<System>(); }
} // namespace n14

// expect: the force at P contains the weight of Brass, which gravity already applies
namespace n15 {
struct Brass : particle<Brass, P, 2> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Brass>,
                            loads<gravity<-9.81 * N::y>, force<P, F * A::y - 2 * 9.81 * N::y>>> {};
void f() { use<System>(); }
} // namespace n15

// expect: the spring between P and Q is listed twice
namespace n16 {
struct System : loaded<spring<P, Q, k, l>, damper<P, Q, c>, spring<Q, P, k, l>> {};
void f() { use<System>(); }
} // namespace n16

// expect: the damper between P and Q is listed twice
namespace n17 {
struct System : loaded<damper<P, Q, c>, spring<P, Q, k, l>, damper<Q, P, c>> {};
void f() { use<System>(); }
} // namespace n17

// expect: the torsional damper between A and N is listed twice
namespace n18 {
struct System : loaded<torsional_damper<A, N, c>, torsional_damper<N, A, c>> {};
void f() { use<System>(); }
} // namespace n18

// expect: potential energy 2 repeats potential energy 1
namespace n19 {
struct System : loaded<torsional_spring<q, k>, potential_energy<k * q * q / 2>> {};
void f() { use<System>(); }
} // namespace n19

// expect: the torsional spring with q is listed twice
namespace n20 {
struct System : loaded<torsional_spring<q, k>, torsional_spring<q, k>> {};
void f() { use<System>(); }
} // namespace n20

// expect: the potential energy with k is listed twice
namespace n21 {
struct System : loaded<potential_energy<k * q * q>, potential_energy<k * q * q>> {};
void f() { use<System>(); }
} // namespace n21

// expect: the torque between A and N is listed twice
namespace n22 {
struct System : loaded<torque_between<A, N, T * N::z>, torque_between<N, A, -T * N::z>> {};
void f() { use<System>(); }
} // namespace n22

// expect: the force between P and O is listed twice
namespace n23 {
struct System : loaded<force_between<P, O, F * N::x>, force_between<O, P, -F * N::x>> {};
void f() { use<System>(); }
} // namespace n23

// expect: the torque on A repeats the torque between A and N
namespace n24 {
struct System : loaded<torque_between<A, N, T * A::z>, torque<A, T * N::z>> {};
void f() { use<System>(); }
} // namespace n24

// expect: the force between O and P repeats the force at P
namespace n25 {
struct System : loaded<force<P, F * A::x>, force_between<O, P, -F*(cos(q) * N::x + sin(q) * N::y)>> {};
void f() { use<System>(); }
} // namespace n25

// expect: potential energy 2 repeats potential energy 1
namespace n26 {
struct System : loaded<torsional_spring<q, k>, potential_energy<k / 2 * q * q>> {};
void f() { use<System>(); }
} // namespace n26
