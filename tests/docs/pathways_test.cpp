// builds: clang++ all
// Pathways and the loads along them: docs/guide/pathways.md.
#include "docs/no_mistake.hpp"

#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <cmath>
#include <gtest/gtest.h>

namespace {

using namespace kanexpr;
using docs::expect_no_mistake;

} // namespace

#include <docs/guide/pathways/hoist.cpp>

namespace {

// The tension of the cable at rest: its moment about the foot of the boom balances the weights.
TEST(pathways, hoist_balances) {
  expect_no_mistake<hoist::System>();
  using eom = equations_of_motion<hoist::System>;
  eom::parameters p{{hoist::m, 2}, {hoist::J, 0.5}, {hoist::g, 9.81}, {hoist::k, 1e3}, {hoist::c, 10}};
  const double elevation = 0.3, c = std::cos(elevation), s = std::sin(elevation);
  const double stretch = 2 * 9.81 / 1e3, rope = 2.5 + stretch - 1.5;
  const eom::state x{{hoist::q, elevation}, {hoist::z, rope}, {hoist::u, 0}, {hoist::w, 0}};
  const double across = std::hypot(2.5 * c, 2.5 * s - 2);
  const double arm = 2 * 2.5 * c / across; // of the cable about the foot
  const double weights = 9.81 * (2 * 2.5 + 3 * 2) * c;
  const auto udot = eom::udot(x, p, eom::inputs{{hoist::T, weights / arm}});
  EXPECT_NEAR(udot(0), 0, 1e-12);
  EXPECT_NEAR(udot(1), 0, 1e-12);
}

// Declarations that the snippets use.
namespace given {

constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr parameter<"m"> m;
constexpr parameter<"k"> k;
constexpr parameter<"k3"> k3;
constexpr parameter<"c"> c;
constexpr parameter<"r"> r;
constexpr parameter<"r1"> r1;
constexpr parameter<"r2"> r2;
constexpr parameter<"l0"> l0;
constexpr input<"F"> F;
struct N : inertial_ground<N> {};
struct B : rotated<B, N, q1, N::z> {};
struct C : offset<C, N, 0.5 * N::x> {};
struct R : offset<R, C, 0.3 * B::y> {};
struct D : offset<D, C, 1.0 * B::x> {};
struct Eye : offset<Eye, C, 0.5 * B::x + 0.4 * B::y> {};
struct S : offset<S, R, 0.4 * B::x + 0.1 * N::y> {};
struct E : offset<E, C, r * N::x> {};
struct P : offset<P, N, -q2 * N::x + 0.4 * N::z> {};
struct Q : offset<Q, C, 1.4 * B::x + 0.6 * B::z> {};
struct Bob : particle<Bob, Q, m> {};
struct Cart : particle<Cart, P, m> {};

template <class Loads>
struct system : kane_system<inertial<N>, coordinates<q1, q2>, speeds<u1, u2>, kinematics<simple>,
                            bodies<Bob, Cart>, Loads> {};

} // namespace given

using namespace given;

TEST(pathways, are_valid) {
  expect_no_mistake<system<loads<
#include <docs/guide/pathways/pathways.cpp>
      >>>();
  expect_no_mistake<system<loads<
#include <docs/guide/pathways/laws.cpp>
      >>>();
}

namespace series {

#include <docs/guide/pathways/series.cpp>

TEST(pathways, in_series) { expect_no_mistake<system<loads<force_along<Around_both, F>>>>(); }

} // namespace series

namespace quantities {

#include <docs/guide/pathways/quantities.cpp>

TEST(pathways, have_lengths_and_tensions_as_results) {
  expect_no_mistake<Tied>();
  auto model = derive<Tied>();
  for (const auto& found : {model.get<length>(), model.get<pull>(), model.get<against>()})
    EXPECT_EQ(found.rows, 1);
  EXPECT_EQ(model.mistake(), "");
}

} // namespace quantities

namespace mount {

constexpr parameter<"I"> I;
constexpr parameter<"g"> g;
struct C : offset<C, N, 0.5 * N::y> {};

#include <docs/guide/pathways/mount.cpp>

// The body hangs below its foot by m g / (2 k).
TEST(pathways, bushing_carries_a_weight) {
  expect_no_mistake<System>();
  using eom = equations_of_motion<System>;
  const eom::parameters p{{m, 3}, {I, 0.2}, {g, 9.81}, {k, 1000}, {c, 10}};
  eom::state x = eom::state::Zero();
  x(1) = 0.5 - 3 * 9.81 / 2000;
  x(6) = 1;
  EXPECT_LT(eom::udot(x, p).norm(), 1e-11);
}

} // namespace mount

TEST(pathways, are_built) {
  runtime::builder b("N");
  const auto q = b.coordinate("q");
  b.rates_as_speeds();
  const auto A = b.rotated("A", b.inertial_frame(), q, b.along(b.inertial_frame(), 0, 0, 1));
  const auto center = b.origin("C"), P = b.offset("P", center, b.along(A, 0.3, 0.0, 0.1)),
             Q = b.offset("Q", center, b.along(b.inertial_frame(), 1.0, 0.2, 0.0));
  b.particle("Bob", P, b.number(1));
  const auto radius = b.number(0.3), k = b.number(100), turning = b.number(5);
#include <docs/guide/pathways/builder.cpp>
  const auto model = derive(b);
  EXPECT_EQ(model.mistake(), "");
  EXPECT_FALSE(length.is_constant());
}

} // namespace
