// builds: g++
#include "systems/check_against_oracle.hpp"

#include <models/n_pendulum_cart.hpp>

namespace {

using system = n_pendulum_cart::System<5>;

TEST(n_pendulum_cart, agrees_with_the_oracle) { check::against_oracle<system>("npendulum_cart_n5"); }
TEST(n_pendulum_cart, energy_rate_is_power) { check::energy_rate_is_power<system>("npendulum_cart_n5"); }

} // namespace
