// builds: clang++ all
// Operating points of systems derived by Lagrange's method, and of systems that depend on prescribed
// quantities and on time.
#include "models/rocket.hpp"
#include "models/rotating_tube.hpp"
#include "models/simple_pendulum.hpp"

#include <kanexpr/operating_point.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using kanexpr::dot;

TEST(operating_point, is_found_with_lagranges_equations) {
  using namespace simple_pendulum;
  using lagrange_point = kanexpr::operating_point<LagrangeSystem>;
  const double mgl = 2 * 0.5 * 9.81;
  const lagrange_point hanging({{q, 0.2}, {dot(q), 0.1}}, {{m, 2}, {l, 0.5}, {g, 9.81}, {c, 0.1}},
                               {.inputs = {{T, 1.7}}, .held = {T}});
  ASSERT_TRUE(hanging) << hanging.cause();
  EXPECT_NEAR(hanging.x[q], std::asin(1.7 / mgl), 1e-14);
  EXPECT_EQ(hanging.residuals()[1].name, "the second derivative of coordinate q");
  const lagrange_point turning({{q, 1}, {"q'", 0}}, {{m, 2}, {l, 0.5}, {g, 9.81}, {c, 0.1}},
                               {.held = {q}, .rates = {{dot(q), 3}}});
  ASSERT_TRUE(turning) << turning.cause();
  EXPECT_NEAR(turning.r[T], mgl * std::sin(1) + 0.1 * 3, 1e-14);
}

TEST(operating_point, leaves_prescribed_quantities_as_they_are) {
  using namespace rotating_tube;
  const double turn = 3, angle = 0.4, spring = 80, mass = 1.5, rest = 0.7;
  const kanexpr::given_parameters<System> p{{m, mass}, {k, spring}, {q0, rest}, {g, 9.81}, {c, 0.2}};
  const kanexpr::operating_point<System> bead({{q, 0.5}}, p,
                                              {.inputs = {{theta, angle}, {dot(theta), turn}}});
  ASSERT_TRUE(bead) << bead.cause();
  EXPECT_NEAR(bead.x[q], (spring * rest - mass * 9.81 * std::sin(angle)) / (spring - mass * turn * turn),
              1e-14);
  EXPECT_EQ(bead.r[theta], angle);
  EXPECT_EQ(bead.freedom, 0);
  // the angle at which the bead lies at 0.66
  const kanexpr::operating_point<System> freed(
      {{q, 0.66}}, p, {.inputs = {{theta, angle}, {dot(theta), turn}}, .held = {q}, .freed = {theta}});
  ASSERT_TRUE(freed) << freed.cause();
  EXPECT_NEAR(freed.r[theta],
              std::asin((spring * rest - 0.66 * (spring - mass * turn * turn)) / (mass * 9.81)), 1e-13);
  EXPECT_EQ(freed.r[dot(theta)], turn);
}

TEST(operating_point, is_a_steady_climb) {
  using namespace rocket;
  const kanexpr::operating_point<System> climb(
      {{u, 50}}, {{g, 9.81}, {cd, 0.3}},
      {.inputs = {{m, 2000}, {dot(m), -12}}, .held = {u}, .changing = {q}});
  ASSERT_TRUE(climb) << climb.cause();
  EXPECT_NEAR(climb.r[T], 2000 * 9.81 + 0.3 * 50 * 50 - 12 * 50, 1e-11);
  EXPECT_EQ(climb.freedom, 1); // the height
  const kanexpr::operating_point<System> hover({}, {{g, 9.81}, {cd, 0.3}}, {.inputs = {{m, 2000}}});
  ASSERT_TRUE(hover) << hover.cause();
  EXPECT_NEAR(hover.r[T], 2000 * 9.81, 1e-11);
}

} // namespace
