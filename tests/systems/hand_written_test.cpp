// builds: clang++
// The handwritten systems, compared with the reference results; they serve as a reference for models at other
// states.
#include "oracles.hpp"
#include "systems/hand_written.hpp"

namespace {

using Eigen::VectorXd;
using hand_written::pick;

// The values of the speeds that the oracle has.
void agrees(const hand_written::system& system, const oracle::system& reference, const oracle::state& s) {
  const VectorXd q = pick(system.q, reference.q, s.q);
  const VectorXd qdot = hand_written::rates_for(system, q, reference.u, s.u);
  const hand_written::solution found = hand_written::solve(system, q, qdot);
  EXPECT_TRUE(oracle::close(pick(reference.u, system.u, found.speeds), s.u, 1e-13));
  EXPECT_TRUE(oracle::close(pick(reference.u, system.u, found.udot), s.udot, 1e-12));
  EXPECT_TRUE(oracle::close(pick(reference.q, system.q, qdot), s.qdot, 1e-12));
  EXPECT_NEAR(found.kinetic_energy, s.kinetic_energy.value(), 1e-12 * found.kinetic_energy);
}

TEST(hand_written, sleigh) {
  const oracle::system reference = oracle::load("chaplygin_sleigh");
  for (const oracle::state& s : reference.states)
    agrees(hand_written::chaplygin_sleigh(reference.parameters, s.r(0), s.r(1)), reference, s);
}

TEST(hand_written, four_bar) {
  const oracle::system reference = oracle::load("four_bar");
  for (const oracle::state& s : reference.states)
    agrees(hand_written::four_bar(reference.parameters, s.r(0)), reference, s);
}

TEST(hand_written, pendulum) {
  const oracle::system reference = oracle::load("pendulum_nonminimal");
  for (const oracle::state& s : reference.states)
    agrees(hand_written::pendulum_nonminimal(reference.parameters), reference, s);
}

TEST(hand_written, disc) {
  const oracle::system reference = oracle::load("rolling_disc");
  for (const oracle::state& s : reference.states)
    agrees(hand_written::rolling_disc(reference.parameters), reference, s);
}

TEST(hand_written, torus) {
  const oracle::system reference = oracle::load("rolling_torus");
  for (const oracle::state& s : reference.states)
    agrees(hand_written::rolling_torus(reference.parameters), reference, s);
}

TEST(hand_written, bicycle) {
  const oracle::system reference = oracle::load("bicycle_whipple");
  for (const oracle::state& s : reference.states)
    agrees(hand_written::bicycle(reference.parameters), reference, s);
}

} // namespace
