// builds: clang++
// Steady motions in closed form: a disc that rolls in a circle, and a bead on a hoop that spins.
#include "models/rolling_disc_constrained.hpp"

#include <kanexpr/operating_point.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace hoop {

using namespace kanexpr;

constexpr coordinate<"q"> q; // from the lowest point
constexpr speed<"u"> u;
constexpr parameter<"m"> m;
constexpr parameter<"radius"> radius;
constexpr parameter<"g"> g;
constexpr parameter<"w"> w; // of the hoop about its vertical diameter
constexpr time_variable t;

struct N : inertial_frame<N> {}; // z points up
struct Hoop : rotated<Hoop, N, w * t, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, radius*(sin(q) * Hoop::x - cos(q) * Hoop::z)> {};
struct Bead : particle<Bead, P, m> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>,
                            parameters<m, radius, g, w>, bodies<Bead>, loads<gravity<-g * N::z>>> {};

} // namespace hoop

namespace {

constexpr double pi = std::numbers::pi;

TEST(operating_point, is_where_a_bead_rests_on_a_hoop) {
  using namespace hoop;
  const kanexpr::given_parameters<System> p{{m, 0.3}, {radius, 0.25}, {g, 9.81}, {w, 8}};
  const kanexpr::operating_point<System> raised({{q, 0.6}}, p, {.t = 1.7});
  ASSERT_TRUE(raised) << raised.cause();
  EXPECT_NEAR(raised.x[q], std::acos(9.81 / (8 * 8 * 0.25)), 1e-14);
  const kanexpr::operating_point<System> low({{q, 0.1}}, p);
  ASSERT_TRUE(low) << low.cause();
  EXPECT_NEAR(low.x[q], 0, 1e-15);
  const kanexpr::operating_point<System> freed({{q, pi / 3}}, p, {.held = {q}, .freed = {w}});
  ASSERT_TRUE(freed) << freed.cause();
  EXPECT_NEAR(freed.p[w], std::sqrt(2 * 9.81 / 0.25), 1e-13);
  // below sqrt(g/r) there is no raised equilibrium
  const kanexpr::operating_point<System> none({{q, 0.5}}, {{m, 0.3}, {radius, 0.25}, {g, 9.81}, {w, 5}},
                                              {.held = {q}});
  EXPECT_FALSE(none);
  EXPECT_NE(none.cause().find("the rate of speed u is -8.29 where"), std::string::npos) << none.cause();
}

// 5 ψ̇² sinθ + 6 ψ̇ φ̇ + 4 (g/r) tanθ = 0 of a thin disc with lean θ, yaw ψ and spin φ: Routh, Dynamics of a
// System of Rigid Bodies, Advanced Part (1905), article 244.
double spin_in_circle(double lean, double yaw_rate, double radius) {
  return -(5 * yaw_rate * yaw_rate * std::sin(lean) + 4 * 9.81 / radius * std::tan(lean)) / (6 * yaw_rate);
}

TEST(operating_point, is_a_disc_that_rolls_in_a_circle) {
  using namespace rolling_disc_constrained;
  for (const double lean : {0.1, -0.4, 0.9})
    for (const double yaw_rate : {1.3, -2.1}) {
      const double spin = spin_in_circle(lean, yaw_rate, 0.35);
      const kanexpr::operating_point<System> circle(
          {{q1, 0.8}, {q2, lean}, {u2, spin / 2}, {u3, yaw_rate}, {q4, 3}}, {{r, 0.35}, {m, 2}, {g, 9.81}},
          {.held = {q1, q2}, .changing = {q3, q4, q5, u4, u5}, .rates = {{dot(q1), yaw_rate}}});
      ASSERT_TRUE(circle) << circle.cause();
      const auto rates = kanexpr::equations_of_motion<System>::rhs(circle.x, circle.p);
      EXPECT_NEAR(rates(2), spin, 1e-11 * std::abs(spin));
      EXPECT_NEAR(rates(0), yaw_rate, 1e-13);
      EXPECT_LE(kanexpr::equations_of_motion<System>::velocity_residual(circle.x, circle.p).norm(), 1e-12);
      EXPECT_LE(rates.segment<3>(5).norm(), 1e-10);
      // the center moves on a circle at the yaw rate: its acceleration is perpendicular to its velocity
      EXPECT_NEAR(rates(8), -yaw_rate * circle.x[u5], 1e-10);
      EXPECT_NEAR(rates(9), yaw_rate * circle.x[u4], 1e-10);
      EXPECT_EQ(circle.freedom, 3); // spin angle and position of the center
    }
}

} // namespace
