// Robots written by kanexpr_add_robot and derived by the compiler, compared with results of Pinocchio.
#include "robots/files.hpp"

#include <arm_robot.hpp>
#include <balancer.hpp>
#include <balancer_with_symbols.hpp>
#include <floating.hpp>
#include <gripper_robot.hpp>

#include <kanexpr/robots/read_urdf.hpp>
#include <kanexpr/robots/robot_builder.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace kanexpr;

template <class Vector>
Vector filled(const std::vector<double>& numbers) {
  Vector v;
  EXPECT_EQ(static_cast<std::size_t>(v.size()), numbers.size());
  std::ranges::copy(numbers, v.data());
  return v;
}

template <class Matrix>
void expect_equal(const Matrix& ours, const std::vector<double>& theirs) {
  double largest = 0;
  for (double e : theirs) largest = std::max(largest, std::abs(e));
  for (Eigen::Index i = 0; i < ours.size(); ++i)
    EXPECT_NEAR(ours(i / ours.cols(), i % ours.cols()), theirs[static_cast<std::size_t>(i)], 1e-12 * largest)
        << i;
}

template <class System>
void agrees(const std::string& robot, const parameter_values<System>& p) {
  using eom = equations_of_motion<System>;
  const auto references = robot_files::references_of(robot);
  ASSERT_EQ(references.size(), 2u);
  for (const robot_files::reference& there : references) {
    const auto x = filled<state<System>>(there.at("state"));
    const auto r = filled<input_values<System>>(there.at("inputs"));
    const auto [mass, forcing] = eom::together(eom::mass_matrix, eom::forcing)(x, p, r);
    expect_equal(mass, there.at("mass"));
    expect_equal(forcing, there.at("forcing"));
  }
}

TEST(compiled_robots, agree_with_pinocchio) {
  agrees<arm_robot::System>("arm.fixed", {});
  agrees<::floating::System>("walker.floating", {});
  agrees<gripper_robot::System>("gripper.fixed", gripper_robot::values());
}

// Links without gravity, compared with the run-time model.
TEST(compiled_robots, let_links_without_gravity_float) {
  const robots::read_robot read = robots::read_urdf(robot_files::path_of("balancer.urdf"));
  ASSERT_TRUE(read) << read.cause();
  const robots::robot_builder built(read.robot);
  model there = derive(built);
  auto udot = there.function(there.udot());
  Eigen::Vector<double, 6> x;
  x << 0.4, -1.1, 0.3, 0.7, -0.2, 0.9;
  const Eigen::Vector3d r(0.5, 0.3, -0.8);
  const Eigen::Vector3d wanted = udot(x, Eigen::VectorXd(), r);
  using by_numbers = equations_of_motion<::balancer::System>;
  using by_symbols = equations_of_motion<::balancer_with_symbols::System>;
  EXPECT_LT((by_numbers::udot(x, by_numbers::parameters(), r) - wanted).norm(), 1e-12 * wanted.norm());
  EXPECT_LT((by_symbols::udot(x, ::balancer_with_symbols::values(), r) - wanted).norm(),
            1e-12 * wanted.norm());
}

// A joint of the arm takes two lines, and merged links remain available.
TEST(compiled_robots, can_be_asked_for_their_links) {
  state<arm_robot::System> x = arm_robot::at_rest();
  x[arm_robot::q_waist] = 0.3, x[arm_robot::u_waist] = 2;
  const Eigen::Vector3d v = function<arm_robot::System, velocity_of<arm_robot::Tool>>{}(x);
  EXPECT_NEAR(v.z(), 0, 1e-15);
  EXPECT_GT(v.norm(), 0.1);
  EXPECT_EQ(arm_robot::limits::effort[1], 60);
  EXPECT_EQ(::floating::at_rest()[::floating::e0], 1);
}

} // namespace
