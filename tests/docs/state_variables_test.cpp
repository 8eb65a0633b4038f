// builds: clang++ all
// State variables: docs/guide/state-variables.md.
#include "docs/no_mistake.hpp"

#include <kanexpr/blocks.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include <docs/guide/state-variables/motor.cpp>

namespace {

TEST(state_variables, are_part_of_the_results) {
  using namespace geared;
  const parameter_values<System> p{{m, 2}, {l, 0.5}, {g, 9.81},   {k, 3},
                                   {R, 2}, {L, 0.1}, {tau, 0.25}, {"gain", 40}};
  const input_values<System> inputs{{r, 1}};
#include <docs/guide/state-variables/results.cpp>
  EXPECT_EQ(current, 0.1);
  EXPECT_EQ(x.z()(0), 0.1);
  EXPECT_EQ(x.u().size(), 1);
  EXPECT_EQ(rates(3), 4);
  EXPECT_NEAR(rates(2), (40 * (0 - 0.3) - 2 * 0.1) / 0.1, 1e-12);
  EXPECT_EQ(A_.rows(), 4);
  EXPECT_EQ(B_.cols(), 1);
}

TEST(state_variables, are_built) {
  kanexpr::runtime::builder b("N");
  const auto q = b.coordinate("q"), u = b.speed("u"), tau = b.parameter("tau"), k = b.parameter("k"),
             r = b.input("r");
  b.kinematic_equation(b.dot(q) - u);
  const auto N = b.inertial_frame();
  const auto P = b.offset("P", b.origin("O"), b.along(N, q, 0.0, 0.0));
  b.particle("Cart", P, b.number(1));
#include <docs/guide/state-variables/built.cpp>
  EXPECT_EQ((b.check)().view(), "");
}

} // namespace

namespace cart {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"tau"> tau;
constexpr parameter<"T"> T;
constexpr parameter<"kp"> kp;
constexpr parameter<"ki"> ki;
constexpr parameter<"kd"> kd;
constexpr parameter<"Td"> Td;
constexpr parameter<"Tt"> Tt;
constexpr parameter<"Tv"> Tv;
constexpr parameter<"Fmax"> Fmax;
constexpr parameter<"rate"> rate;
constexpr input<"r"> r;
struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, q * N::x> {};
struct Cart : particle<Cart, P, 1> {};
#include <docs/guide/state-variables/blocks.cpp>

TEST(blocks, belong_to_a_system) { docs::expect_no_mistake<System>(); }

} // namespace cart

namespace wheel {

using namespace kanexpr;

constexpr parameter<"R"> R;
constexpr parameter<"L"> L;
constexpr parameter<"k"> k;
constexpr parameter<"n"> n;
constexpr parameter<"b"> b;
constexpr input<"V"> V;
struct N : inertial_ground<N> {};
struct Wheel : pin<Wheel, N, axis<N::z>, body<1, 0.1 * own::x, inertia<own, 1, 1, 1>>> {};
constexpr parameter<"alpha"> alpha;
constexpr parameter<"C"> C;
constexpr parameter<"J"> J;
constexpr parameter<"Rth"> Rth;
// clang-format off
struct Cold : kane_system<inertial<N>, joints<Wheel>,
#include <docs/guide/state-variables/dc_motor.cpp>
> {};
struct System : kane_system<inertial<N>, joints<Wheel>,
#include <docs/guide/state-variables/heated.cpp>
> {};
// clang-format on

TEST(dc_motor, brings_its_current_and_its_heat) {
  docs::expect_no_mistake<Cold>();
  state<System> x;
#include <docs/guide/state-variables/current.cpp>
  EXPECT_EQ(x(2), 0.5);
  EXPECT_EQ(x(3), 20);
}

} // namespace wheel
