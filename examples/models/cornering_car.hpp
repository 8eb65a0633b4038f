#pragma once

#include <kanexpr/kanexpr.hpp>
#include <kanexpr/tyres.hpp>

/// A car with a single track on brush tyres with relaxation lengths, steered in front and driven at the rear.
namespace cornering_car {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"y", meter> y;
constexpr coordinate<"psi", radian> psi;
constexpr coordinate<"th_f", radian> front_angle;
constexpr coordinate<"th_r", radian> rear_angle;
constexpr speed<"u", meter / second> u; // forward
constexpr speed<"v", meter / second> v; // to the left
constexpr speed<"r"> r;
constexpr speed<"w_f"> front_spin;
constexpr speed<"w_r"> rear_spin;
constexpr prescribed<"delta", radian> delta;
constexpr input<"T", newton * meter> T;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"J", kilogram * pow<2>(meter)> J; // about the vertical, without the wheels
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"a", meter> a; // from the center of mass to the axles
constexpr parameter<"b", meter> b;
constexpr parameter<"R", meter> R;
constexpr parameter<"mu", dimensionless> mu;
constexpr parameter<"C_f", newton> C_f;
constexpr parameter<"C_r", newton> C_r;
constexpr parameter<"s", meter> s; // relaxation length
constexpr parameter<"v0", meter / second> v0;

struct N : inertial_frame<N> {}; // z points up
struct O : origin<O, N> {};
struct Body : rotated<Body, N, psi, N::z> {};
struct Fork : rotated<Fork, Body, delta, Body::z> {};
struct Front : rotated<Front, Fork, front_angle, Fork::y> {};
struct Rear : rotated<Rear, Body, rear_angle, Body::y> {};
struct G : offset<G, O, x * N::x + y * N::y + R * N::z> {};
struct FrontHub : offset<FrontHub, G, a * Body::x> {};
struct RearHub : offset<RearHub, G, -b * Body::x> {};

// The mass of the wheels belongs to the car.
struct Car : rigid_body<Car, G, Body, m, inertia<Body, 600, 2200, J>> {};
struct FrontWheel : rigid_body<FrontWheel, FrontHub, Front, 0.0, inertia<Fork, 0.0, 1.5, 0.0>> {};
struct RearWheel : rigid_body<RearWheel, RearHub, Rear, 0.0, inertia<Body, 0.0, 1.5, 0.0>> {};

using FrontTyre = tyre<thin_wheel<FrontHub, Fork::y, R, Front>, flat_ground<O, N::z>, brush_tyre<mu, C_f>,
                       wheel_load<m * g * b / (a + b)>, relaxation<s, s>, standstill<v0>>;
using RearTyre = tyre<thin_wheel<RearHub, Body::y, R, Rear>, flat_ground<O, N::z>, brush_tyre<mu, C_r>,
                      wheel_load<m * g * a / (a + b)>, relaxation<s, s>, standstill<v0>>;

struct System
    : kane_system<inertial<N>, coordinates<x, y, psi, front_angle, rear_angle>,
                  speeds<u, v, r, front_spin, rear_spin>,
                  kinematics<dot(x) == u * cos(psi) - v * sin(psi), dot(y) == u * sin(psi) + v * cos(psi),
                             dot(psi) == r, dot(front_angle) == front_spin, dot(rear_angle) == rear_spin>,
                  parameters<m, J, g, a, b, R, mu, C_f, C_r, s, v0>,
                  inputs<delta, dot(delta), dot(dot(delta)), T>, bodies<Car, FrontWheel, RearWheel>,
                  loads<FrontTyre, RearTyre, torque_between<Rear, Body, T * Body::y>>> {};

} // namespace cornering_car
