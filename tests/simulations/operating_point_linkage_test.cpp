// builds: clang++ all
// A four-bar linkage that is held by a motor: more equations than unknowns, but consistent ones.
#include "models/four_bar.hpp"

#include <kanexpr/operating_point.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace four_bar;
using operating_point = kanexpr::operating_point<System>;

const kanexpr::given_parameters<System> dimensions{{l0, 2},   {l1, 0.7},  {l2, 1.8},  {l3, 1.2}, {d1, 0.3},
                                                   {d2, 0.8}, {d3, 0.5},  {m1, 1.5},  {m2, 2.5}, {m3, 0.9},
                                                   {g, 9.81}, {I1, 0.01}, {I2, 0.02}, {I3, 0.03}};

// The angles of coupler and rocker by the law of cosines, and with them the potential energy.
struct linkage {
  double coupler, rocker; // against the ground
  explicit linkage(double crank) {
    const double x = 2 - 0.7 * std::cos(crank), y = -0.7 * std::sin(crank), diagonal = std::hypot(x, y);
    coupler =
        std::atan2(y, x) + std::acos((1.8 * 1.8 + diagonal * diagonal - 1.2 * 1.2) / (2 * 1.8 * diagonal));
    rocker = std::atan2(y - 1.8 * std::sin(coupler), x - 1.8 * std::cos(coupler));
  }
  double energy(double crank) const {
    const double s1 = std::sin(crank), s2 = std::sin(coupler), s3 = std::sin(rocker);
    return 9.81 * (1.5 * 0.3 * s1 + 2.5 * (0.7 * s1 + 0.8 * s2) + 0.9 * (0.7 * s1 + 1.8 * s2 + 0.5 * s3));
  }
};
double energy_at(double crank) { return linkage(crank).energy(crank); }

TEST(operating_point, is_a_linkage_that_a_motor_holds) {
  for (const double crank : {0.9, 2.3, -1.1, 4.0}) {
    const linkage built(crank);
    // the guess is inconsistent and moving
    const operating_point held({{q1, crank},
                                {q2, built.coupler - crank + 0.2},
                                {q3, built.rocker - built.coupler - 0.2},
                                {u1, 0.5},
                                {u3, -0.3}},
                               dimensions, {.held = {q1}});
    ASSERT_TRUE(held) << held.cause();
    EXPECT_EQ(held.residuals().size(), 10U); // of 6 unknowns
    EXPECT_EQ(held.freedom, 0);
    EXPECT_NEAR(std::remainder(held.x[q2] - (built.coupler - crank), 2 * M_PI), 0, 1e-13);
    EXPECT_NEAR(std::remainder(held.x[q3] - (built.rocker - built.coupler), 2 * M_PI), 0, 1e-13);
    EXPECT_LE(held.x.u().norm(), 1e-14);
    const double h = 1e-3;
    const double slope = (8 * (energy_at(crank + h) - energy_at(crank - h)) -
                          (energy_at(crank + 2 * h) - energy_at(crank - 2 * h))) /
                         (12 * h);
    EXPECT_NEAR(held.r[T], slope, 1e-10 * 30);
  }
}

TEST(operating_point, is_where_a_linkage_comes_to_rest) {
  const linkage built(-1.8);
  const operating_point rest({{q1, -1.8}, {q2, built.coupler + 1.8}, {q3, built.rocker - built.coupler}},
                             dimensions, {.held = {T}});
  ASSERT_TRUE(rest) << rest.cause();
  const double crank = rest.x[q1], h = 1e-4;
  EXPECT_NEAR((energy_at(crank + h) - energy_at(crank - h)) / (2 * h), 0, 1e-6);
  EXPECT_GT(std::abs(crank + 1.8), 1e-3);
}

TEST(operating_point, is_found_from_a_state_whose_motion_is_known) {
  // stretched out: coupler and rocker in line
  kanexpr::parameter_values<System> p = dimensions.values;
  p[l0] = 3.7;
  const operating_point none({{q1, 0}}, p, {.held = {q1}});
  EXPECT_EQ(
      none.cause(),
      "at the guess: the constraints cannot be solved for the dependent speeds u2 and u3 at this state");
  // too far apart
  p[l0] = 5;
  const operating_point torn({{q1, 0.4}, {q2, 0.3}, {q3, -1}}, p, {.held = {q1}});
  EXPECT_FALSE(torn);
  EXPECT_TRUE(torn.cause().starts_with("no operating point: ")) << torn.cause();
}

} // namespace
