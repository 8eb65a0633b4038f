// builds: clang++ all
// Second derivatives of weighted rates for the examples that the other test omits.
#include "runtime/second_order.hpp"

#include <models/andrews.hpp>
#include <models/arm3.hpp>
#include <models/arm6.hpp>
#include <models/bicycle.hpp>
#include <models/chaplygin_sleigh.hpp>
#include <models/cornering_car.hpp>
#include <models/n_pendulum_cart.hpp>
#include <models/pendulum6.hpp>
#include <models/pendulum_nonminimal.hpp>
#include <models/puma.hpp>
#include <models/quadruped.hpp>
#include <models/rattleback.hpp>
#include <models/rolling_disc.hpp>
#include <models/rolling_torus.hpp>
#include <models/rotating_tube.hpp>
#include <models/simple_pendulum.hpp>
#include <models/spinning_top.hpp>
#include <models/stick_slip.hpp>

namespace {

using namespace to_second_order;

template <class System>
void expect_of(double reach = 1) {
  expect_second_order(derivatives(kanexpr::derive<System>()), reach);
}

TEST(second_order_of, andrews) { expect_of<andrews::System>(); }
TEST(second_order_of, arm3) { expect_of<arm3::System>(); }
TEST(second_order_of, arm6) { expect_of<arm6::System>(); }
TEST(second_order_of, bicycle) { expect_of<bicycle::System>(); }
TEST(second_order_of, chaplygin_sleigh) { expect_of<chaplygin_sleigh::System>(); }
TEST(second_order_of, cornering_car) { expect_of<cornering_car::System>(0.1); }
TEST(second_order_of, n_pendulum_cart) { expect_of<n_pendulum_cart::System<3>>(); }
TEST(second_order_of, pendulum6) { expect_of<pendulum6::System>(); }
TEST(second_order_of, pendulum_nonminimal) { expect_of<pendulum_nonminimal::System>(); }
TEST(second_order_of, puma) { expect_of<puma::System>(); }
TEST(second_order_of, quadruped) { expect_of<quadruped::System>(); }
TEST(second_order_of, rattleback) { expect_of<rattleback::System>(); }
TEST(second_order_of, rolling_disc) { expect_of<rolling_disc::System>(); }
TEST(second_order_of, rolling_torus) { expect_of<rolling_torus::System>(); }
TEST(second_order_of, rotating_tube) { expect_of<rotating_tube::System>(); }
TEST(second_order_of, simple_pendulum) { expect_of<simple_pendulum::System>(); }
TEST(second_order_of, spinning_top) { expect_of<spinning_top::System>(); }
TEST(second_order_of, stick_slip) { expect_of<stick_slip::System>(); }

} // namespace
