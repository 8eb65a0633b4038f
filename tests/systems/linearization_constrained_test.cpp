// Linearizations of systems with constraints, compared with the oracles and with complex steps at random
// operating points that satisfy the constraints.
#include "systems/linearized.hpp"

#include <models/bicycle.hpp>
#include <models/chaplygin_sleigh.hpp>
#include <models/four_bar.hpp>
#include <models/pendulum_nonminimal.hpp>
#include <models/rolling_disc_constrained.hpp>

namespace {

using check::linearization_agrees;
using check::VectorXd;

TEST(linearization, bicycle) {
  linearization_agrees<bicycle::System>("bicycle_whipple", VectorXd::Zero(10), 0.6);
}
TEST(linearization, four_bar) {
  linearization_agrees<four_bar::System>("four_bar", VectorXd{{0.9, -0.6, -1.2, 0, 0, 0}}, 0.5);
}
TEST(linearization, chaplygin_sleigh) {
  linearization_agrees<chaplygin_sleigh::System>("chaplygin_sleigh", VectorXd::Zero(6), 3);
}
TEST(linearization, pendulum_nonminimal) {
  linearization_agrees<pendulum_nonminimal::System>("pendulum_nonminimal", VectorXd{{1, 0, 0, 0}}, 0.5);
}

} // namespace
