// Blocks with the wrong arguments, listed twice, or in the wrong place.
#include "state_variables.hpp"

#include <kanexpr/blocks.hpp>
#include <kanexpr/joints.hpp>

// expect: block L lacks an argument; write lag<Self, input, time>
namespace k1 {
struct L : lag<L, q> {};
struct System : moved<blocks<L>> {};
void f() { use<System>(); }
} // namespace k1

// expect: block C lacks an argument; write pid<Self, deviation, kp, ki, kd, Td>
namespace k2 {
struct C : pid<C, q, 1, 2, 3> {};
struct System : moved<blocks<C>> {};
void f() { use<System>(); }
} // namespace k2

// expect: block C lacks an argument; write pid<Self, deviation, kp, ki, kd, Td, least, greatest, Tt>
namespace k3 {
struct C : pid<C, q, 1, 2, 3, 4, 5, 6> {};
struct System : moved<blocks<C>> {};
void f() { use<System>(); }
} // namespace k3

// expect: block L is listed twice
namespace k4 {
struct L : lag<L, q, 0.1> {};
struct System : moved<blocks<L, L>> {};
void f() { use<System>(); }
} // namespace k4

// expect: blocks<...> lists P, which is a point; points need not be listed
namespace k5 {
struct System : moved<blocks<P>> {};
void f() { use<System>(); }
} // namespace k5

// expect: block L is among the words of System; write blocks<L>
namespace k6 {
struct L : lag<L, q, 0.1> {};
struct System : moved<L> {};
void f() { use<System>(); }
} // namespace k6

// expect: loads<...> lists L, which is a block; list it in blocks<...>
namespace k7 {
struct L : lag<L, q, 0.1> {};
struct System : moved<loads<L>> {};
void f() { use<System>(); }
} // namespace k7

// expect: state variable y_L, which the force at P contains, is not in states<...> or in a listed block
namespace k8 {
struct L : lag<L, q, 0.1> {};
struct System : moved<loads<force<P, L::output * N::x>>> {};
void f() { use<System>(); }
} // namespace k8

// expect: block L subtracts or equates a vector and a scalar
namespace k9 {
struct L : lag<L, N::x, 0.1> {};
struct System : moved<blocks<L>> {};
void f() { use<System>(); }
} // namespace k9

// expect: block L multiplies the rate of state variable y_L by a negative number; a time constant must be
// expect: positive
namespace k20 {
struct L : lag<L, q, -0.1> {};
struct System : moved<blocks<L>> {};
void f() { use<System>(); }
} // namespace k20

// expect: block C contains softplus with a width that is not positive
namespace k21 {
struct C : pid<C, q, 1, 2, 3, 0.1, 5, -5, 0.1> {}; // limits out of order
struct System : moved<blocks<C>> {};
void f() { use<System>(); }
} // namespace k21

// expect: block V contains a division by zero
namespace k22 {
struct V : slew_limit<V, q, 0.0, 0.1> {};
struct System : moved<blocks<V>> {};
void f() { use<System>(); }
} // namespace k22

struct Ground : inertial_ground<Ground> {};
struct Wheel : pin<Wheel, Ground, axis<Ground::z>, body<1, 0.1 * own::x, inertia<own, 1, 1, 1>>> {};
template <class... Loads>
using driven = kane_system<inertial<Ground>, joints<Wheel>, loads<Loads...>>;

// expect: the DC motor between Wheel and Ground lacks an argument; write dc_motor<Joint, V, R, L, k, n, b, J>
namespace k10 {
struct System : driven<dc_motor<Wheel, F, 1, 1>> {};
void f() { use<System>(); }
} // namespace k10

// expect: i_Wheel is listed twice among the state variables
namespace k11 {
struct System : driven<dc_motor<Wheel, F, 1, 1, 1>, dc_motor<Wheel, F, 1, 1, 1>> {};
void f() { use<System>(); }
} // namespace k11

// expect: the gear ratio of joint Wheel changes; it may contain only numbers and parameters
namespace k15 {
struct System : driven<dc_motor<Wheel, F, 1, 1, 1, 1 + q_of<Wheel>, 0.1, 0.2>> {};
void f() { use<System>(); }
} // namespace k15
