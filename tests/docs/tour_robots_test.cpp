// builds: clang++ all
// Joints and robots in docs/tour.md.
#include <iiwa_robot.hpp>

#include <kanexpr/joints.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr;

#include <docs/tour/joints.cpp>

TEST(tour, swings_an_arm) {
  const state<Arm> x{{q_of<Upper>, 0}, {q_of<Lower>, 0}, {u_of<Upper>, 0}, {u_of<Lower>, 0}};
  const Eigen::Vector2d a =
      equations_of_motion<Arm>::udot(x, parameter_values<Arm>(), input_values<Arm>::Zero());
  EXPECT_GT(a(0), 0); // about y, with z up
}

TEST(tour, holds_a_robot) {
#include <docs/tour/robot.cpp>
  EXPECT_LT(a.norm(), 1e-12);
}

} // namespace
