#pragma once

#include <kanexpr/kanexpr.hpp>

/// Andrews' squeezing mechanism: seven planar bodies in three loops, driven by a motor and a spring.
/// Schiehlen (1990), Multibody Systems Handbook; Hairer & Wanner, Solving Ordinary Differential Equations II.
namespace andrews {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"beta", radian> be;
constexpr coordinate<"Theta", radian> th;
constexpr coordinate<"gamma", radian> ga;
constexpr coordinate<"Phi", radian> ph;
constexpr coordinate<"delta", radian> de;
constexpr coordinate<"Omega", radian> om;
constexpr coordinate<"epsilon", radian> ep;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr speed<"u4"> u4;
constexpr speed<"u5"> u5;
constexpr speed<"u6"> u6;
constexpr speed<"u7"> u7;

// Lengths in meters, with the names used in the books.
constexpr double d = 0.028, da = 0.0115, e = 0.02, ea = 0.01421, rr = 0.007, ra = 0.00092, ss = 0.035,
                 sa = 0.01874, sb = 0.01043, ta = 0.02308, tb = 0.00916, u = 0.04, ua = 0.01228, ub = 0.00449,
                 zf = 0.02, zt = 0.04, fa = 0.01421;
constexpr double mom = 0.033; // torque of the motor, N m

// The force of the spring combines quantities with several units.
constexpr auto c0 = constant<4530, newton / meter>;
constexpr auto l0 = constant<0.07785, meter>, sc = constant<0.018, meter>, sd = constant<0.02, meter>;

struct N : inertial_frame<N> {};
struct K1 : rotated<K1, N, be, N::z> {};
struct K2 : rotated<K2, K1, th, K1::z> {};
struct K3 : rotated<K3, N, ga, N::z> {};
struct K5 : rotated<K5, N, de, N::z> {};
struct K4 : rotated<K4, K5, ph, K5::z> {};
struct K7 : rotated<K7, N, ep, N::z> {};
struct K6 : rotated<K6, K7, om, K7::z> {};

// Bearings on the ground.
struct O : origin<O, N> {};
struct A : offset<A, O, -0.06934 * N::x - 0.00227 * N::y> {};
struct B : offset<B, O, -0.03635 * N::x + 0.03273 * N::y> {};

// Three bodies are attached to the rod K2 at the joint E.
struct F : offset<F, O, rr * K1::x> {};
struct E : offset<E, F, -d * K2::x> {};
struct E3 : offset<E3, B, -ss * K3::y> {};
struct G : offset<G, A, zt * K5::x> {};
struct E4 : offset<E4, G, -e * K4::y> {};
struct H : offset<H, A, -u * K7::y> {};
struct E6 : offset<E6, H, zf * K6::x> {};

// A spring from the ground to a point of K3.
constexpr auto arm = sd * K3::x - sc * K3::y;
constexpr auto spring = arm - constant<0.05035, meter> * N::x - constant<0.03927, meter> * N::y;
struct D : offset<D, B, arm> {};

struct C1 : offset<C1, O, ra * K1::x> {};
struct C2 : offset<C2, F, -da * K2::x> {};
struct C3 : offset<C3, B, sb * K3::x - sa * K3::y> {};
struct C4 : offset<C4, G, -(e - ea) * K4::y> {};
struct C5 : offset<C5, A, ta * K5::x - tb * K5::y> {};
struct C6 : offset<C6, H, (zf - fa) * K6::x> {};
struct C7 : offset<C7, A, ub * K7::x - ua * K7::y> {};

struct Body1 : rigid_body<Body1, C1, K1, 0.04325, inertia<K1, 0, 0, 2.194e-6>> {};
struct Body2 : rigid_body<Body2, C2, K2, 0.00365, inertia<K2, 0, 0, 4.410e-7>> {};
struct Body3 : rigid_body<Body3, C3, K3, 0.02373, inertia<K3, 0, 0, 5.255e-6>> {};
struct Body4 : rigid_body<Body4, C4, K4, 0.00706, inertia<K4, 0, 0, 5.667e-7>> {};
struct Body5 : rigid_body<Body5, C5, K5, 0.07050, inertia<K5, 0, 0, 1.169e-5>> {};
struct Body6 : rigid_body<Body6, C6, K6, 0.00706, inertia<K6, 0, 0, 5.667e-7>> {};
struct Body7 : rigid_body<Body7, C7, K7, 0.05498, inertia<K7, 0, 0, 1.912e-5>> {};

struct System
    : kane_system<
          inertial<N>, coordinates<be, th, ga, ph, de, om, ep>, speeds<u1, u2, u3, u4, u5, u6, u7>,
          kinematics<dot(be) == u1, dot(th) == u2, dot(ga) == u3, dot(ph) == u4, dot(de) == u5, dot(om) == u6,
                     dot(ep) == u7>,
          configuration_constraints<zero_along<position_of<E, E3>, N::x, N::y>,
                                    zero_along<position_of<E, E4>, N::x, N::y>,
                                    zero_along<position_of<E, E6>, N::x, N::y>>,
          bodies<Body1, Body2, Body3, Body4, Body5, Body6, Body7>,
          loads<torque<K1, mom * N::z>, force<D, -c0*(magnitude(spring) - l0) * normalized(spring)>>> {};

} // namespace andrews
