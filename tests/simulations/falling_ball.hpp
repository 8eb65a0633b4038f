#pragma once

#include <kanexpr/kanexpr.hpp>

// A ball that moves up and down.
namespace falling_ball {

using namespace kanexpr;

constexpr coordinate<"h"> h;
constexpr speed<"v"> v;
constexpr parameter<"m"> m;
constexpr parameter<"g"> g;

struct N : inertial_frame<N> {}; // z points up
struct O : origin<O, N> {};
struct P : offset<P, O, h * N::z> {};
struct Ball : particle<Ball, P, m> {};

struct System : kane_system<inertial<N>, coordinates<h>, speeds<v>, kinematics<dot(h) == v>, bodies<Ball>,
                            loads<gravity<-g * N::z>>, parameters<m, g>> {};

} // namespace falling_ball
