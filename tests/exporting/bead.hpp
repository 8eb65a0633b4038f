#pragma once

#include <kanexpr/kanexpr.hpp>

/// A bead on a rod that rotates uniformly in the plane, pushed along the rod.
namespace bead {

using namespace kanexpr;

constexpr coordinate<"s"> s;
constexpr speed<"v"> v;
constexpr parameter<"m"> m;
constexpr parameter<"w"> w;
constexpr parameter<"g"> g;
constexpr input<"push"> push;
constexpr time_variable t;

struct N : inertial_frame<N> {};
struct Rod : rotated<Rod, N, w * t, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, s * Rod::x> {};
struct Bead : particle<Bead, P, m> {};
struct System
    : kane_system<inertial<N>, coordinates<s>, speeds<v>, kinematics<dot(s) == v>, parameters<m, w, g>,
                  inputs<push>, bodies<Bead>, loads<gravity<-g * N::y>, force<P, push * Rod::x>>> {};

} // namespace bead
