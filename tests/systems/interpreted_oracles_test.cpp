// builds: clang++
// Every system with a reference, derived at run time.
#include "systems/interpreted.hpp"

#include <models/arm3.hpp>
#include <models/bicycle.hpp>
#include <models/chaplygin_sleigh.hpp>
#include <models/double_pendulum.hpp>
#include <models/four_bar.hpp>
#include <models/iiwa.hpp>
#include <models/n_pendulum_cart.hpp>
#include <models/pendulum_nonminimal.hpp>
#include <models/pivot_body.hpp>
#include <models/puma.hpp>
#include <models/quadruped.hpp>
#include <models/rocket.hpp>
#include <models/rolling_disc.hpp>
#include <models/rolling_torus.hpp>
#include <models/rotating_tube.hpp>
#include <models/simple_pendulum.hpp>
#include <models/spinning_top.hpp>

namespace {

using kanexpr::derive;

TEST(interpreted, systems_agree_with_the_oracles) {
  using check::interpreted_against_oracle;
  interpreted_against_oracle(derive<simple_pendulum::System>(), "simple_pendulum");
  interpreted_against_oracle(derive<double_pendulum::System>(), "double_pendulum");
  interpreted_against_oracle(derive<n_pendulum_cart::System<5>>(), "npendulum_cart_n5");
  interpreted_against_oracle(derive<arm3::System>(), "arm3_spatial");
  interpreted_against_oracle(derive<spinning_top::System>(), "spinning_top");
  interpreted_against_oracle(derive<pivot_body::System>(), "quaternion_pivot_body");
  interpreted_against_oracle(derive<rocket::System>(), "rocket_variable_mass");
  interpreted_against_oracle(derive<rotating_tube::System>(), "rotating_tube");
  interpreted_against_oracle(derive<rolling_disc::System>(), "rolling_disc", false);
  interpreted_against_oracle(derive<rolling_torus::System>(), "rolling_torus");
}

TEST(interpreted, constrained_systems_agree_with_the_oracles) {
  using check::interpreted_against_oracle;
  interpreted_against_oracle(derive<pendulum_nonminimal::System>(), "pendulum_nonminimal");
  interpreted_against_oracle(derive<chaplygin_sleigh::System>(), "chaplygin_sleigh");
  interpreted_against_oracle(derive<four_bar::System>(), "four_bar");
  interpreted_against_oracle(derive<bicycle::System>(), "bicycle_whipple");
  interpreted_against_oracle(derive<bicycle::BoundSystem>(), "bicycle_whipple");
}

TEST(interpreted, robots_agree_with_the_oracles) {
  using check::interpreted_robot_against_oracle;
  interpreted_robot_against_oracle(derive<iiwa::System>(), "arm_iiwa");
  interpreted_robot_against_oracle(derive<puma::System>(), "arm_puma_full");
  interpreted_robot_against_oracle(derive<quadruped::System>(), "quadruped_anymal", check::floating_base);
}

} // namespace
