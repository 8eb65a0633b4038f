// builds: clang++ all
// Robots from files: docs/robots.md, and their units: docs/guide/units.md.
#include <arm_picture.hpp>

#include <kanexpr/animate/page_text.hpp>
#include <kanexpr/robots.hpp>
#include <kanexpr/simulate.hpp>
#include <kanexpr/simulations/model.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>

namespace {

using namespace kanexpr;

TEST(robots, are_controlled) {
#include <docs/robots/control.cpp>
  ASSERT_TRUE(run) << run.cause();
  EXPECT_NEAR((run.state.q() - goal).norm(), 0, 2e-3);
#include <docs/robots/tool.cpp>
  const animation seen = animated<arm::picture>(run.trajectory);
  EXPECT_TRUE(seen) << seen.cause();
  const auto meshes = animate::read_meshes({{"", seen}}, ""); // the mesh of the upper arm
  EXPECT_TRUE(meshes) << meshes.cause();
  EXPECT_EQ(meshes.all.size(), 1u);
  EXPECT_LT(v.norm(), 0.05);
  EXPECT_EQ(equations_of_motion<Pushed>::inputs::RowsAtCompileTime, 4);
}

TEST(robots, know_their_units) {
  using namespace units::si;
  constexpr input<"push", newton> push;
  constexpr parameter<"k"> k;
#include <docs/guide/units/robot.cpp>
  EXPECT_EQ(units_of<Pushed>().of("T_elbow"), newton * meter);
}

TEST(robots, are_read_while_the_program_runs) {
  std::filesystem::current_path(KANEXPR_ROBOT_FILES);
#include <docs/robots/run_time.cpp>
  ASSERT_TRUE(read) << read.cause();
  ASSERT_TRUE(fall) << fall.cause();
  EXPECT_EQ(udot(Eigen::VectorXd::Zero(6), Eigen::VectorXd(), Eigen::Vector3d::Zero()).size(), 3);
}

} // namespace
