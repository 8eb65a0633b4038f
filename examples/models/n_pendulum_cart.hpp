#pragma once

#include <kanexpr/kanexpr.hpp>

#include <utility>

/// A chain of n massless rods, each with a bob at its end, suspended from a cart that a force drives along a
/// track. The angles are absolute; a rod is upright at q = pi/2.
namespace n_pendulum_cart {

using namespace kanexpr;
using namespace kanexpr::units::si;

template <int i>
constexpr coordinate<"q", i, i == 0 ? meter : radian> q; // q<0> is the position of the cart
template <int i>
constexpr speed<"u", i> u;
template <int i>
constexpr parameter<"m", i, kilogram> m;
template <int i>
constexpr parameter<"l", i, meter> l;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr input<"F", newton> F;

struct N : inertial_frame<N> {}; // y points up
struct O : origin<O, N> {};

template <int i>
struct Rod : rotated<Rod<i>, N, q<i + 1>, N::z> {};

template <int i>
struct P : offset<P<i>, P<i - 1>, l<i - 1> * Rod<i - 1>::x> {};
template <>
struct P<0> : offset<P<0>, O, q<0> * N::x> {}; // the cart

template <int i>
struct Bob : particle<Bob<i>, P<i>, m<i>> {};

template <class Bobs, class Rods>
struct chain;
template <int... bob, int... rod>
struct chain<std::integer_sequence<int, bob...>, std::integer_sequence<int, rod...>>
    : kane_system<inertial<N>, coordinates<q<bob>...>, speeds<u<bob>...>,
                  kinematics<(dot(q<bob>) == u<bob>)...>, parameters<m<bob>..., l<rod>..., g>, inputs<F>,
                  bodies<Bob<bob>...>, loads<gravity<-g * N::y>, force<P<0>, F * N::x>>> {};

template <int n>
struct System : chain<std::make_integer_sequence<int, n + 1>, std::make_integer_sequence<int, n>> {};

template <class Bobs, class Rods>
struct lagrange_chain;
template <int... bob, int... rod>
struct lagrange_chain<std::integer_sequence<int, bob...>, std::integer_sequence<int, rod...>>
    : lagrange_system<inertial<N>, coordinates<q<bob>...>, parameters<m<bob>..., l<rod>..., g>, inputs<F>,
                      bodies<Bob<bob>...>, loads<gravity<-g * N::y>, force<P<0>, F * N::x>>> {};

template <int n>
struct LagrangeSystem
    : lagrange_chain<std::make_integer_sequence<int, n + 1>, std::make_integer_sequence<int, n>> {};

} // namespace n_pendulum_cart
