#include "pendulum.hpp"

#include <kanexpr/steps/second_order_step.hpp>

struct System : pendulum_with<Bob> {};

// expect: second_order_step requires a step without corrections, such as runge_kutta_4<System, 0>
static_assert(sizeof(second_order_step<runge_kutta_4<System>>) == 1);

constexpr coordinate<"e", 1> e1;
constexpr coordinate<"e", 2> e2;
constexpr coordinate<"e", 3> e3;
constexpr coordinate<"e", 4> e4;
constexpr speed<"w", 1> w1;
constexpr speed<"w", 2> w2;
constexpr speed<"w", 3> w3;
struct B : quaternion<B, N, e1, e2, e3, e4>, angular_velocity<N, w1 * own::x + w2 * own::y + w3 * own::z> {};
struct Top : rigid_body<Top, O, B, m, inertia<B, 1, 1, 2>> {};
struct Spinning : kane_system<inertial<N>, coordinates<e1, e2, e3, e4>, speeds<w1, w2, w3>,
                              kinematics<kinematics_of<B, N>>, bodies<Top>> {};

// expect: second_order_step requires a system without quaternions, because they have
// expect: norm 1 only at the ends of a step
static_assert(sizeof(second_order_step<runge_kutta_4<Spinning, 0>>) == 1);
