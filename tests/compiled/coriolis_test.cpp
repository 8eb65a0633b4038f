// The Coriolis matrix of a ball on a rotating rod, computed by hand.
#include <kanexpr/kanexpr.hpp>

#include <gtest/gtest.h>

namespace {

/// Speeds in a different order from their coordinates, a declared velocity, and a Lagrangian with a part that
/// is linear in the rates.
namespace slider {
using namespace kanexpr;
constexpr coordinate<"q"> q;
constexpr coordinate<"d"> d;
constexpr speed<"u"> u;
constexpr speed<"v"> v;
constexpr parameter<"m"> m;
struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct A : rotated<A, N, q, N::z> {};
struct P : offset<P, O, (2 + d) * A::x>, velocity<A, v * A::x> {};
struct Ball : particle<Ball, P, m> {};
struct System : kane_system<inertial<N>, coordinates<d, q>, speeds<u, v>,
                            kinematics<dot(q) == u, dot(d) == v>, bodies<Ball>> {};
struct Whole : lagrange_system<inertial<N>, coordinates<d, q>,
                               lagrangian<m * dot(d) * dot(d) / 2 + m * pow(2 + d, 2) * dot(q) * dot(q) / 2 +
                                          sin(q) * dot(d) - d * q>> {};
} // namespace slider

TEST(coriolis, is_that_of_speeds_in_any_order) {
  using namespace slider;
  using eom = equations_of_motion<System>;
  const eom::state x{{q, 0.3}, {d, 0.5}, {u, 0.7}, {v, -0.2}};
  const Eigen::Matrix2d C = eom::coriolis(x, eom::parameters(2)); // m (2 + d) (2 u v) and −m (2 + d) u²
  Eigen::Matrix2d expected;
  expected << 5 * -0.2, 5 * 0.7, -5 * 0.7, 0;
  EXPECT_LE((C - expected).norm(), 1e-14);
}

TEST(coriolis, is_that_of_a_lagrangian) {
  using namespace slider;
  using eom = equations_of_motion<Whole>;
  const eom::state x{{q, 0.3}, {d, 0.5}, {dot(q), 0.7}, {dot(d), -0.2}};
  const Eigen::Matrix2d C = eom::coriolis(x, eom::parameters(2));
  Eigen::Matrix2d expected;
  expected << 0, -5 * 0.7, 5 * 0.7, 5 * -0.2;
  EXPECT_LE((C - expected).norm(), 1e-14);
}

} // namespace
