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

// expect: the torque on A is friction(q) [N], but must be in N m
namespace u21 {
struct F1 {
  template <class Number>
  constexpr Number operator()(Number x) const {
    return x * x;
  }
};
constexpr external<"friction", F1> friction;
struct System : pendulum<force<P, friction(q) * N::x>, torque<A, friction(q) * N::z>> {};
void f() { use<System>(); }
} // namespace u21

// expect: the torque on A is sqrt(sqrt(sqrt(b))) [N], but must be in N m
namespace u22 {
constexpr parameter<"b"> b;
constexpr auto root = sqrt(sqrt(sqrt(b)));
struct System : pendulum<force<P, root * N::x>, torque<A, root * N::z>> {};
void f() { use<System>(); }
} // namespace u22

// expect: the force at P is b^7 [kg^7 m^7/s^14], but must be in N
namespace u23 {
constexpr parameter<"b"> b;
constexpr parameter<"b", newton> in_newtons;
struct System : pendulum<force<P, pow(b, 7) * N::x>, force<P, in_newtons * N::y>> {};
void f() { use<System>(); }
} // namespace u23

// expect: the force at P is k [N/m], but must be in N
namespace u24 {
constexpr parameter<"b"> b;
struct System : pendulum<force<P, pow(b, 0.0) * k * N::x>> {};
void f() { use<System>(); }
} // namespace u24

// expect: the unit stated for h is out of range; its powers must be multiples of 1/60 between -273 and 273
namespace u25 {
constexpr parameter<"h"> h;
constexpr parameter<"h", units::si::pow<600>(meter)> stated;
struct System : pendulum<force<P, F * h / h * N::x>, force<O, F * stated / stated * N::x>> {};
void f() { use<System>(); }
} // namespace u25

// expect: a velocity constraint adds velocity_of<P>.x [m/s] and l*velocity_of<P>.y [m^2/s]
namespace u26 {
struct System : extended<pendulum<gravity<g * N::x>>,
                         velocity_constraints<zero_along<velocity_of<P>, N::x + l * N::y>>> {};
void f() { use<System>(); }
} // namespace u26

// expect: the force at P adds k*l [N] and sin(if_positive(q, 1, 2)) [1]
namespace u27 {
struct System : pendulum<force<P, (k * l + sin(if_positive(q, 1.0, 2.0))) * N::x>> {};
void f() { use<System>(); }
} // namespace u27

// expect: the force at P is k*if_positive(q, 1, 2) [N/m], but must be in N
namespace u28 {
struct System : pendulum<force<P, k * tabulated<0.0, if_positive(q, 1.0, 2.0), 1.0, 3.0>(q) * N::x>> {};
void f() { use<System>(); }
} // namespace u28

// expect: the force at P contains 2^l; l [m] is not a number
namespace u29 {
struct System : pendulum<force<P, F * pow(2.0, l) * N::x>> {};
void f() { use<System>(); }
} // namespace u29

// expect: a kinematic differential equation subtracts u*sin(q3) [rad/s] from 2*cos(q3) [1]
namespace u30 {
constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr coordinate<"q3"> q3;
constexpr speed<"w"> w;
struct B : body_fixed<B, N, "zxz", q1, q2, q3>,
           angular_velocity<N, 2.0 * own::x + u * own::y + w * own::z> {};
struct Tip : offset<Tip, O, l * B::x> {};
struct Load : particle<Load, Tip, m> {};
struct System : kane_system<inertial<N>, coordinates<q1, q2, q3>, speeds<u, w>,
                            kinematics<kinematics_of<B, N>>, bodies<Load>> {};
void f() { use<System>(); }
} // namespace u30

// expect: the torsional spring with q + s adds q [rad] and s [m]
namespace u31 {
constexpr coordinate<"s"> s;
constexpr speed<"v"> v;
struct S : offset<S, O, s * N::x> {};
struct Sled : particle<Sled, S, m> {};
struct System : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>, kinematics<simple>,
                            bodies<Bob, Sled>, loads<torsional_spring<q + s, k * l * l>>> {};
void f() { use<System>(); }
} // namespace u31

// expect: the torsional spring with q subtracts l [m] from q [rad]
namespace u32 {
struct System : pendulum<torsional_spring<q, 20, l>> {};
void f() { use<System>(); }
} // namespace u32

// expect: the length of the linear spring with q + l adds q [rad] and l [m]
namespace u33 {
struct System : pendulum<linear_spring<given_length<l + q>, 20>> {};
void f() { use<System>(); }
} // namespace u33
