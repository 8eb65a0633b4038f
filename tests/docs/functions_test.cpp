// builds: clang++
// Functions of models: docs/guide/functions.md.
#include "docs/complete.hpp"

#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"q0"> q0;
constexpr parameter<"k"> k;
constexpr parameter<"c"> c;
constexpr parameter<"b"> b;
constexpr parameter<"T0"> T0;
constexpr input<"T"> T;
struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, A::x> {};
struct Bob : particle<Bob, P, 1> {};

template <class... Loads>
struct moved : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                           loads<Loads...>> {};

using choices = moved<
#include <docs/guide/functions/choices.cpp>
    >;

constexpr parameter<"q1"> q1;
constexpr parameter<"v"> v;
constexpr parameter<"width"> width;

using smooth_ones = moved<
#include <docs/guide/functions/smooth.cpp>
    >;

TEST(functions, are_smooth) { EXPECT_EQ(derive<smooth_ones>().mistake(), ""); }

using wrapped_ones = moved<
#include <docs/guide/functions/wrapped.cpp>
    >;

TEST(functions, are_wrapped) { EXPECT_EQ(derive<wrapped_ones>().mistake(), ""); }

constexpr parameter<"F1"> F1;
constexpr parameter<"F2"> F2;

using tables = moved<
#include <docs/guide/functions/tables.cpp>
    >;

TEST(functions, are_tables) { EXPECT_EQ(derive<tables>().mistake(), ""); }

#include <docs/guide/functions/external.cpp>

constexpr parameter<"m"> m;
constexpr parameter<"g"> g;

using with_a_tyre = moved<
#include <docs/guide/functions/tyre.cpp>
    >;

TEST(functions, are_those_of_the_program) {
  using eom = equations_of_motion<with_a_tyre>;
  const eom::state x{{q, 0.3}, {u, 0.2}};
  const eom::parameters p{{v, 2}, {m, 3}, {g, 9.81}};
  const double force = 3 * 9.81 * std::sin(1.6 * std::atan(10 * 0.1));
  EXPECT_NEAR(eom::udot(x, p)(0), -force * std::cos(0.3), 1e-12);
}

TEST(functions, choose) {
  EXPECT_EQ(derive<choices>().mistake(), "");
  EXPECT_EQ(derive<choices>().forcing().entries.size(), 1);
}

} // namespace
