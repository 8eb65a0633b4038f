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

// expect: the force at P contains tanh(u/l); u/l [rad/(m s)] is not a number
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

// expect: the force at P compares l [m] and if_positive(k*q - -1, k*q, 0) + if_positive(k*q - -1, -1, 0)
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
