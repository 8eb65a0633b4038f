// builds: clang++ all
// A bicycle that circles without a steering torque.
#include "models/bicycle.hpp"

#include <kanexpr/operating_point.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace bicycle;
using eom = kanexpr::equations_of_motion<BoundSystem>;
using operating_point = kanexpr::operating_point<BoundSystem>;

constexpr double rear_radius = 0.3, front_radius = 0.35;

eom::state straight_ahead(double v) {
  eom::state x;
  x[u3] = v / rear_radius;
  x[u6] = v / front_radius;
  return x;
}

operating_point turn(double lean, double v) {
  eom::state x = straight_ahead(v);
  x[q2] = lean;
  return operating_point(x, {}, {.held = {q2}, .changing = {q1}});
}

TEST(operating_point, is_a_turn_of_a_bicycle) {
  for (const double lean : {0.02, 0.2, 0.4}) {
    const operating_point left = turn(lean, 6);
    ASSERT_TRUE(left) << left.cause();
    EXPECT_EQ(left.x[q2], lean);
    const auto [constraints, rates] = eom::together(eom::constraint_residual, eom::rhs)(left.x);
    ASSERT_TRUE(rates.status);
    EXPECT_LE(rates.tail<6>().norm(), 1e-10);
    EXPECT_LE(rates.segment<3>(1).norm(), 1e-12);
    EXPECT_LE(constraints.norm(), 1e-12);
    EXPECT_GT(std::abs(rates(0)), 1e-3); // it turns
    EXPECT_EQ(left.freedom, 1);          // its direction

    const operating_point right = turn(-lean, 6);
    ASSERT_TRUE(right) << right.cause();
    eom::state mirrored = left.x;
    for (double* turned :
         {&mirrored[q1], &mirrored[q2], &mirrored[q5], &mirrored[u1], &mirrored[u2], &mirrored[u5]})
      *turned = -*turned;
    EXPECT_LE((right.x - mirrored).norm(), 1e-9);
  }
}

// With little lean it circles only at the critical speed of the capsize mode, and the steering angle is that
// of the linearized equations of Meijaard, Papadopoulos, Ruina & Schwab (2007), table 2 and equation (5.3),
// in a steady turn.
TEST(operating_point, tends_to_the_capsize_speed) {
  const double lean = 1e-4;
  const operating_point slight = turn(lean, 6);
  ASSERT_TRUE(slight) << slight.cause();
  const double v = slight.x[u3] * rear_radius;
  EXPECT_NEAR(v, 6.024262015388, 1e-6);
  const double steer = lean * 9.81 * 80.95 / (76.59734589573222 * v * v - 9.81 * 2.59951685249872);
  EXPECT_NEAR(std::abs(slight.x[q5]), steer, 1e-6 * steer);
}

TEST(operating_point, does_not_exist_for_an_unsteered_bicycle_at_a_different_speed) {
  eom::state x = straight_ahead(4);
  x[q2] = 0.1;
  const operating_point none(x, {}, {.held = {q2, u3}, .changing = {q1}});
  EXPECT_FALSE(none);
  const auto& left = none.residuals();
  const auto worst = std::max_element(left.begin(), left.end(), [](const auto& a, const auto& b) {
    return std::abs(a.value) < std::abs(b.value);
  });
  EXPECT_GT(std::abs(worst->value), 1e-3);
  EXPECT_NE(none.cause().find("the rate of "), std::string::npos) << none.cause();
}

} // namespace
