// builds: clang++
#include "oracles.hpp"

#include <Eigen/LU>
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace {

using testing::ElementsAre;

class systems : public testing::TestWithParam<const char*> {};

TEST_P(systems, agree_with_themselves) {
  const oracle::system s = oracle::load(GetParam());
  EXPECT_EQ(s.states.size(), 20u);
  for (const oracle::state& state : s.states) {
    EXPECT_EQ(std::size_t(state.q.size()), s.q.size());
    EXPECT_EQ(std::size_t(state.u.size()), s.u.size());
    EXPECT_EQ(std::size_t(state.r.size()), s.r.size());
    EXPECT_TRUE(oracle::close(state.mass_matrix * state.udot, state.forcing, 1e-9));
  }
  for (const oracle::linearization& l : s.linearizations) {
    EXPECT_EQ(l.x.size(), l.eigenvalues.size());
    EXPECT_EQ(l.A.rows(), l.A.cols());
    EXPECT_EQ(std::size_t(l.B.cols()), l.B.cols() == 0 ? 0 : s.r.size());
  }
}

INSTANTIATE_TEST_SUITE_P(oracles, systems,
                         testing::Values("arm3_spatial", "bicycle_whipple", "chaplygin_sleigh",
                                         "double_pendulum", "four_bar", "npendulum_cart_n5",
                                         "pendulum_nonminimal", "quaternion_pivot_body",
                                         "rocket_variable_mass", "rolling_disc", "rolling_torus",
                                         "rotating_tube", "simple_pendulum", "spinning_top"),
                         [](const auto& p) { return std::string(p.param); });

class robots : public testing::TestWithParam<const char*> {};

TEST_P(robots, agree_with_themselves) {
  const oracle::robot r = oracle::load_robot(GetParam());
  EXPECT_EQ(r.states.size(), 20u);
  for (const oracle::link& l : r.links) EXPECT_TRUE(l.rotation.isUnitary(1e-9));
  for (const oracle::robot_state& s : r.states) {
    EXPECT_TRUE(oracle::close(s.mass_matrix * s.udot + s.bias, s.torque, 1e-6));
    EXPECT_TRUE(oracle::close(s.mass_matrix * s.a + s.bias, s.inverse_dynamics, 1e-9));
  }
}

INSTANTIATE_TEST_SUITE_P(oracles, robots, testing::Values("arm_iiwa", "arm_puma_full", "quadruped_anymal"),
                         [](const auto& p) { return std::string(p.param); });

TEST(oracles, names_are_those_of_a_model) {
  EXPECT_THAT(oracle::load("rotating_tube").r, ElementsAre("theta", "theta'", "theta''"));
  EXPECT_THAT(oracle::load("rocket_variable_mass").r, ElementsAre("m", "m'", "T"));
  EXPECT_THAT(oracle::load("pendulum_nonminimal").q_dependent, ElementsAre("q1"));
}

TEST(oracles, canonical_bicycle) {
  const oracle::bicycle b = oracle::load_bicycle();
  EXPECT_EQ(b.A.size(), 11u);
  EXPECT_TRUE(
      oracle::close(b.A.at(0).bottomLeftCorner<2, 2>(), -b.parameters.at("g") * b.M.inverse() * b.K0, 1e-12));
}

TEST(relative_error, is_infinite_for_what_cannot_be_compared) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(oracle::relative_error(Eigen::Vector2d(1, 2), Eigen::Vector3d(1, 2, 3)), infinity);
  EXPECT_EQ(oracle::relative_error(Eigen::Vector2d(1, std::nan("")), Eigen::Vector2d(1, 2)), infinity);
  EXPECT_DOUBLE_EQ(oracle::relative_error(Eigen::Vector2d(1, 2), Eigen::Vector2d(1, 4)), 0.5);
}

} // namespace
