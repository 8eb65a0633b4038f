// Models whose units do not fit. tests/runtime/units_test.cpp has more of them, built at run time.
#include "units.hpp"

// expect: the force at P adds g*m [N] and k [N/m]
namespace u1 {
struct System : pendulum<force<P, (m * g + k) * N::x>> {};
void f() { use<System>(); }
} // namespace u1

// expect: gravity is l [m], but must be in m/s^2
namespace u2 {
struct System : pendulum<gravity<l * N::x>> {};
void f() { use<System>(); }
} // namespace u2

// expect: the torque on A is l [m], but must be in N m
namespace u3 {
struct System : pendulum<gravity<g * N::x>, torque<A, l * N::z>> {};
void f() { use<System>(); }
} // namespace u3

// expect: the mass of Bob2 is l [m], but must be in kg
namespace u4 {
struct Bob2 : particle<Bob2, P, l> {};
struct System : extended<pendulum<gravity<g * N::x>>, bodies<Bob2>, values<l == 2>> {};
void f() { use<System>(); }
} // namespace u4

// expect: the force at P is -k*velocity_of<P>.x [N/s], but must be in N
namespace u5 {
struct System : pendulum<force<P, -k * velocity_of<P>>> {};
void f() { use<System>(); }
} // namespace u5

// expect: a configuration constraint equates position_of<P>.x - position_of<O>.x [m] and k [N/m]
namespace u6 {
struct System
    : extended<pendulum<gravity<g * N::x>>, configuration_constraints<dot(position_of<P, O>, N::x) == k>> {};
void f() { use<System>(); }
} // namespace u6

// expect: the force at P compares u [rad/s] and l [m]
namespace u7 {
struct System : pendulum<force<P, smooth_abs(u, l) * F * N::x>> {};
void f() { use<System>(); }
} // namespace u7

// expect: potential energy 1 is g*m [N], but must be in N m
namespace u8 {
struct System : lagrange_system<inertial<N>, coordinates<q>, bodies<Bob>, loads<potential_energy<m * g>>> {};
void f() { use<System>(); }
} // namespace u8

// expect: the force at P is 2 N m [N m], but must be in N
namespace u9 {
struct System : pendulum<force<P, constant<2, newton * meter> * N::x>> {};
void f() { use<System>(); }
} // namespace u9

// expect: the force at P compares k*q [N rad/m] and l [m]
namespace u10 {
struct System : pendulum<force<P, clamp(k* q, -1, l) * N::x>> {};
void f() { use<System>(); }
} // namespace u10

// expect: the mass of Bob2 is k [N/m], but must be in kg
namespace u11 {
struct Bob2 : particle<Bob2, P, k> {};
struct System : extended<pendulum<gravity<g * N::x>>, bodies<Bob2>> {};
constexpr auto units = units_of<System>();
} // namespace u11

// expect: the force at P compares l [m] and m [kg]
namespace u12 {
struct System : pendulum<force<P, smooth_step(l, 0, m) * F * N::x>> {};
void f() { use<System>(); }
} // namespace u12

// expect: the force at P is l*clamp(k*l, -1, 1) [N m], but must be in N
namespace u13 {
struct System : pendulum<force<P, clamp(k* l, -1, 1) * l * N::x>> {};
void f() { use<System>(); }
} // namespace u13

// expect: the force at P is l*F*smooth_step(l, 0, 0.01) [N m], but must be in N
namespace u14 {
struct System : pendulum<force<P, smooth_step(l, 0, 0.01) * F * l * N::x>> {};
void f() { use<System>(); }
} // namespace u14

// expect: the force at P selects F [N] or k [N/m]
namespace u15 {
struct System : pendulum<force<P, if_positive(u, F, k) * N::x>> {};
void f() { use<System>(); }
} // namespace u15

// expect: the force at P takes the hypot of F [N] and l [m]
namespace u16 {
struct System : pendulum<force<P, hypot(F, l) * N::x>> {};
void f() { use<System>(); }
} // namespace u16

// expect: the drag coefficient at P is k [N/m], but must be in kg/m
namespace u17 {
struct System : pendulum<drag<P, k>> {};
void f() { use<System>(); }
} // namespace u17

// expect: the force at P is k*l^2.37 [N m^(41/30)], but must be in N
namespace u18 {
struct System : pendulum<force<P, k * pow(l, 2.37) * N::x>> {};
void f() { use<System>(); }
} // namespace u18

// expect: the unit stated for h is out of range; its powers must be multiples of 1/60 between -273 and 273
namespace u19 {
constexpr parameter<"h", units::si::pow<600>(meter)> h;
struct System : pendulum<force<P, k * h * N::x>> {};
void f() { use<System>(); }
} // namespace u19

// expect: a modified Rodrigues parameter of frame B is l [m], but must be a number
namespace u20 {
struct B : modified_rodrigues<B, N, l, 0.0, 0.0> {};
struct System : pendulum<force<P, F * B::x>> {};
void f() { use<System>(); }
} // namespace u20
