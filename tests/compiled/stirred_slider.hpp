#pragma once

#include <kanexpr/kanexpr.hpp>

/// A slider on a rail in a slot that a crank turns: the constraint leaves one motion. The state variables
/// depend nonlinearly on everything, including velocities and each other's rates.
namespace stirred_slider {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr coordinate<"x"> x;
constexpr speed<"w"> w;
constexpr speed<"v"> v;
constexpr state_variable<"z", 1> z1;
constexpr state_variable<"z", 2> z2;
constexpr parameter<"m"> m;
constexpr parameter<"k"> k;
constexpr parameter<"tau"> tau;
constexpr input<"F"> F;
constexpr time_variable t;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, (2 + sin(q)) * A::x> {};
struct Q : offset<Q, O, x * N::x> {};
struct Crank : particle<Crank, P, m> {};
struct Slider : particle<Slider, Q, m> {};

template <auto rate_of_q, auto rate_of_x>
using stirring = dynamics<tau * dot(z1) == F * sin(q) - z1 + t * rate_of_q,
                          dot(z2) == dot(z1) * x - z2 * z2 + dot(velocity_of<P>, N::x) * k>;
using acting = loads<force<Q, (k * z1 * z2 + dot(z2)) * N::x>, torque<A, tanh(z1 - v) * N::z>>;
using linked = configuration_constraints<x == 3 * cos(q)>;

struct System : kane_system<inertial<N>, coordinates<q, x>, speeds<w, v>, states<z1, z2>,
                            kinematics<dot(q) == w, dot(x) == v>, parameters<m, k, tau>, inputs<F>,
                            stirring<w, v>, bodies<Crank, Slider>, acting, linked> {};
struct FreeSystem : kane_system<inertial<N>, coordinates<q, x>, speeds<w, v>, states<z1, z2>,
                                kinematics<dot(q) == w, dot(x) == v>, parameters<m, k, tau>, inputs<F>,
                                stirring<w, v>, bodies<Crank, Slider>, acting> {};
struct LagrangeSystem
    : lagrange_system<inertial<N>, coordinates<q, x>, states<z1, z2>, parameters<m, k, tau>, inputs<F>,
                      stirring<dot(q), dot(x)>, bodies<Crank, Slider>,
                      loads<force<Q, (k * z1 * z2 + dot(z2)) * N::x>, torque<A, tanh(z1 - dot(x)) * N::z>>,
                      linked> {};

} // namespace stirred_slider
