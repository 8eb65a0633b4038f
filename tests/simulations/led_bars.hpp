// Two bars on a pin; the end of the second is guided along a line perpendicular to the ground.
#pragma once

#include <kanexpr/simulate.hpp>
#include <kanexpr/simulations/prescribe.hpp>

#include <gmock/gmock.h>

#include <algorithm>

namespace led_bars {

using namespace kanexpr;

constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr prescribed<"x"> x;

struct N : inertial_frame<N> {}; // y points up
struct A : rotated<A, N, q1, N::z> {};
struct B : rotated<B, N, q2, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, A::x> {};
struct Q : offset<Q, P, B::x> {};
struct Upper : particle<Upper, P, 1> {};
struct Lower : particle<Lower, Q, 2> {};

struct System
    : kane_system<inertial<N>, coordinates<q1, q2>, speeds<u1, u2>, kinematics<dot(q1) == u1, dot(q2) == u2>,
                  configuration_constraints<dot(position_of<Q, O>, N::x) == x>, dependent<q2, u2>,
                  inputs<x, dot(x), dot(dot(x))>, bodies<Upper, Lower>, loads<gravity<-9.81 * N::y>>> {};

inline auto led_at(double start, double speed) {
  return [=](double t, const state<System>&, input_values<System>& r) {
    prescribe(r, x, t, [&](auto time) { return start + speed * time; });
  };
}

// At x = 2 the bars are aligned and the constraint is singular; beyond, no state exists.
template <integrator by>
void ends_where_they_are_stretched() {
  for (const double every : {0.0, 0.1}) {
    const auto run =
        simulate<System, by>({{q1, 0.5}, {q2, -0.5}, {u1, 0}}, {}, {0, 9},
                             {.inputs = led_at(1.8, 0.1), .guesses_dependent = true, .output_every = every});
    EXPECT_FALSE(run);
    EXPECT_THAT(run.cause(), testing::StartsWith("the simulation ended at t = "));
    EXPECT_THAT(run.cause(), testing::HasSubstr("q1 = "));
    EXPECT_NEAR(run.time, 2, 1e-2);
    ASSERT_GT(run.trajectory.size(), 5u);
    EXPECT_TRUE(run.trajectory.back().x.allFinite());
    EXPECT_EQ(run.trajectory.back().t, run.time);
    EXPECT_EQ(run.trajectory.back().x, run.state);
    EXPECT_LT(std::ranges::max(run.trajectory.constraint_residuals()), 1e-7);
  }
}

} // namespace led_bars
