// Six beads on six wires, with four constraints that contain all speeds, so that the dependent speeds form
// one block.
#pragma once

#include <kanexpr/kanexpr.hpp>

namespace dense_constraints {

using namespace kanexpr;

template <int i>
inline constexpr coordinate<"q", i> q;
template <int i>
inline constexpr speed<"u", i> u;
constexpr parameter<"m"> m;
constexpr parameter<"k"> k;
constexpr parameter<"a"> a;
constexpr input<"F"> F;
constexpr time_variable t;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};

template <int i>
struct P : offset<P<i>, O, q<i> * N::x> {};
template <int i>
struct Bead : particle<Bead<i>, P<i>, (i + 1) * m> {};
template <int i>
using spring = force<P<i>, -k * q<i> * N::x>;

template <int i>
constexpr double n = i; // an integer 0 may be a truncated quotient
template <int i>
constexpr auto bound = u<0> * cos(q<0> + n<i>) + u<1> * (a + sin(n<i> * q<1>)) + u<2> * cos(n<i> * q<2> - a) +
                           u<3> * (n<i> - q<3>)+u<4> * sin(q<4> + n<i * i>) + u<5> * (a - n<i> * q<5>) ==
                       sin(n<i> * t);

struct System
    : kane_system<
          inertial<N>, coordinates<q<0>, q<1>, q<2>, q<3>, q<4>, q<5>>,
          speeds<u<0>, u<1>, u<2>, u<3>, u<4>, u<5>>,
          kinematics<dot(q<0>) == u<0>, dot(q<1>) == u<1>, dot(q<2>) == u<2>, dot(q<3>) == u<3>,
                     dot(q<4>) == u<4>, dot(q<5>) == u<5>>,
          velocity_constraints<bound<0>, bound<1>, bound<2>, bound<3>>, dependent<u<1>, u<2>, u<3>, u<5>>,
          inputs<F>, bodies<Bead<0>, Bead<1>, Bead<2>, Bead<3>, Bead<4>, Bead<5>>,
          loads<spring<0>, spring<1>, spring<2>, spring<3>, spring<4>, spring<5>, force<P<0>, F * N::x>>> {};

} // namespace dense_constraints
